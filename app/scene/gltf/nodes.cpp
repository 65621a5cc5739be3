#include "scene/gltf/nodes.h"

#include "scene/gltf/fail.h"
#include "scene/gltf/values.h"

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include <cmath>

namespace gg::scene::gltf {
namespace {

glm::mat4 local_transform(const tinygltf::Node& node, const std::string& file,
                          const std::string& place) {
  glm::mat4 m(1.0f);
  if (!node.matrix.empty()) {
    for (int i = 0; i < 16; ++i)
      m[i / 4][i % 4] = static_cast<float>(node.matrix[static_cast<std::size_t>(i)]);
    const glm::vec4 last(m[0][3], m[1][3], m[2][3], m[3][3]), affine(0, 0, 0, 1);
    if (last == affine) return m;
    // Products and inverses of matrices in floats end a few roundings away from it.
    constexpr float rounding = 1e-5f;
    if (glm::any(glm::greaterThan(glm::abs(last - affine), glm::vec4(rounding))))
      fail(file, place + ".matrix", "has a last row other than 0 0 0 1");
    note(file + ": " + place
         + ".matrix has a last row that is 0 0 0 1 but for rounding; taken as that");
    for (int i = 0; i < 4; ++i)
      m[i][3] = affine[i];
    return m;
  }
  if (!node.translation.empty()) m = glm::translate(m, vector_of<3>(node.translation));
  if (!node.rotation.empty()) {
    const glm::vec4 r = vector_of<4>(node.rotation);
    const float length = glm::length(r);
    if (length == 0.0f) fail(file, place + ".rotation", "is a quaternion of length 0");
    m *= glm::mat4_cast(glm::quat(r.w / length, r.x / length, r.y / length, r.z / length));
  }
  if (!node.scale.empty()) m = glm::scale(m, vector_of<3>(node.scale));
  return m;
}

bool is_finite(const glm::mat4& m) {
  bool finite = true;
  for (int i = 0; i < 16; ++i)
    finite &= std::isfinite(m[i / 4][i % 4]);
  return finite;
}

// The parent of each node, or -1.
std::vector<int> parents(const Document& document) {
  const auto& nodes = document.model().nodes;
  std::vector<int> parent(nodes.size(), -1);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (const int child : nodes[i].children) {
      int& p = parent[static_cast<std::size_t>(child)];
      if (p >= 0)
        fail(document.name(), element("nodes", static_cast<int>(i)) + ".children",
             fmt::format("names node {}, which is a child of node {} already", child, p),
             "A node has one parent: export the file again.");
      p = static_cast<int>(i);
    }
  return parent;
}

// With one parent each, nodes that no root reaches form rings.
void check_no_ring(const Document& document, const std::vector<bool>& reached) {
  for (std::size_t i = 0; i < reached.size(); ++i)
    if (!reached[i])
      fail(document.name(), element("nodes", static_cast<int>(i)) + ".children",
           "leads back to the node itself", "A node cannot be its own ancestor.");
}

} // namespace

Hierarchy::Hierarchy(const Document& document) {
  const auto& model = document.model();
  const std::vector<int> parent = parents(document);
  worlds_.resize(model.nodes.size());
  std::vector<bool> reached(model.nodes.size(), false);

  // A list of things to do instead of recursion: a file may chain as many nodes as it likes.
  const auto descend = [&](int root, std::vector<Placed>* into) {
    std::vector<int> waiting{root};
    while (!waiting.empty()) {
      const int index = waiting.back();
      waiting.pop_back();
      const auto i = static_cast<std::size_t>(index);
      const tinygltf::Node& node = model.nodes[i];
      const std::string place = element("nodes", index);
      const glm::mat4 local = local_transform(node, document.name(), place);
      worlds_[i] = parent[i] < 0 ? local : world_of(parent[i]) * local;
      if (!is_finite(worlds_[i]))
        fail(document.name(), place, "its transform, with those of its parents, is not finite");
      reached[i] = true;
      if (into) into->push_back({index, worlds_[i]});
      waiting.insert(waiting.end(), node.children.rbegin(), node.children.rend());
    }
  };
  for (std::size_t i = 0; i < parent.size(); ++i)
    if (parent[i] < 0) descend(static_cast<int>(i), nullptr);
  check_no_ring(document, reached);

  std::vector<int> roots;
  if (model.scenes.empty())
    note(document.name() + ": has no scene; everything in it is drawn");
  else if (model.scenes.size() > 1 && model.defaultScene < 0)
    note(fmt::format("{}: has {} scenes and does not say which to show; the first is drawn",
                     document.name(), model.scenes.size()));
  if (!model.scenes.empty())
    roots = model.scenes[static_cast<std::size_t>(std::max(model.defaultScene, 0))].nodes;
  else
    for (std::size_t i = 0; i < parent.size(); ++i)
      if (parent[i] < 0) roots.push_back(static_cast<int>(i));
  std::vector<bool> listed(model.nodes.size(), false);
  for (const int root : roots) {
    const auto i = static_cast<std::size_t>(root);
    if (parent[i] >= 0 || listed[i])
      fail(document.name(), "scenes",
           fmt::format("names node {}, which is not a root, or twice", root),
           "A scene lists each of its root nodes once.");
    listed[i] = true;
    descend(root, &placed_);
  }
}

} // namespace gg::scene::gltf
