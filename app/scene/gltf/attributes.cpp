// Geometry, first half: attributes and indices as they stand in the file.
#include "scene/gltf/accessors.h"
#include "scene/gltf/fail.h"
#include "scene/gltf/geometry.h"
#include "scene/gltf/topology.h"

#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace gg::scene::gltf {
namespace {

int components_of(const std::string& attribute) {
  if (attribute == "POSITION" || attribute == "NORMAL") return 3;
  if (attribute.starts_with("TEXCOORD_")) return 2;
  return 4; // TANGENT, COLOR_n, JOINTS_n, WEIGHTS_n
}

// Unit normals: those of KHR_mesh_quantization are only roughly so. True if some are zero.
bool normalise_vectors(Stream& stream) {
  bool has_zero = false;
  const auto width = static_cast<std::size_t>(stream.components);
  for (std::size_t i = 0; i < stream.values.size(); i += width) {
    float* v = stream.values.data() + i;
    const glm::dvec3 d = glm::make_vec3(v);
    const double length = glm::length(d);
    has_zero |= length == 0.0;
    if (length > 0.0)
      for (int c = 0; c < 3; ++c)
        v[c] = static_cast<float>(d[c] / length);
    if (width == 4) v[3] = v[3] < 0.0f ? -1.0f : 1.0f;
  }
  return has_zero;
}

std::vector<float> with_opaque_alpha(const std::vector<float>& rgb) {
  std::vector<float> rgba;
  rgba.reserve(rgb.size() / 3 * 4);
  for (std::size_t i = 0; i + 2 < rgb.size(); i += 3)
    rgba.insert(rgba.end(), {rgb[i], rgb[i + 1], rgb[i + 2], 1.0f});
  return rgba;
}

const tinygltf::Value* draco_of(const tinygltf::Primitive& source) {
  const auto found = source.extensions.find("KHR_draco_mesh_compression");
  return found == source.extensions.end() ? nullptr : &found->second;
}

} // namespace

const DracoMesh* Geometry::draco(const tinygltf::Primitive& source, const std::string& place) {
  const tinygltf::Value* extension = draco_of(source);
  if (extension == nullptr) return nullptr;
  const int view = extension->Get("bufferView").GetNumberAsInt();
  auto& mesh = draco_[view];
  const std::string at = place + ".extensions.KHR_draco_mesh_compression";
  if (!mesh)
    mesh = std::make_unique<DracoMesh>(document_.view(view), document_.name(), at,
                                       [&](std::size_t bytes) { document_.afford(bytes, at); });
  return mesh.get();
}

Index Geometry::decode(const tinygltf::Primitive& source, const std::string& name, int index,
                       const std::string& place) {
  const auto& accessor = document_.model().accessors[static_cast<std::size_t>(index)];
  const int found = component_count(accessor);
  const int wanted = components_of(name);
  const bool is_rgb = name.starts_with("COLOR_") && found == 3;
  if (found != wanted && !is_rgb)
    fail(document_.name(), place + ".attributes." + name,
         fmt::format("has {} components where {} are needed", found, wanted));

  const DracoMesh* mesh = draco(source, place);
  const tinygltf::Value* extension = draco_of(source);
  const std::string attribute = name;
  Stream stream{found, {}};
  if (mesh && extension->Get("attributes").Has(attribute)) {
    document_.spend(mesh->point_count() * static_cast<std::size_t>(found) * sizeof(float), place);
    stream.values = mesh->floats(extension->Get("attributes").Get(attribute).GetNumberAsInt(),
                                 found, accessor.normalized, accessor.componentType);
  } else {
    stream.values = read_floats(document_, index);
  }
  if (is_rgb) stream = {4, with_opaque_alpha(stream.values)};
  const bool is_direction = name == "NORMAL" || name == "TANGENT";
  const bool has_zero = is_direction && normalise_vectors(stream);
  const Index result = add(std::move(stream));
  if (has_zero) (name == "NORMAL" ? zero_normals_ : zero_tangents_).insert(result);
  return result;
}

