// material_features.glsl: what a material uses, as specialization constants, so that a draw pays for nothing else.
// Numbers   the same as in app/needs/features.h.
// Maps      the constant of a map is 0 where there is none, else 1 + the set of texture coordinates that it reads.

layout(constant_id = 0) const int baseColorMapUv = 0;
layout(constant_id = 1) const int metallicRoughnessMapUv = 0;
layout(constant_id = 2) const int normalMapUv = 0;
layout(constant_id = 3) const int occlusionMapUv = 0;
layout(constant_id = 4) const int emissiveMapUv = 0;
layout(constant_id = 5) const int specularMapUv = 0;
layout(constant_id = 6) const int specularColorMapUv = 0;
layout(constant_id = 7) const bool hasVertexColor = false;
layout(constant_id = 8) const int alphaMode = 0;       // 0 opaque, 1 mask, 2 blend
layout(constant_id = 9) const int shading = 0;         // 0 unlit, 1 dielectric, 2 metal, 3 both mixed by metallic, 4 conductor
layout(constant_id = 10) const int distribution = 0;   // 0 GGX, 1 Beckmann, 2 Phong
layout(constant_id = 11) const bool correlatedSmith = false;
layout(constant_id = 12) const int method = 1;         // 0 standard, K: K lobes, 100 + N: N importance samples
layout(constant_id = 13) const bool hasEnvironment = true;
layout(constant_id = 14) const int lighting = 0;       // 0 no punctual lights, 1 without shadow maps, 2 with, 3 tinted by glass too
layout(constant_id = 15) const bool alphaIsGiven = false; // material.surface.z in place of roughness²
layout(constant_id = 16) const bool multipleScattering = false;
layout(constant_id = 17) const bool schlickDielectric = false; // KHR_materials_specular tints: F0 is a colour
layout(constant_id = 18) const int uvSets = 0;          // how many sets of texture coordinates the maps read
layout(constant_id = 19) const int transmission = 0;    // 0 none, 1 thin-walled, 2 solid
layout(constant_id = 20) const int transmissionMapUv = 0;
layout(constant_id = 21) const int thicknessMapUv = 0;
layout(constant_id = 22) const bool disperses = false;
layout(constant_id = 23) const bool indexIsOne = false; // bends and reflects nothing
layout(constant_id = 24) const bool attenuates = false; // absorbs along the way inside
layout(constant_id = 51) const bool hasNeighbours = false; // reflections look up the pyramid: there is more than one body
layout(constant_id = 25) const bool holdsOpaque = false; // something that is in the depth reaches into the box around the solid
layout(constant_id = 27) const int lobeCount = 1; // that the table of the reflection lobe holds
layout(constant_id = 28) const bool seenFromWithin = false; // back faces of the solid can be what the camera sees
layout(constant_id = 29) const bool isSmooth = false; // alpha 0 on every face: nothing scatters, no table is read
layout(constant_id = 30) const int neighbourKinds = 0; // around it: 1 spheres, 2 rectangles, 4 some of glass, 8 some opaque
layout(constant_id = 31) const int ownProxy = 0; // the proxy of the draw's own body: 0 none, 1 a sphere, 2 a rectangle
layout(constant_id = 32) const bool hasCoat = false; // KHR_materials_clearcoat
layout(constant_id = 33) const int clearcoatMapUv = 0;
layout(constant_id = 34) const int clearcoatRoughnessMapUv = 0;
layout(constant_id = 35) const int clearcoatNormalMapUv = 0;
layout(constant_id = 36) const int brushing = 0; // KHR_materials_anisotropy: lobes in place of the stretched one; 1: glass
layout(constant_id = 37) const int anisotropyMapUv = 0;
layout(constant_id = 38) const bool hasFilm = false; // KHR_materials_iridescence
layout(constant_id = 39) const int iridescenceMapUv = 0;
layout(constant_id = 40) const int iridescenceThicknessMapUv = 0;
layout(constant_id = 41) const bool facesDiffer = false; // base colour or clear share vary over the faces of a solid
layout(constant_id = 42) const bool passesDiffuse = false; // KHR_materials_diffuse_transmission
layout(constant_id = 43) const int diffuseTransmissionMapUv = 0;
layout(constant_id = 44) const int diffuseTransmissionColorMapUv = 0;
layout(constant_id = 45) const bool hasHollows = false; // vertices hold the share of their cosine lobe that meets their own mesh
layout(constant_id = 46) const bool interpolatesNeighbours = false; // stages/neighbour_light.glsl
layout(constant_id = 26) const int interiorPairs = 0; // of front and back faces that the inside is followed through

const bool hasLights = lighting != 0;
const bool gathersLight = (neighbourKinds != 0 && method < 100) || hasEnvironment; // fisN samples the environment alone
const int brushedLobes = transmission > 0 ? 0 : brushing; // glass: stages/brushed_glass.glsl
