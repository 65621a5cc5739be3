// glTF 2.0, chapter 5 ("Properties reference"), and the extensions that are read, as a table.
#include "scene/gltf/rule.h"

#include <climits>

namespace gg::scene::gltf {
namespace {

using enum Kind;

constexpr double one = factor;
constexpr double half_turn = 3.14159274, quarter_turn = 1.57079637; // as rounded to 32 bits
constexpr double positive = FLT_MIN;

constexpr Rule texture_transform[] = {
    {.key = "offset", .kind = numbers, .size = 2},
    {.key = "rotation", .kind = number},
    {.key = "scale", .kind = numbers, .size = 2},
    {.key = "texCoord", .kind = integer, .low = 0, .high = INT_MAX},
};
constexpr Rule texture_extensions[] = {
    {.key = "KHR_texture_transform", .kind = object, .members = texture_transform},
};
constexpr Rule texture_info[] = {
    {.key = "index", .kind = index, .required = true, .target = "/textures"},
    {.key = "texCoord", .kind = integer, .low = 0, .high = INT_MAX},
    {.key = "scale", .kind = number},
    {.key = "strength", .kind = number, .low = 0, .high = one},
    {.key = "extensions", .kind = object, .members = texture_extensions},
};

constexpr Rule emissive_strength[] = {{.key = "emissiveStrength", .kind = number, .low = 0}};
constexpr Rule ior[] = {{.key = "ior", .kind = number, .low = 0}};
constexpr Rule specular[] = {
    {.key = "specularFactor", .kind = number, .low = 0, .high = one},
    {.key = "specularTexture", .kind = object, .members = texture_info},
    {.key = "specularColorFactor", .kind = numbers, .low = 0, .size = 3},
    {.key = "specularColorTexture", .kind = object, .members = texture_info},
};
constexpr Rule transmission[] = {
    {.key = "transmissionFactor", .kind = number, .low = 0, .high = one},
    {.key = "transmissionTexture", .kind = object, .members = texture_info},
};
constexpr Rule volume[] = {
    {.key = "thicknessFactor", .kind = number, .low = 0},
    {.key = "thicknessTexture", .kind = object, .members = texture_info},
    {.key = "attenuationDistance", .kind = number, .low = positive},
    {.key = "attenuationColor", .kind = numbers, .low = 0, .high = one, .size = 3},
};
constexpr Rule dispersion[] = {{.key = "dispersion", .kind = number, .low = 0}};
constexpr Rule anisotropy[] = {
    {.key = "anisotropyStrength", .kind = number, .low = 0, .high = one},
    {.key = "anisotropyRotation", .kind = number},
    {.key = "anisotropyTexture", .kind = object, .members = texture_info},
};
constexpr Rule clearcoat[] = {
    {.key = "clearcoatFactor", .kind = number, .low = 0, .high = one},
    {.key = "clearcoatTexture", .kind = object, .members = texture_info},
    {.key = "clearcoatRoughnessFactor", .kind = number, .low = 0, .high = one},
    {.key = "clearcoatRoughnessTexture", .kind = object, .members = texture_info},
    {.key = "clearcoatNormalTexture", .kind = object, .members = texture_info},
};
constexpr Rule iridescence[] = {
    {.key = "iridescenceFactor", .kind = number, .low = 0, .high = one},
    {.key = "iridescenceTexture", .kind = object, .members = texture_info},
    {.key = "iridescenceIor", .kind = number, .low = 1},
    {.key = "iridescenceThicknessMinimum", .kind = number, .low = 0},
    {.key = "iridescenceThicknessMaximum", .kind = number, .low = 0},
    {.key = "iridescenceThicknessTexture", .kind = object, .members = texture_info},
};
constexpr Rule diffuse_transmission[] = {
    {.key = "diffuseTransmissionFactor", .kind = number, .low = 0, .high = one},
    {.key = "diffuseTransmissionTexture", .kind = object, .members = texture_info},
    {.key = "diffuseTransmissionColorFactor", .kind = numbers, .low = 0, .high = one, .size = 3},
    {.key = "diffuseTransmissionColorTexture", .kind = object, .members = texture_info},
};
constexpr Rule material_extensions[] = {
    {.key = "KHR_materials_emissive_strength", .kind = object, .members = emissive_strength},
    {.key = "KHR_materials_unlit", .kind = object},
    {.key = "KHR_materials_ior", .kind = object, .members = ior},
    {.key = "KHR_materials_specular", .kind = object, .members = specular},
    {.key = "KHR_materials_transmission", .kind = object, .members = transmission},
    {.key = "KHR_materials_volume", .kind = object, .members = volume},
    {.key = "KHR_materials_dispersion", .kind = object, .members = dispersion},
    {.key = "KHR_materials_anisotropy", .kind = object, .members = anisotropy},
    {.key = "KHR_materials_clearcoat", .kind = object, .members = clearcoat},
    {.key = "KHR_materials_iridescence", .kind = object, .members = iridescence},
    {.key = "KHR_materials_diffuse_transmission", .kind = object, .members = diffuse_transmission},
};
constexpr Rule metallic_roughness[] = {
    {.key = "baseColorFactor", .kind = numbers, .low = 0, .high = one, .size = 4},
    {.key = "baseColorTexture", .kind = object, .members = texture_info},
    {.key = "metallicFactor", .kind = number, .low = 0, .high = one},
    {.key = "roughnessFactor", .kind = number, .low = 0, .high = one},
    {.key = "metallicRoughnessTexture", .kind = object, .members = texture_info},
};
constexpr Rule material[] = {
    {.key = "name", .kind = string},
    {.key = "pbrMetallicRoughness", .kind = object, .members = metallic_roughness},
    {.key = "normalTexture", .kind = object, .members = texture_info},
    {.key = "occlusionTexture", .kind = object, .members = texture_info},
    {.key = "emissiveTexture", .kind = object, .members = texture_info},
    {.key = "emissiveFactor", .kind = numbers, .low = 0, .size = 3},
    {.key = "alphaMode", .kind = choice, .target = "OPAQUE MASK BLEND"},
    {.key = "alphaCutoff", .kind = number, .low = 0},
    {.key = "doubleSided", .kind = boolean},
    {.key = "extensions", .kind = object, .members = material_extensions},
};

constexpr Rule buffer[] = {
    {.key = "byteLength", .kind = integer, .required = true, .low = 1, .high = largest_integer},
    {.key = "uri", .kind = string},
};
constexpr Rule meshopt[] = {
    {.key = "buffer", .kind = index, .required = true, .target = "/buffers"},
    {.key = "byteOffset", .kind = integer, .low = 0, .high = largest_integer},
    {.key = "byteLength", .kind = integer, .required = true, .low = 1, .high = largest_integer},
    {.key = "byteStride", .kind = integer, .required = true, .low = 1, .high = 256},
    {.key = "count", .kind = integer, .required = true, .low = 1, .high = INT_MAX},
    {.key = "mode", .kind = choice, .required = true, .target = "ATTRIBUTES TRIANGLES INDICES"},
    {.key = "filter", .kind = choice, .target = "NONE OCTAHEDRAL QUATERNION EXPONENTIAL"},
};
constexpr Rule buffer_view_extensions[] = {
    {.key = "EXT_meshopt_compression", .kind = object, .members = meshopt},
};
constexpr Rule buffer_view[] = {
    {.key = "buffer", .kind = index, .required = true, .target = "/buffers"},
    {.key = "byteOffset", .kind = integer, .low = 0, .high = largest_integer},
    {.key = "byteLength", .kind = integer, .required = true, .low = 1, .high = largest_integer},
    {.key = "byteStride", .kind = integer, .low = 4, .high = 252},
    {.key = "extensions", .kind = object, .members = buffer_view_extensions},
};

constexpr Rule sparse_indices[] = {
    {.key = "bufferView", .kind = index, .required = true, .target = "/bufferViews"},
    {.key = "byteOffset", .kind = integer, .low = 0, .high = INT_MAX},
    {.key = "componentType", .kind = integer, .required = true, .low = 5120, .high = 5126},
};
constexpr Rule sparse_values[] = {
    {.key = "bufferView", .kind = index, .required = true, .target = "/bufferViews"},
    {.key = "byteOffset", .kind = integer, .low = 0, .high = INT_MAX},
};
constexpr Rule sparse[] = {
    {.key = "count", .kind = integer, .required = true, .low = 1, .high = INT_MAX},
    {.key = "indices", .kind = object, .required = true, .members = sparse_indices},
    {.key = "values", .kind = object, .required = true, .members = sparse_values},
};
constexpr Rule accessor[] = {
    {.key = "bufferView", .kind = index, .target = "/bufferViews"},
    {.key = "byteOffset", .kind = integer, .low = 0, .high = largest_integer},
    {.key = "componentType", .kind = integer, .required = true, .low = 5120, .high = 5126},
    {.key = "count", .kind = integer, .required = true, .low = 1, .high = largest_integer},
    {.key = "type",
     .kind = choice,
     .required = true,
     .target = "SCALAR VEC2 VEC3 VEC4 MAT2 MAT3 MAT4"},
    {.key = "normalized", .kind = boolean},
    {.key = "sparse", .kind = object, .members = sparse},
    {.key = "name", .kind = string},
};

constexpr Rule draco[] = {
    {.key = "bufferView", .kind = index, .required = true, .target = "/bufferViews"},
    {.key = "attributes", .kind = map, .required = true, .low = 0, .high = INT_MAX},
};
constexpr Rule primitive_extensions[] = {
    {.key = "KHR_draco_mesh_compression", .kind = object, .members = draco},
};
constexpr Rule primitive[] = {
    {.key = "attributes", .kind = map, .required = true, .target = "/accessors"},
    {.key = "indices", .kind = index, .target = "/accessors"},
    {.key = "material", .kind = index, .target = "/materials"},
    {.key = "mode", .kind = integer, .low = 0, .high = 6},
    {.key = "targets", .kind = maps, .target = "/accessors"},
    {.key = "extensions", .kind = object, .members = primitive_extensions},
};
constexpr Rule mesh[] = {
    {.key = "primitives", .kind = objects, .required = true, .members = primitive},
    {.key = "weights", .kind = numbers},
    {.key = "name", .kind = string},
};

constexpr Rule node_light[] = {
    {.key = "light",
     .kind = index,
     .required = true,
     .target = "/extensions/KHR_lights_punctual/lights"},
};
constexpr Rule node_extensions[] = {
    {.key = "KHR_lights_punctual", .kind = object, .members = node_light},
};
constexpr Rule node[] = {
    {.key = "name", .kind = string},
    {.key = "camera", .kind = index, .target = "/cameras"},
    {.key = "children", .kind = indices, .target = "/nodes"},
    {.key = "mesh", .kind = index, .target = "/meshes"},
    {.key = "skin", .kind = index, .target = "/skins"},
    {.key = "matrix", .kind = numbers, .size = 16},
    {.key = "rotation", .kind = numbers, .low = -one, .high = one, .size = 4},
    {.key = "scale", .kind = numbers, .size = 3},
    {.key = "translation", .kind = numbers, .size = 3},
    {.key = "weights", .kind = numbers},
    {.key = "extensions", .kind = object, .members = node_extensions},
};
constexpr Rule scene[] = {
    {.key = "nodes", .kind = indices, .target = "/nodes"},
    {.key = "name", .kind = string},
};
constexpr Rule skin[] = {
    {.key = "inverseBindMatrices", .kind = index, .target = "/accessors"},
    {.key = "joints", .kind = indices, .required = true, .target = "/nodes"},
    {.key = "skeleton", .kind = index, .target = "/nodes"},
    {.key = "name", .kind = string},
};

constexpr Rule target[] = {
    {.key = "node", .kind = index, .target = "/nodes"},
    {.key = "path", .kind = string, .required = true},
};
constexpr Rule channel[] = {
    {.key = "sampler", .kind = integer, .required = true, .low = 0, .high = INT_MAX},
    {.key = "target", .kind = object, .required = true, .members = target},
};
constexpr Rule keys[] = {
    {.key = "input", .kind = index, .required = true, .target = "/accessors"},
    {.key = "output", .kind = index, .required = true, .target = "/accessors"},
    {.key = "interpolation", .kind = choice, .target = "LINEAR STEP CUBICSPLINE"},
};
constexpr Rule animation[] = {
    {.key = "name", .kind = string},
    {.key = "channels", .kind = objects, .required = true, .members = channel},
    {.key = "samplers", .kind = objects, .required = true, .members = keys},
};

constexpr Rule texture_sources[] = {
    {.key = "source", .kind = index, .required = true, .target = "/images"},
};
constexpr Rule texture_kinds[] = {
    {.key = "EXT_texture_webp", .kind = object, .members = texture_sources},
    {.key = "KHR_texture_basisu", .kind = object, .members = texture_sources},
};
constexpr Rule texture[] = {
    {.key = "sampler", .kind = index, .target = "/samplers"},
    {.key = "source", .kind = index, .target = "/images"},
    {.key = "name", .kind = string},
    {.key = "extensions", .kind = object, .members = texture_kinds},
};
constexpr Rule image[] = {
    {.key = "uri", .kind = string},
    {.key = "mimeType", .kind = string},
    {.key = "bufferView", .kind = index, .target = "/bufferViews"},
    {.key = "name", .kind = string},
};
constexpr Rule sampler[] = {
    {.key = "magFilter", .kind = integer, .low = 9728, .high = 9729},
    {.key = "minFilter", .kind = integer, .low = 9728, .high = 9987},
    {.key = "wrapS", .kind = integer, .low = 10497, .high = 33648},
    {.key = "wrapT", .kind = integer, .low = 10497, .high = 33648},
};

constexpr Rule perspective[] = {
    {.key = "yfov", .kind = number, .required = true, .low = positive, .high = half_turn},
    {.key = "znear", .kind = number, .required = true, .low = 0},
    {.key = "zfar", .kind = number, .low = positive},
    {.key = "aspectRatio", .kind = number, .low = positive},
};
constexpr Rule orthographic[] = {
    {.key = "xmag", .kind = number, .required = true},
    {.key = "ymag", .kind = number, .required = true},
    {.key = "znear", .kind = number, .required = true, .low = 0},
    {.key = "zfar", .kind = number, .required = true, .low = positive},
};
constexpr Rule camera[] = {
    {.key = "type", .kind = choice, .required = true, .target = "perspective orthographic"},
    {.key = "perspective", .kind = object, .members = perspective},
    {.key = "orthographic", .kind = object, .members = orthographic},
    {.key = "name", .kind = string},
};

constexpr Rule spot[] = {
    {.key = "innerConeAngle", .kind = number, .low = 0, .high = quarter_turn},
    {.key = "outerConeAngle", .kind = number, .low = positive, .high = quarter_turn},
};
constexpr Rule light[] = {
    {.key = "type", .kind = choice, .required = true, .target = "directional point spot"},
    {.key = "name", .kind = string},
    {.key = "color", .kind = numbers, .low = 0, .size = 3},
    {.key = "intensity", .kind = number, .low = 0},
    {.key = "range", .kind = number, .low = positive},
    {.key = "spot", .kind = object, .members = spot},
};
constexpr Rule lights[] = {
    {.key = "lights", .kind = objects, .required = true, .members = light},
};
constexpr Rule root_extensions[] = {
    {.key = "KHR_lights_punctual", .kind = object, .members = lights},
};

constexpr Rule asset[] = {
    {.key = "version", .kind = string, .required = true},
    {.key = "minVersion", .kind = string},
};
constexpr Rule root[] = {
    {.key = "asset", .kind = object, .required = true, .members = asset},
    {.key = "extensionsUsed", .kind = strings},
    {.key = "extensionsRequired", .kind = strings},
    {.key = "buffers", .kind = objects, .members = buffer},
    {.key = "bufferViews", .kind = objects, .members = buffer_view},
    {.key = "accessors", .kind = objects, .members = accessor},
    {.key = "meshes", .kind = objects, .members = mesh},
    {.key = "nodes", .kind = objects, .members = node},
    {.key = "scenes", .kind = objects, .members = scene},
    {.key = "scene", .kind = index, .target = "/scenes"},
    {.key = "skins", .kind = objects, .members = skin},
    {.key = "materials", .kind = objects, .members = material},
    {.key = "textures", .kind = objects, .members = texture},
    {.key = "images", .kind = objects, .members = image},
    {.key = "samplers", .kind = objects, .members = sampler},
    {.key = "cameras", .kind = objects, .members = camera},
    {.key = "extensions", .kind = object, .members = root_extensions},
};

} // namespace

std::span<const Rule> schema() {
  return root;
}

std::span<const Rule> animation_rules() {
  return animation;
}

} // namespace gg::scene::gltf
