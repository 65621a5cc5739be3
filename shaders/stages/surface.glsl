// surface.glsl: the material's parameters at a fragment, from its factors and maps.
// Frame    world, metres; directions unit and away from the surface.
// Needs    the inputs of opaque.vert, interface/frame.glsl, interface/material.glsl, stages/material_features.glsl.
// Source   glTF 2.0 §3.9 and the extensions named at each line.
#include "bsdf/ggx_anisotropic.glsl"
#include "stages/of_pixel.glsl"
#include "stages/picture_pixel.glsl"

layout(binding = 8) uniform sampler2D baseColorMap;
layout(binding = 9) uniform sampler2D metallicRoughnessMap;
layout(binding = 10) uniform sampler2D normalMap;
layout(binding = 11) uniform sampler2D occlusionMap;
layout(binding = 12) uniform sampler2D emissiveMap;
layout(binding = 13) uniform sampler2D specularMap;
layout(binding = 14) uniform sampler2D specularColorMap;
layout(binding = 15) uniform sampler2D transmissionMap;
layout(binding = 21) uniform sampler2D thicknessMap;
layout(binding = 43) uniform sampler2D anisotropyMap;
layout(binding = 44) uniform sampler2D iridescenceMap;
layout(binding = 45) uniform sampler2D iridescenceThicknessMap;
layout(binding = 46) uniform sampler2D diffuseTransmissionMap;
layout(binding = 47) uniform sampler2D diffuseTransmissionColorMap;

#include "stages/brushed_glass.glsl"

struct Surface {
    vec3 position;
    vec3 wo;           // to the viewer
    vec3 n;            // shading normal, on wo's side: dot(n, wo) >= 0
    vec3 baseColor;
    float metallic;
    float alpha;       // width of D
    vec3 specularColor;
    float specular;
    float transmission; // share of the dielectric's base that is refracted
    float occlusion;
    float hollow;      // share of the cosine lobe about n that meets the mesh itself
    vec3 emissive;
    float turn;        // turnOverPixel of the mirror's direction
    vec3 brush;        // KHR_materials_anisotropy: unit, in the surface, along the brushing; width of D along it. alpha: across
    float along;
    vec3 level;        // of brushed glass: n before it leans along the brushing (stages/brushed_glass.glsl); n elsewhere
    float across;      // and the width across it
    float facets;      // what the facets of this sample weigh, in what passes and in what is reflected; 1 elsewhere
    float mirrors;
    float filmShare;   // KHR_materials_iridescence
    float filmThickness; // nanometres
    vec3 passedColor;  // KHR_materials_diffuse_transmission: of the base's light that comes out on the other side
    float passedShare;
};

// Of glass whose shading is deferred, where a map says it: what the first interior layer holds. Negative: none.
float layerAlpha = -1.0;

vec2 mapUv(int uvPlusOne, vec4 row0, vec4 row1) {
    vec2 uv = uvPlusOne == 1 ? inUv01.xy : uvPlusOne == 2 ? inUv01.zw : uvPlusOne == 3 ? inUv23.xy : inUv23.zw;
    vec3 at = vec3(uv, 1.0);
    return vec2(dot(row0.xyz, at), dot(row1.xyz, at));
}

vec4 surfaceBaseColor() {
    vec4 color = material.baseColor;
    if (baseColorMapUv > 0)
        color *= texture(baseColorMap, mapUv(baseColorMapUv, material.baseColorRow0, material.baseColorRow1));
    if (hasVertexColor) color *= inColor;
    return color;
}

// Metallic and glTF's roughness.
vec2 surfaceMetal() {
    vec2 metal = material.surface.xy;
    if (metallicRoughnessMapUv > 0)
        metal *= texture(metallicRoughnessMap,
                         mapUv(metallicRoughnessMapUv, material.metallicRoughnessRow0, material.metallicRoughnessRow1)).zy;
    return metal;
}

