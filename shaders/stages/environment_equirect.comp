// environment_equirect.comp: the equirectangular picture -> the sharp level of the cube, through a Gaussian 0.6 of a pixel wide.
// Why a Gaussian: point samples would lose or double a sun of one pixel. Every pixel is worth its solid angle times
// a balance, which makes up for the crowding of pixels at the poles (app/environment/zonal.h).
#version 450
#include "environment/cube.glsl"
#include "interface/environment_step.glsl"
#include "stages/half_float.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 1) uniform sampler2D equirect; // rgb radiance, a: balance at the cube's corners (corner_balance.h)
layout(binding = 2) uniform sampler2D rows; // height x 1: sine and cosine of theta, solid angle of a pixel, balanced
layout(binding = 3, rgba16f) uniform writeonly imageCube result;

const float PI = 3.14159265358979323846;
const float REACH = 4.0; // sigma: past it 0.03 % of the kernel is cut off, the same from all sides

void main() {
    ivec3 texel = ivec3(gl_GlobalInvocationID);
    int size = environmentStep.sizes.x;
    ivec2 pixels = environmentStep.sizes.zw;
    if (texel.x >= size || texel.y >= size) return;
    vec3 d = cubeTexelDirection(texel.z, texel.x, texel.y, size);

    float sigma = environmentStep.kernel.x;
    float inverse = 0.5 / (sigma * sigma);
    float radius = REACH * sigma;
    float sinHalf = sin(0.5 * radius);
    float chord2Limit = 4.0 * sinHalf * sinHalf;
    // Not acos(d.y): it keeps 3e-4 rad of the angle at the poles.
    float sinTheta = sqrt(d.x * d.x + d.z * d.z);
    float theta = atan(sinTheta, d.y);
    float column = (atan(d.z, d.x) / (2.0 * PI) + 0.5) * float(pixels.x) - 0.5;
    float rowStep = PI / float(pixels.y);
    float columnStep = 2.0 * PI / float(pixels.x);
    float stepCos = cos(columnStep);
    float stepSin = sin(columnStep);

    vec3 sum = vec3(0.0);
    float total = 0.0;
    int firstRow = max(int(ceil((theta - radius) / rowStep - 0.5)), 0);
    int lastRow = min(int(floor((theta + radius) / rowStep - 0.5)), pixels.y - 1);
    for (int row = firstRow; row <= lastRow; row++) {
        vec3 ring = texelFetch(rows, ivec2(row, 0), 0).xyz;
        float rowSin = ring.x;
        float rowCos = ring.y;
        float weight = ring.z;
        vec2 across = vec2(sinTheta - rowSin, d.y - rowCos);
        // chord² = across² + 4 sin θ sin θ' sin²(Δφ/2). On the axis (sin θ = 0) every column is near enough.
        float room = (chord2Limit - dot(across, across)) / max(4.0 * sinTheta * rowSin, 1e-20);
        if (room <= 0.0) continue;
        int reach = room >= 1.0 ? pixels.x / 2 : int(ceil(2.0 * asin(sqrt(room)) / columnStep));
        int first = int(round(column)) - reach;
        int count = min(2 * reach + 1, pixels.x);
        float phi = (float(first) + 0.5) * columnStep - PI;
        float c = cos(phi);
        float s = sin(phi);
        int x = first - pixels.x * int(floor(float(first) / float(pixels.x)));
        for (int k = 0; k < count; k++) {
            vec3 apart = d - vec3(rowSin * c, rowCos, rowSin * s);
            float chord2 = dot(apart, apart);
            float w = chord2 > chord2Limit ? 0.0 : weight * exp(-chord2 * inverse);
            vec4 pixel = texelFetch(equirect, ivec2(x, row), 0);
            w *= pixel.w;
            sum += w * pixel.xyz;
            total += w;
            float turned = c * stepCos - s * stepSin;
            s = s * stepCos + c * stepSin;
            c = turned;
            x = x + 1 == pixels.x ? 0 : x + 1;
        }
    }
    imageStore(result, texel, vec4(roundToHalfRgb(sum / total), 1.0));
}