Index Geometry::stream(const tinygltf::Primitive& source, const std::string& name,
                       const std::string& place) {
  const auto found = source.attributes.find(name);
  if (found == source.attributes.end()) return none;
  // Streams that are read alike are shared, whatever they are used for.
  const std::string use = name == "NORMAL" || name == "TANGENT" ? name
                          : name.starts_with("COLOR_")          ? "COLOR"
                                                                : "";
  std::string id = fmt::format("{} {}", use, found->second);
  if (const tinygltf::Value* extension = draco_of(source);
      extension && extension->Get("attributes").Has(name))
    id = fmt::format("{} draco {} {} {}", use, extension->Get("bufferView").GetNumberAsInt(),
                     extension->Get("attributes").Get(name).GetNumberAsInt(), found->second);
  const auto known = streams_.find(id);
  if (known != streams_.end()) {
    if (const int width = at(known->second).components; width != components_of(name))
      fail(document_.name(), place + ".attributes." + name,
           fmt::format("has {} components where {} are needed", width, components_of(name)));
    return known->second;
  }
  return streams_.emplace(id, decode(source, name, found->second, place)).first->second;
}

std::vector<std::uint32_t> Geometry::triangles(const tinygltf::Primitive& source,
                                               std::size_t vertices, const std::string& place) {
  const auto mode = source.mode < 0 ? Mode::triangles : static_cast<Mode>(source.mode);
  if (const DracoMesh* mesh = draco(source, place)) return mesh->triangles();
  std::vector<std::uint32_t> corners;
  if (source.indices >= 0) {
    const auto& accessor = document_.model().accessors[static_cast<std::size_t>(source.indices)];
    if (component_count(accessor) != 1)
      fail(document_.name(), element("accessors", source.indices) + ".type",
           "must be SCALAR: it holds the indices of " + place);
    corners = read_integers(document_, source.indices);
  } else {
    document_.spend(vertices * sizeof(std::uint32_t), place);
    corners.resize(vertices);
    for (std::size_t i = 0; i < vertices; ++i)
      corners[i] = static_cast<std::uint32_t>(i);
  }
  if (mode != Mode::triangles) document_.spend(3 * corners.size() * sizeof(std::uint32_t), place);
  if (corners.size() < 3 || (mode == Mode::triangles && corners.size() % 3 != 0))
    note(document_.name() + ": " + place + " ends in an incomplete triangle, which is not drawn");
  return gltf::triangle_list(std::move(corners), mode);
}

Index Geometry::triangle_list(const tinygltf::Primitive& source, std::size_t vertices,
                              const std::string& place) {
  std::string id = fmt::format("{} {}", source.mode, source.indices);
  if (const tinygltf::Value* extension = draco_of(source))
    id = fmt::format("draco {}", extension->Get("bufferView").GetNumberAsInt());
  else if (source.indices < 0)
    id += fmt::format(" of {}", vertices);
  if (!indices_.contains(id)) {
    Indices list = triangles(source, vertices, place);
    largest_index_[id] = list.empty() ? 0 : *std::max_element(list.begin(), list.end());
    scene_.indices.push_back(std::move(list));
    indices_[id] = static_cast<Index>(scene_.indices.size()) - 1;
  }
  if (largest_index_[id] >= vertices)
    fail(document_.name(), place + ".indices",
         fmt::format("names vertex {}, and there are {}", largest_index_[id], vertices));
  return indices_[id];
}

void Geometry::read(const tinygltf::Primitive& source, const std::string& place, bool with_tangents,
                    Primitive& p) {
  p.positions = stream(source, "POSITION", place);
  p.normals = stream(source, "NORMAL", place);
  if (with_tangents) p.tangents = stream(source, "TANGENT", place);
  p.colors = stream(source, "COLOR_0", place);
  // Sets may have gaps: a material can name TEXCOORD_1 where there is no TEXCOORD_0.
  for (const auto& [name, accessor] : source.attributes) {
    constexpr std::string_view prefix = "TEXCOORD_";
    if (!name.starts_with(prefix)) continue;
    const std::string digits = name.substr(prefix.size());
    if (digits.size() != 1 || digits[0] < '0' || digits[0] > '9')
      continue; // no material uses more than the first ten
    const auto set = static_cast<std::size_t>(digits[0] - '0');
    if (p.uvs.size() <= set) p.uvs.resize(set + 1, none);
    p.uvs[set] = stream(source, name, place);
  }
  const std::size_t vertices = at(p.positions).count();
  const auto check_count = [&](Index index, const char* name) {
    if (index != none && at(index).count() != vertices)
      fail(document_.name(), place + ".attributes",
           fmt::format("has {} positions and {} {}", vertices, at(index).count(), name));
  };
  check_count(p.normals, "normals");
  check_count(p.tangents, "tangents");
  check_count(p.colors, "colours");
  for (const Index uv : p.uvs)
    check_count(uv, "texture coordinates");
  p.indices = triangle_list(source, vertices, place);
}

} // namespace gg::scene::gltf