float surfaceOcclusion() {
    if (occlusionMapUv == 0) return 1.0;
    float map = texture(occlusionMap, mapUv(occlusionMapUv, material.occlusionRow0, material.occlusionRow1)).x;
    return 1.0 + material.occlusionRow1.w * (map - 1.0);
}

vec3 surfaceEmissive() {
    vec3 emissive = material.emissive.xyz;
    if (emissiveMapUv > 0)
        emissive *= texture(emissiveMap, mapUv(emissiveMapUv, material.emissiveRow0, material.emissiveRow1)).xyz;
    return emissive;
}

// The interpolated normal, bent by a normal map's texel. MikkTSpace: the basis is interpolated and used as it arrives, neither made
// unit nor orthogonal, because that is what the map was baked for.
vec3 bentNormal(vec3 bend, float scale) {
    vec3 bitangent = inTangent.w * cross(inNormal, inTangent.xyz);
    return scale * bend.x * inTangent.xyz + scale * bend.y * bitangent + bend.z * inNormal;
}

vec3 unitNormal(vec3 n, bool front) {
    if (!front) n = -n; // glTF: a back face's normal is turned before lighting
    float s = dot(n, n);
    return s > 0.0 ? n * inversesqrt(s) : vec3(0.0, 0.0, 1.0);
}

vec3 surfaceNormal(bool front) {
    vec3 n = inNormal;
    if (normalMapUv > 0)
        n = bentNormal(texture(normalMap, mapUv(normalMapUv, material.normalRow0, material.normalRow1)).xyz * 2.0 - 1.0,
                       material.normalRow1.w);
    return unitNormal(n, front);
}

// KHR_materials_anisotropy: direction and strength of the brushing.
void readBrushing(inout Surface s) {
    float strength = material.anisotropy.x;
    vec2 along = vec2(1.0, 0.0);
    if (anisotropyMapUv > 0) {
        vec3 map = texture(anisotropyMap, mapUv(anisotropyMapUv, material.anisotropyRow0, material.anisotropyRow1)).xyz;
        along = map.xy * 2.0 - 1.0;
        strength *= map.z;
    }
    along = mat2(material.anisotropy.y, material.anisotropy.z, -material.anisotropy.z, material.anisotropy.y) * along;
    vec3 world = along.x * inTangent.xyz + along.y * inTangent.w * cross(inNormal, inTangent.xyz);
    world -= dot(world, s.n) * s.n;
    float size = dot(world, world);
    // Where the map or the mesh says no direction, none is favoured.
    vec3 any = abs(s.n.x) > 0.5 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0);
    bool known = size > 0.0;
    s.brush = known ? world * inversesqrt(size) : normalize(cross(any, s.n));
    vec2 widths = ggxAnisoWidths(s.alpha, known ? strength : 0.0);
    s.along = widths.x;
    s.alpha = widths.y;
}

// Interpolated and mapped normals can turn away from a viewer who sees the surface. Microfacet theory has no answer
// there (G = 0: black fringes at silhouettes), so n moves by the least turn that makes it perpendicular to wo.
vec3 faceViewer(vec3 n, vec3 wo) {
    float c = dot(n, wo);
    return c >= 0.0 ? n : normalize(n - c * wo);
}

void leanAlongBrush(inout Surface s) {
    s.across = s.alpha;
    float ior = material.surface.w;
    float eta = seenFromWithin && !gl_FrontFacing ? 1.0 / ior : ior;
    BrushedFacets f = facetsOfSample(s.n, s.wo, s.brush, vec2(s.along, s.across), eta, false);
    s.n = faceViewer(f.n, s.wo);
    s.alpha = f.alpha;
    s.facets = f.weight;
    s.mirrors = f.mirrors;
}

