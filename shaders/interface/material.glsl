// material.glsl: the numbers of one material. One text for GLSL and C++ (app/uniforms/blocks.h).
// What a material does not use is switched off by the specialization constants of stages/material_features.glsl, not by
// values here.

struct MaterialData {
    vec4 baseColor;         // linear, w: coverage
    vec4 emissive;          // xyz: radiance; w: alpha cutoff
    vec4 surface;           // x: metallic, y: roughness, z: alpha where given directly, w: ior
    vec4 specular;          // xyz: colour, w: strength (KHR_materials_specular)
    vec4 conductorN;        // xyz: complex index n - i k per channel
    vec4 conductorK;
    vec4 transmission;      // x: factor, y: width of D where light leaves a solid, -1 if that of the front, z: dispersion,
                            // w: the material's number
    vec4 attenuation;       // xyz: absorption per metre; w: thickness in mesh units
    vec4 clearcoat;         // x: factor, y: roughness
    vec4 anisotropy;        // x: strength; y, z: cosine and sine of its rotation
    vec4 film;              // x: factor, y: ior; z, w: thickness where its map is 0 and where it is 1, nanometres
    vec4 diffuseTransmission; // xyz: colour; w: factor
    // KHR_texture_transform of each map: uv' = (row0 . (u, v, 1), row1 . (u, v, 1)); row1.w: scale or strength.
    vec4 baseColorRow0;
    vec4 baseColorRow1;
    vec4 metallicRoughnessRow0;
    vec4 metallicRoughnessRow1;
    vec4 normalRow0;
    vec4 normalRow1;
    vec4 occlusionRow0;
    vec4 occlusionRow1;
    vec4 emissiveRow0;
    vec4 emissiveRow1;
    vec4 specularRow0;
    vec4 specularRow1;
    vec4 specularColorRow0;
    vec4 specularColorRow1;
    vec4 transmissionRow0;
    vec4 transmissionRow1;
    vec4 thicknessRow0;
    vec4 thicknessRow1;
    vec4 clearcoatRow0;
    vec4 clearcoatRow1;
    vec4 clearcoatRoughnessRow0;
    vec4 clearcoatRoughnessRow1;
    vec4 clearcoatNormalRow0;
    vec4 clearcoatNormalRow1;
    vec4 anisotropyRow0;
    vec4 anisotropyRow1;
    vec4 iridescenceRow0;
    vec4 iridescenceRow1;
    vec4 iridescenceThicknessRow0;
    vec4 iridescenceThicknessRow1;
    vec4 diffuseTransmissionRow0;
    vec4 diffuseTransmissionRow1;
    vec4 diffuseTransmissionColorRow0;
    vec4 diffuseTransmissionColorRow1;
};

#ifndef __cplusplus
layout(std140, binding = 2) uniform Material {
    MaterialData material;
};
#endif
