// shadow_tint.frag: optical depth per channel of glass and blended surfaces in a light's view, summed over all faces in any order:
// of a face its reflectance, its half of the tint, and absorption as the coefficient times the distance to it, negative for front
// faces: over a closed body that is the length inside.
// Limits   no refraction: no focusing, and lengths inside are those of straight lines.
#version 450
#include "interface/frame.glsl"
#include "interface/material.glsl"
#include "stages/material_features.glsl"

layout(location = 0) in vec3 inPosition;
layout(location = 1) in vec3 inNormal;
layout(location = 2) in vec4 inTangent;
layout(location = 3) in vec4 inColor;
layout(location = 4) in vec4 inUv01;
layout(location = 5) in vec4 inUv23;

layout(location = 0) out vec4 outDepth;

#include "bsdf/fresnel_dielectric.glsl"
#include "stages/surface.glsl"

const float BLACK = 1e-6; // transmittance that is taken for 0

void main() {
    vec4 base = surfaceBaseColor();
    if (alphaMode == 1 && base.w < material.emissive.w) discard;
    float coverage = alphaMode == 2 ? base.w : 1.0;
    vec3 passed = vec3(1.0 - coverage);
    vec3 absorbed = vec3(0.0);
    if (transmission > 0) {
        Surface s = readSurface(base);
        float kept = fresnelTransmittedAt(dot(s.n, s.wo), material.surface.w);
        vec3 face = vec3(s.transmission * (1.0 - s.metallic));
        // Facets that face each other keep light between them: 45 % of alpha of both faces together, as what neighbours pass.
        float rough = 1.0 - 0.45 * s.alpha;
        if (transmission == 1) {
            face *= s.baseColor * rough * kept / (2.0 - kept); // all orders of reflection between its two sides
        } else {
            face *= sqrt(s.baseColor * rough) * kept;
            float way = ofPixel(frame.eye.w) > 0.0 ? distance(frame.eye.xyz, inPosition) : dot(frame.viewDirection.xyz, inPosition);
            if (attenuates) absorbed = material.attenuation.xyz * (gl_FrontFacing ? -way : way);
            coverage = 1.0; // alpha of solids: tinted where they are there at all
            passed = vec3(0.0);
        }
        passed += coverage * face;
    }
    outDepth = vec4(absorbed - log(max(passed, vec3(BLACK))), 0.0);
}