// KHR_materials_iridescence.
void readFilm(inout Surface s) {
    s.filmShare = material.film.x;
    s.filmThickness = material.film.w;
    if (iridescenceMapUv > 0)
        s.filmShare *= texture(iridescenceMap, mapUv(iridescenceMapUv, material.iridescenceRow0, material.iridescenceRow1)).x;
    if (iridescenceThicknessMapUv > 0)
        s.filmThickness = mix(material.film.z, material.film.w,
                              texture(iridescenceThicknessMap,
                                      mapUv(iridescenceThicknessMapUv, material.iridescenceThicknessRow0, material.iridescenceThicknessRow1)).y);
    if (s.filmThickness <= 0.0) s.filmShare = 0.0;
}

// KHR_materials_diffuse_transmission.
void readDiffuseTransmission(inout Surface s) {
    s.passedColor = material.diffuseTransmission.xyz;
    s.passedShare = material.diffuseTransmission.w;
    if (diffuseTransmissionMapUv > 0)
        s.passedShare *= texture(diffuseTransmissionMap, mapUv(diffuseTransmissionMapUv, material.diffuseTransmissionRow0,
                                                               material.diffuseTransmissionRow1)).w;
    if (diffuseTransmissionColorMapUv > 0)
        s.passedColor *= texture(diffuseTransmissionColorMap,
                                 mapUv(diffuseTransmissionColorMapUv, material.diffuseTransmissionColorRow0,
                                       material.diffuseTransmissionColorRow1)).xyz;
}

// By how much a direction turns over what one sample shows of the pixel: the variance per axis, radians². Without it
// small lamps would be met or missed by chance. More than a quarter of a radian from pixel to pixel is mostly an edge, not
// curvature: it counts as a quarter.
const float STEEPEST_TURN = 0.25;

float turnOverPixel(vec3 direction) {
    vec3 x = dFdx(direction);
    vec3 y = dFdy(direction);
    float apart = float(pixelStep());
    return frame.part.w * min(0.5 * (dot(x, x) + dot(y, y)) / (apart * apart), STEEPEST_TURN * STEEPEST_TURN);
}

Surface readSurface(vec4 base) {
    Surface s;
    s.position = inPosition;
    s.baseColor = base.xyz;
    s.wo = ofPixel(frame.eye.w) > 0.0 ? normalize(frame.eye.xyz - inPosition) : -frame.viewDirection.xyz;
    s.n = faceViewer(surfaceNormal(gl_FrontFacing), s.wo);

    vec2 metal = surfaceMetal();
    s.metallic = metal.x;
    s.alpha = alphaIsGiven ? material.surface.z : layerAlpha >= 0.0 ? layerAlpha : metal.y * metal.y;

    s.specular = material.specular.w; // KHR_materials_specular
    s.specularColor = material.specular.xyz;
    if (specularMapUv > 0)
        s.specular *= texture(specularMap, mapUv(specularMapUv, material.specularRow0, material.specularRow1)).w;
    if (specularColorMapUv > 0)
        s.specularColor *=
            texture(specularColorMap, mapUv(specularColorMapUv, material.specularColorRow0, material.specularColorRow1)).xyz;

    s.transmission = 0.0;
    if (transmission > 0) s.transmission = material.transmission.x;
    if (transmissionMapUv > 0)
        s.transmission *=
            texture(transmissionMap, mapUv(transmissionMapUv, material.transmissionRow0, material.transmissionRow1)).x;

    s.hollow = 0.0;
    s.occlusion = surfaceOcclusion();
    s.emissive = surfaceEmissive();
    s.turn = turnOverPixel(reflect(-s.wo, s.n));
    s.level = s.n;
    s.facets = 1.0;
    s.mirrors = 1.0;
    if (brushing > 0) readBrushing(s);
    if (brushing > 0 && transmission > 0) leanAlongBrush(s);
    if (hasFilm) readFilm(s);
    if (passesDiffuse) readDiffuseTransmission(s);
    return s;
}

// KHR_materials_volume: mesh units.
float surfaceThickness() {
    float thickness = material.attenuation.w;
    if (thicknessMapUv > 0)
        thickness *= texture(thicknessMap, mapUv(thicknessMapUv, material.thicknessRow0, material.thicknessRow1)).y;
    return thickness;
}
