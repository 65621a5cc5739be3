#include "scene/gltf/geometry.h"

#include "scene/gltf/fail.h"
#include "scene/gltf/topology.h"
#include "scene/normals.h"
#include "scene/tangents.h"

#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>

namespace gg::scene::gltf {
namespace {

// What a built primitive depends on, besides its material.
std::string key(const tinygltf::Primitive& source, const std::optional<TangentFrame>& frame,
                const Pose& pose) {
  std::string text = fmt::format("{} {}", source.mode, source.indices);
  for (const auto& [name, accessor] : source.attributes)
    if (!name.starts_with('_')) // an application's own
      text += fmt::format(" {}={}", name, accessor);
  if (const auto draco = source.extensions.find("KHR_draco_mesh_compression");
      draco != source.extensions.end())
    text += fmt::format(" draco={}", draco->second.Get("bufferView").GetNumberAsInt());
  if (frame) {
    text += fmt::format(" uv={}", frame->uv_set);
    for (int i = 0; i < 9; ++i)
      text += fmt::format(",{}", glm::value_ptr(frame->transform)[i]);
  }
  for (const auto& target : source.targets)
    for (const auto& [name, accessor] : target)
      text += fmt::format(" target {}={}", name, accessor);
  for (const double weight : pose.weights)
    text += fmt::format(" weight={}", weight);
  return text;
}

// Distances are squared on the way to the screen, and squares must stay floats: 1e18² = 1e36.
constexpr float largest_coordinate = 1e18f;

Bounds bounds_of(const Stream& positions, const Indices& indices) {
  Bounds bounds;
  for (const std::uint32_t i : indices)
    bounds.include(glm::make_vec3(positions.values.data() + 3 * std::size_t{i}));
  return bounds;
}

std::vector<Index*> streams_of(Primitive& p) {
  std::vector<Index*> all{&p.positions, &p.normals, &p.tangents, &p.colors};
  for (Index& uv : p.uvs)
    all.push_back(&uv);
  std::erase_if(all, [](const Index* i) { return *i == none; });
  return all;
}

} // namespace

std::optional<TangentFrame> tangent_frame(const Material& material) {
  for (const Slot* slot :
       {&material.normal_map, &material.clearcoat_normal_map, &material.anisotropy_map})
    if (*slot) return TangentFrame{slot->uv_set, slot->transform};
  if (material.anisotropy_strength > 0.0f) return TangentFrame{};
  return std::nullopt;
}

bool Pose::empty() const {
  return joints.empty()
         && std::all_of(weights.begin(), weights.end(), [](double w) { return w == 0.0; });
}

Index Geometry::add(Stream stream) {
  scene_.streams.push_back(std::move(stream));
  return static_cast<Index>(scene_.streams.size()) - 1;
}

std::optional<Primitive> Geometry::build(const tinygltf::Primitive& source,
                                         const std::string& place,
                                         const std::optional<TangentFrame>& frame,
                                         const Pose& pose) {
  const auto mode = source.mode < 0 ? Mode::triangles : static_cast<Mode>(source.mode);
  if (!is_drawn(mode)) {
    note("points and lines are not drawn");
    return std::nullopt;
  }
  if (!source.attributes.contains("POSITION")) {
    note(document_.name() + ": " + place + " has no positions and is not drawn");
    return std::nullopt;
  }
  const std::string name = key(source, frame, pose);
  const bool is_shared = pose.joints.empty(); // a skin's matrices are its own
  if (const auto known = primitives_.find(name); is_shared && known != primitives_.end())
    return known->second;

  Primitive result;
  read(source, place, frame.has_value(), result);
  if (!pose.empty()) {
    morph(source, place, pose.weights, result);
    if (!pose.joints.empty()) skin(source, place, pose.joints, result);
  }
  for (const float x : at(result.positions).values)
    if (!(std::abs(x) <= largest_coordinate))
      fail(document_.name(), place + ".attributes.POSITION",
           fmt::format("reaches {}; coordinates end at {} m", x, largest_coordinate));
  complete_normals(place, result);
  if (frame) complete_tangents(*frame, place, result);
  // Not memory but time: a file must not have one long list walked by thousands of primitives.
  document_.spend(scene_.indices[static_cast<std::size_t>(result.indices)].size() * sizeof(Index),
                  place);
  result.bounds =
      bounds_of(at(result.positions), scene_.indices[static_cast<std::size_t>(result.indices)]);
  if (is_shared) primitives_.emplace(name, result);
  return result;
}

// Flat normals where there are none (glTF 2.0 §3.7.2.1), which gives each corner a vertex of its
// own.
void Geometry::complete_normals(const std::string& place, Primitive& p) {
  const Indices& indices = scene_.indices[static_cast<std::size_t>(p.indices)];
  if (p.normals == none) {
    p.tangents = none; // glTF: without normals, tangents are to be ignored
    document_.spend(indices.size() * 3 * sizeof(float), place);
    Stream normals{3, flat_normals(at(p.positions).values, indices)};
    const std::vector<std::uint32_t> corners = indices;
    gather(corners, place, p);
    p.normals = add(std::move(normals));
    Indices identity(corners.size());
    for (std::size_t i = 0; i < identity.size(); ++i)
      identity[i] = static_cast<std::uint32_t>(i);
    scene_.indices.push_back(std::move(identity));
    p.indices = static_cast<Index>(scene_.indices.size()) - 1;
  } else if (zero_normals_.contains(p.normals)) {
    note(document_.name() + ": " + place + " has normals of zero length; mended from its faces");
    document_.spend(at(p.normals).values.size() * sizeof(float), place);
    Stream mended = at(p.normals);
    mend_zero_normals(mended.values, at(p.positions).values, indices);
    p.normals = add(std::move(mended));
  }
}

void Geometry::complete_tangents(const TangentFrame& frame, const std::string& place,
                                 Primitive& p) {
  const auto set = static_cast<std::size_t>(frame.uv_set);
  if (p.tangents != none && zero_tangents_.contains(p.tangents)) {
    note(document_.name() + ": " + place
         + " has tangents of zero length; generated from its texture coordinates");
    p.tangents = none;
  }
  if (p.tangents != none || set >= p.uvs.size() || p.uvs[set] == none) return;
  const Indices& indices = scene_.indices[static_cast<std::size_t>(p.indices)];
  document_.spend(indices.size() * sizeof(glm::vec4), place);

  std::vector<float> uvs = at(p.uvs[set]).values;
  for (std::size_t i = 0; i + 1 < uvs.size(); i += 2) {
    const glm::vec3 uv = frame.transform * glm::vec3(uvs[i], uvs[i + 1], 1.0f);
    uvs[i] = uv.x, uvs[i + 1] = uv.y;
  }
  const auto corners = corner_tangents(at(p.positions).values, at(p.normals).values, uvs, indices);
  Split split = split_vertices(indices, corners);
  gather(split.source, place, p);
  p.tangents = add({4, std::move(split.tangents)});
  scene_.indices.push_back(std::move(split.indices));
  p.indices = static_cast<Index>(scene_.indices.size()) - 1;
}

// Replaces every stream of the primitive by one with the given vertices.
void Geometry::gather(const std::vector<std::uint32_t>& vertices, const std::string& place,
                      Primitive& p) {
  for (Index* index : streams_of(p)) {
    const auto width = static_cast<std::size_t>(at(*index).components);
    document_.spend(vertices.size() * width * sizeof(float), place);
    Stream gathered{at(*index).components, std::vector<float>(vertices.size() * width)};
    const float* from = at(*index).values.data();
    for (std::size_t i = 0; i < vertices.size(); ++i)
      std::copy_n(from + width * vertices[i], width, gathered.values.data() + width * i);
    *index = add(std::move(gathered));
  }
}

} // namespace gg::scene::gltf
