// environment_equirect.comp: the equirectangular picture -> the sharp level of the cube, through a Gaussian 0.6 of a pixel wide.
// Why a Gaussian: point samples would lose or double a sun of one pixel. Every pixel is worth its solid angle times
// a balance, which makes up for the crowding of pixels at the poles (app/environment/zonal.h).
#version 450
#include "bsdf/constants.glsl"
#include "interface/environment_step.glsl"
#include "stages/environment_weigh.glsl"
#include "stages/half_float.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 1) uniform sampler2D equirect; // rgb radiance, a: balance at the cube's corners (corner_balance.h)
// Row 0, of the picture's rows: sine and cosine of theta, solid angle of a pixel, balanced. Row 1, of its columns: cosine and sine
// of phi. Row 2: those of the step from one column to the next (app/environment/equirect_lattice.h).
layout(binding = 2) uniform sampler2D rows;
layout(binding = 3, rgba16f) uniform writeonly imageCube result;

const float PI = 3.14159265358979323846;

void main() {
    ivec3 id = ivec3(gl_GlobalInvocationID);
    ivec2 at = 2 * id.xy;
    int size = environmentStep.sizes.x;
    ivec2 pixels = environmentStep.sizes.zw;
    if (at.x >= size || at.y >= size) return;
    Quad own = quad(id.z, at, size);
    vec3 d = own.centre;

    float limit = environmentStep.kernel.y;
    float inverse = environmentStep.kernel.z;
    // What any of the four may reach, its chord taken for as long as the angle.
    float cap = environmentStep.kernel.x + own.spread;
    // Not acos(d.y): it keeps 3e-4 rad of the angle at the poles.
    float sinTheta = sqrt(d.x * d.x + d.z * d.z);
    float theta = atan(sinTheta, d.y);
    float column = (atan(d.z, d.x) / (2.0 * PI) + 0.5) * float(pixels.x) - 0.5;
    float rowStep = PI / float(pixels.y);
    vec2 turn = texelFetch(rows, ivec2(0, 2), 0).xy;

    vec4 red = vec4(0.0);
    vec4 green = vec4(0.0);
    vec4 blue = vec4(0.0);
    vec4 total = vec4(0.0);
    int firstRow = max(int(ceil((theta - cap) / rowStep - 0.5)), 0);
    int lastRow = min(int(floor((theta + cap) / rowStep - 0.5)), pixels.y - 1);
    for (int row = firstRow; row <= lastRow; row++) {
        vec3 ring = texelFetch(rows, ivec2(row, 0), 0).xyz;
        float rowSin = ring.x;
        float rowCos = ring.y;
        float weight = ring.z;
        vec2 across = vec2(sinTheta - rowSin, d.y - rowCos);
        // chord² = across² + 4 sin θ sin θ' sin²(Δφ/2). On the axis (sin θ = 0) every column is near enough.
        float room = (cap * cap - dot(across, across)) / max(4.0 * sinTheta * rowSin, LEAST_DIVISOR);
        if (room <= 0.0) continue;
        // Δφ in columns, and 0.01 more than atan may be off. asin(x) <= x + (π/2 - 1) x³.
        float reach = 0.01 + sqrt(room) * (1.0 + 0.570797 * room) / PI * float(pixels.x);
        bool whole = room >= 1.0 || 2.0 * reach >= float(pixels.x);
        int x = whole ? 0 : int(ceil(column - reach));
        int count = whole ? pixels.x : int(floor(column + reach)) - x + 1;
        x = x < 0 ? x + pixels.x : x >= pixels.x ? x - pixels.x : x;
        vec2 azimuth = texelFetch(rows, ivec2(x, 1), 0).xy;
        float c = azimuth.x;
        float s = azimuth.y;
        for (int k = 0; k < count; k++) {
            vec4 chord2 = quadChord2(own, vec3(rowSin * c, rowCos, rowSin * s));
            vec4 pixel = texelFetch(equirect, ivec2(x, row), 0);
            vec4 w = weight * pixel.w * exp(-chord2 * inverse);
            w = mix(w, vec4(0.0), greaterThan(chord2, vec4(limit)));
            red += w * pixel.x;
            green += w * pixel.y;
            blue += w * pixel.z;
            total += w;
            float turned = c * turn.x - s * turn.y;
            s = s * turn.x + c * turn.y;
            c = turned;
            x = x + 1 == pixels.x ? 0 : x + 1;
        }
    }
    red = roundToHalfFour(red / total);
    green = roundToHalfFour(green / total);
    blue = roundToHalfFour(blue / total);
    for (int k = 0; k < 4; k++) imageStore(result, ivec3(quadTexel(at, k), id.z), vec4(red[k], green[k], blue[k], 1.0));
    weighQuad(ivec3(at, id.z), size, environmentStep.sizes.y, red, green, blue);
}
