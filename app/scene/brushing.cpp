#include "scene/brushing.h"

#include "core/error.h"
#include "scene/tangents.h"

#include <algorithm>

namespace gg::scene {
namespace {

Index add(Scene& scene, Stream stream) {
  scene.streams.push_back(std::move(stream));
  return static_cast<Index>(scene.streams.size()) - 1;
}

const Stream& at(const Scene& scene, Index index) {
  return scene.streams[static_cast<std::size_t>(index)];
}

// The stream's values of these vertices, as a stream of its own.
Index gathered(Scene& scene, Index index, const std::vector<std::uint32_t>& vertices) {
  const Stream& from = at(scene, index);
  const auto width = static_cast<std::size_t>(from.components);
  Stream to{from.components, std::vector<float>(vertices.size() * width)};
  for (std::size_t i = 0; i < vertices.size(); ++i)
    std::copy_n(from.values.data() + width * vertices[i], width, to.values.data() + width * i);
  return add(scene, std::move(to));
}

void add_tangents(Scene& scene, Primitive& p) {
  const Indices& indices = scene.indices[static_cast<std::size_t>(p.indices)];
  const auto corners = corner_tangents(at(scene, p.positions).values, at(scene, p.normals).values,
                                       at(scene, p.uvs.front()).values, indices);
  Split split = split_vertices(indices, corners);
  for (Index* index : {&p.positions, &p.normals, &p.colors})
    if (*index != none) *index = gathered(scene, *index, split.source);
  for (Index& uv : p.uvs)
    if (uv != none) uv = gathered(scene, uv, split.source);
  p.tangents = add(scene, {4, std::move(split.tangents)});
  scene.indices.push_back(std::move(split.indices));
  p.indices = static_cast<Index>(scene.indices.size()) - 1;
}

} // namespace

void complete_brushing(Scene& scene) {
  for (Mesh& mesh : scene.meshes)
    for (Primitive& p : mesh.primitives) {
      const Material& m = scene.materials[static_cast<std::size_t>(p.material)];
      if (!(m.anisotropy_strength > 0.0f) || p.tangents != none) continue;
      if (!p.uvs.empty() && p.uvs.front() != none)
        add_tangents(scene, p);
      else
        note("material '" + m.name + "' is brushed, and mesh '" + mesh.name
             + "' has no texture coordinates that say which way: drawn without brushing");
    }
}

} // namespace gg::scene
