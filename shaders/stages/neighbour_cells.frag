// neighbour_cells.frag: in which cells the values of neighbour_light.frag can be interpolated.
// Writes   xy the mean normal (octEncode), z the number of the region; 0 where the four corners do not agree.
// Form     lobes must turn little between corners beside their width, so that no outline falls between these. Then second
//          differences along each side of the cell, with the corners beyond both ends, as a share of what the surface sends: the
//          error of interpolation is an eighth of that where values are smooth, half where they jump. Where a side has no corner of
//          the region beyond an end: the first difference.
#version 450
#include "interface/frame.glsl"
#include "interface/region.glsl"
#include "neighbours/lobe_share.glsl"
#include "refraction/exit_surface.glsl"
#include "stages/of_pixel.glsl"

layout(binding = 8) uniform usampler2D geometry;
layout(binding = 51) uniform sampler2D neighbourIrradiance;
layout(binding = 52) uniform sampler2D neighbourReflected;
layout(binding = 53) uniform sampler2D neighbourSent;

layout(location = 0) out vec4 outCell;

const float MOST_BEND = 0.1;  // of what the surface sends: an error of an eightieth where values are smooth
const float MOST_TURN = 2.0;  // of the lobe's sigma: by how much mirror directions may differ between opposite corners
const float MOST_STEP = 0.25; // of the way between two corners: how far another may lie off the plane of one's normal

struct Corner {
    vec4 irradiance; // w: the number of the region
    vec3 reflected;
    vec3 sent;
};

Corner cornerAt(ivec2 at) {
    ivec2 inside = clamp(at, ivec2(0), textureSize(neighbourSent, 0) - 1);
    Corner c;
    c.irradiance = texelFetch(neighbourIrradiance, inside, 0);
    c.reflected = texelFetch(neighbourReflected, inside, 0).xyz;
    c.sent = texelFetch(neighbourSent, inside, 0).xyz;
    return c;
}

float largest(vec3 v) { return max(abs(v.x), max(abs(v.y), abs(v.z))); }

bool bendsLittle(Corner a, Corner b, Corner c) {
    bool ends = c.irradiance.w != b.irradiance.w;
    vec3 irradiance = ends ? a.irradiance.xyz - b.irradiance.xyz : a.irradiance.xyz - 2.0 * b.irradiance.xyz + c.irradiance.xyz;
    vec3 reflected = ends ? a.reflected - b.reflected : a.reflected - 2.0 * b.reflected + c.reflected;
    return b.sent.x * largest(irradiance) + b.sent.y * largest(reflected) <= MOST_BEND * b.sent.z;
}

// Between the second and the third of four corners in a row.
bool sideAgrees(ivec2 second, ivec2 step) {
    Corner b = cornerAt(second);
    Corner c = cornerAt(second + step);
    return bendsLittle(c, b, cornerAt(second - step)) && bendsLittle(b, c, cornerAt(second + 2 * step));
}

void main() {
    ivec2 low = ivec2(gl_FragCoord.xy);
    float number = texelFetch(neighbourIrradiance, low, 0).w;
    bool agrees = number > 0.0;
    InteriorView camera = interiorView(frame.clipFromWorld, frame.worldFromClip, frame.picture.xy);
    vec3 normals[4];
    vec3 points[4];
    vec3 mirrors[4];
    float sigma = LEAST_LOBE; // an outline is no sharper
    vec3 mean = vec3(0.0);
    for (int k = 0; k < 4; ++k) {
        ivec2 at = low + ivec2(k & 1, k >> 1);
        agrees = agrees && texelFetch(neighbourIrradiance, at, 0).w == number;
        ivec2 pixel = min(at * CELL_STEP, ivec2(frame.picture.xy) - 1);
        uvec4 texel = texelFetch(geometry, pixel, 0);
        normals[k] = octDecode(vec2(uintBitsToFloat(texel.y), uintBitsToFloat(texel.z)));
        points[k] = interiorWorld(camera, vec2(pixel) + 0.5, uintBitsToFloat(texel.x));
        vec3 view = ofPixel(frame.eye.w) > 0.0 ? normalize(points[k] - frame.eye.xyz) : frame.viewDirection.xyz;
        mirrors[k] = reflect(view, normals[k]);
        sigma = max(sigma, texelFetch(neighbourReflected, at, 0).w);
        mean += normals[k];
    }
    mean = normalize(mean);
    for (int k = 0; k < 4; ++k) {
        vec3 way = points[k] - points[3 - k];
        agrees = agrees && dot(normals[k], mean) > CELL_COSINE && abs(dot(way, normals[k])) <= MOST_STEP * length(way) &&
                 length(mirrors[k] - mirrors[3 - k]) <= MOST_TURN * sigma;
    }
    // A loop: devices that run pixels in lockstep leave it out where no cell agrees so far.
    for (int k = 0; k < 4 && agrees; ++k) {
        ivec2 step = (k & 1) == 0 ? ivec2(1, 0) : ivec2(0, 1);
        agrees = sideAgrees(low + (k >> 1) * (1 - step), step);
    }
    outCell = agrees ? vec4(octEncode(mean), number, 0.0) : vec4(0.0);
}
