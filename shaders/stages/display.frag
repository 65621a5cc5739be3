// display.frag: linear radiance as a window shows it, a second picture from some column on, and the outline of what is picked.
#version 450
#include "color/srgb.glsl"
#include "color/tonemap.glsl"
#include "interface/display.glsl"

// Constants, for software devices run both sides of a branch.
layout(constant_id = 0) const int toneCurve = 1; // 0 none, 1 neutral, 2 ACES, 3 AgX
layout(constant_id = 1) const bool hasOther = false;
layout(constant_id = 2) const bool hasOutline = false;
layout(constant_id = 3) const bool isEncoded = false; // the picture, by this stage at its own size

layout(binding = 1) uniform sampler2D pictureColor;
layout(binding = 2) uniform sampler2D otherColor;
layout(binding = 3) uniform sampler2D pickedOutline;

layout(location = 0) out vec4 outColor;

vec3 toneMapped(vec3 radiance) {
    if (toneCurve == 1) return tonemapNeutral(radiance);
    if (toneCurve == 2) return tonemapAces(radiance);
    if (toneCurve == 3) return tonemapAgx(radiance);
    return clamp(radiance, 0.0, 1.0);
}

vec3 encoded(vec3 radiance) { return srgbFromLinearRgb(toneMapped(radiance)); }

void main() {
    vec2 at = gl_FragCoord.xy;
    vec2 size = display.area.xy;
    if (at.x >= size.x || at.y >= size.y) {
        outColor = display.around;
        return;
    }
    vec2 uv = at / size;
    bool other = hasOther && at.x >= display.other.z * size.x;
    if (hasOther && display.other.w > 0.5) uv.x = other ? uv.x - 0.25 : uv.x + 0.25;
    vec3 color = textureLod(pictureColor, uv, 0.0).xyz * display.picture.x;
    if (hasOther && other) color = textureLod(otherColor, uv, 0.0).xyz * display.other.x;
    if (!isEncoded) color = hasOther && other && display.other.y > 0.5 ? color : encoded(color);
    if (hasOther && abs(at.x - display.other.z * size.x) < 1.0 && display.other.z > 0.0 && display.other.z < 1.0) color = vec3(1.0);
    if (hasOutline) color = mix(color, vec3(1.0, 0.62, 0.16), textureLod(pickedOutline, uv, 0.0).x);
    outColor = vec4(color, 1.0);
}
