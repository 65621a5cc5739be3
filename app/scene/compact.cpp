#include "scene/compact.h"

#include <glm/gtc/type_ptr.hpp>

namespace gg::scene {
namespace {

template <class Item>
class Keeper {
public:
  explicit Keeper(std::vector<Item>& items) : items_(items), place_(items.size(), none) {}
  void keep(Index& index) {
    if (index == none) return;
    Index& place = place_[static_cast<std::size_t>(index)];
    if (place == none) {
      place = static_cast<Index>(kept_.size());
      kept_.push_back(std::move(items_[static_cast<std::size_t>(index)]));
    }
    index = place;
  }
  void finish() { items_ = std::move(kept_); }

private:
  std::vector<Item>& items_;
  std::vector<Item> kept_;
  std::vector<Index> place_;
};

// A matrix that maps boxes along the axes to such boxes: one non-zero number per row and column.
bool keeps_boxes(const glm::mat4& m) {
  for (int i = 0; i < 3; ++i) {
    int in_row = 0, in_column = 0;
    for (int j = 0; j < 3; ++j) {
      in_row += m[j][i] != 0.0f;
      in_column += m[i][j] != 0.0f;
    }
    if (in_row > 1 || in_column > 1) return false;
  }
  return true;
}

void include_box(Bounds& bounds, const glm::mat4& world, const Bounds& box) {
  for (int i = 0; i < 8; ++i)
    bounds.include(
        glm::vec3(world
                  * glm::vec4(i & 1 ? box.high.x : box.low.x, i & 2 ? box.high.y : box.low.y,
                              i & 4 ? box.high.z : box.low.z, 1.0f)));
}

// `patience` is the number of corners that may still be looked at one by one.
void include(Bounds& bounds, const glm::mat4& world, const Scene& scene, const Primitive& p,
             std::size_t& patience) {
  if (p.bounds.empty()) return;
  const Indices& indices = scene.indices[static_cast<std::size_t>(p.indices)];
  if (keeps_boxes(world) || indices.size() > patience) {
    include_box(bounds, world, p.bounds);
    return;
  }
  patience -= indices.size();
  const float* positions = scene.streams[static_cast<std::size_t>(p.positions)].values.data();
  for (const std::uint32_t i : indices)
    bounds.include(
        glm::vec3(world * glm::vec4(glm::make_vec3(positions + 3 * std::size_t{i}), 1.0f)));
}

} // namespace

void compact(Scene& scene) {
  Keeper streams(scene.streams);
  Keeper indices(scene.indices);
  for (Mesh& mesh : scene.meshes)
    for (Primitive& p : mesh.primitives) {
      for (Index* index : {&p.positions, &p.normals, &p.tangents, &p.colors})
        streams.keep(*index);
      for (Index& uv : p.uvs)
        streams.keep(uv);
      indices.keep(p.indices);
    }
  streams.finish();
  indices.finish();
}

Bounds world_bounds(const Scene& scene) {
  Bounds bounds;
  std::size_t patience = 50'000'000; // about 0.2 s
  for (const Instance& instance : scene.instances)
    for (const Primitive& p : scene.meshes[static_cast<std::size_t>(instance.mesh)].primitives)
      include(bounds, instance.world, scene, p, patience);
  return bounds;
}

} // namespace gg::scene
