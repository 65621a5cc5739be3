// Geometry, second half: morph targets and skins, applied to the vertices as they stand.
#include "scene/gltf/accessors.h"
#include "scene/gltf/fail.h"
#include "scene/gltf/geometry.h"

#include <fmt/format.h>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace gg::scene::gltf {
namespace {

void normalise(float* v) {
  const glm::vec3 d = glm::make_vec3(v);
  const float length = glm::length(d);
  for (int c = 0; c < 3 && length > 0.0f; ++c)
    v[c] = d[c] / length;
}

Index* member(Primitive& p, const std::string& name) {
  if (name == "POSITION") return &p.positions;
  if (name == "NORMAL") return &p.normals;
  if (name == "TANGENT") return &p.tangents;
  if (name == "COLOR_0") return &p.colors;
  for (std::size_t set = 0; set < p.uvs.size(); ++set)
    if (name == fmt::format("TEXCOORD_{}", set)) return &p.uvs[set];
  return nullptr;
}

// The inverse transpose up to a positive factor, which also exists where the matrix is singular:
// its cofactors, with the sign of the determinant.
glm::mat3 normal_matrix(const glm::mat3& m) {
  const glm::mat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
  return glm::dot(m[0], cofactors[0]) < 0.0f ? -cofactors : cofactors;
}

} // namespace

// glTF 2.0 §3.7.2.2: base plus the weighted sum of the targets; of tangents only xyz moves.
void Geometry::morph(const tinygltf::Primitive& source, const std::string& place,
                     const std::vector<double>& weights, Primitive& p) {
  std::set<Index> own; // streams copied for this primitive
  for (std::size_t t = 0; t < std::min(weights.size(), source.targets.size()); ++t) {
    if (weights[t] == 0.0) continue;
    for (const auto& [name, accessor] : source.targets[t]) {
      Index* index = member(p, name);
      if (index == nullptr || *index == none) continue;
      const std::string where = fmt::format("{}.targets[{}].{}", place, t, name);
      if (!own.contains(*index)) {
        document_.spend(at(*index).values.size() * sizeof(float), where);
        const bool had_zero = zero_normals_.contains(*index);
        Stream copy = at(*index);
        *index = add(std::move(copy));
        if (had_zero) zero_normals_.insert(*index);
        own.insert(*index);
      }
      Stream& stream = at(*index);
      const std::vector<float> offsets = read_floats(document_, accessor);
      const auto width = static_cast<std::size_t>(
          component_count(document_.model().accessors[static_cast<std::size_t>(accessor)]));
      const auto full = static_cast<std::size_t>(stream.components);
      if (width > full || offsets.size() / width != stream.count())
        fail(document_.name(), where,
             fmt::format("has {} elements of {} components for {} vertices of {}",
                         offsets.size() / width, width, stream.count(), full));
      for (std::size_t i = 0; i < offsets.size(); ++i)
        stream.values[i / width * full + i % width] += static_cast<float>(weights[t]) * offsets[i];
    }
  }
  for (const Index index : {p.normals, p.tangents})
    if (own.contains(index))
      for (std::size_t i = 0; i < at(index).count(); ++i)
        normalise(at(index).values.data() + i * static_cast<std::size_t>(at(index).components));
}

// §3.7.3.3: each vertex goes where the weighted sum of its joints' matrices takes it, to the world;
// the node's own transform does not matter. Weights are divided by their sum, which exporters
// guarantee only to rounding.
void Geometry::skin(const tinygltf::Primitive& source, const std::string& place,
                    const std::vector<glm::mat4>& joints, Primitive& p) {
  const std::size_t vertices = at(p.positions).count();
  document_.spend(vertices * (sizeof(glm::mat4) + 10 * sizeof(float)), place);
  std::vector<glm::mat4> matrices(vertices, glm::mat4(0.0f));
  std::vector<float> sums(vertices, 0.0f);
  for (int set = 0;; ++set) {
    const auto joint_accessor = source.attributes.find(fmt::format("JOINTS_{}", set));
    const auto weight_name = fmt::format("WEIGHTS_{}", set);
    if (joint_accessor == source.attributes.end() || !source.attributes.contains(weight_name))
      break;
    const std::string joint_name = joint_accessor->first;
    const Index name_stream = stream(source, joint_name, place);
    const Index weight_stream = stream(source, weight_name, place);
    const Stream& names = at(name_stream);
    const Stream& weights = at(weight_stream);
    if (names.count() != vertices || weights.count() != vertices)
      fail(document_.name(), place + ".attributes",
           fmt::format("has {} positions and another number of joints or weights", vertices));
    for (std::size_t i = 0; i < names.values.size(); ++i) {
      const float weight = weights.values[i], joint = names.values[i];
      if (weight == 0.0f) continue;
      if (!(joint >= 0.0f && joint < static_cast<float>(joints.size())))
        fail(document_.name(), place + ".attributes." + joint_name,
             fmt::format("names joint {}, and the skin has {}", joint, joints.size()));
      matrices[i / 4] += weight * joints[static_cast<std::size_t>(joint)];
      sums[i / 4] += weight;
    }
  }
  Stream positions = at(p.positions);
  std::optional<Stream> normals, tangents;
  if (p.normals != none) normals = at(p.normals);
  if (p.tangents != none) tangents = at(p.tangents);
  for (std::size_t i = 0; i < vertices; ++i) {
    const glm::mat4 m = sums[i] > 0.0f ? matrices[i] / sums[i] : joints.front();
    float* v = positions.values.data() + 3 * i;
    const glm::vec4 moved = m * glm::vec4(glm::make_vec3(v), 1.0f);
    std::copy_n(glm::value_ptr(moved), 3, v);
    const auto turn = [&](std::optional<Stream>& stream, const glm::mat3& by) {
      if (!stream) return;
      float* d = stream->values.data() + i * static_cast<std::size_t>(stream->components);
      const glm::vec3 turned = by * glm::make_vec3(d);
      std::copy_n(glm::value_ptr(turned), 3, d);
      normalise(d);
    };
    turn(normals, normal_matrix(glm::mat3(m)));
    turn(tangents, glm::mat3(m));
  }
  const bool had_zero = zero_normals_.contains(p.normals);
  p.positions = add(std::move(positions));
  if (normals) p.normals = add(std::move(*normals));
  if (tangents) p.tangents = add(std::move(*tangents));
  if (had_zero) zero_normals_.insert(p.normals);
}

} // namespace gg::scene::gltf
