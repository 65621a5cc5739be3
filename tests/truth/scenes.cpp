#include "truth/scenes.h"

#include <cmath>
#include <numbers>

namespace gg::truth::test {
namespace {

using scene::Index;
using scene::Scene;

struct Shape {
  scene::Stream positions{.components = 3}, normals{.components = 3};
  scene::Stream uvs{.components = 2}; // if it has any
  scene::Indices indices;
  scene::Bounds bounds;

  std::uint32_t corner(glm::vec3 p, glm::vec3 n) {
    for (int c = 0; c < 3; ++c) {
      positions.values.push_back(p[c]);
      normals.values.push_back(n[c]);
    }
    bounds.include(p);
    return static_cast<std::uint32_t>(positions.count() - 1);
  }
};

void add(Scene& scene, const scene::Material& material, const Shape& shape) {
  scene::Primitive primitive;
  primitive.positions = static_cast<Index>(scene.streams.size());
  primitive.normals = primitive.positions + 1;
  primitive.indices = static_cast<Index>(scene.indices.size());
  primitive.material = static_cast<Index>(scene.materials.size());
  primitive.bounds = shape.bounds;
  scene.streams.push_back(shape.positions);
  scene.streams.push_back(shape.normals);
  if (shape.uvs.count() > 0) {
    primitive.uvs = {static_cast<Index>(scene.streams.size())};
    scene.streams.push_back(shape.uvs);
  }
  scene.indices.push_back(shape.indices);
  scene.materials.push_back(material);
  scene.instances.push_back({.mesh = static_cast<Index>(scene.meshes.size())});
  scene.meshes.push_back({.name = "", .primitives = {primitive}});
  scene.bounds.include(shape.bounds.low);
  scene.bounds.include(shape.bounds.high);
}

void rectangle(Shape& shape, glm::vec3 centre, glm::vec3 x, glm::vec3 y) {
  const glm::vec3 n = glm::normalize(glm::cross(x, y));
  const auto a = shape.corner(centre - x - y, n), b = shape.corner(centre + x - y, n);
  const auto c = shape.corner(centre + x + y, n), d = shape.corner(centre - x + y, n);
  for (const auto i : {a, b, c, a, c, d})
    shape.indices.push_back(i);
}

} // namespace

void add_ball(Scene& scene, const scene::Material& material, glm::vec3 centre, float radius,
              int rings) {
  Shape shape;
  const int segments = 2 * rings;
  const float pi = std::numbers::pi_v<float>;
  for (int i = 0; i <= rings; ++i)
    for (int j = 0; j <= segments; ++j) {
      const float theta = pi * static_cast<float>(i) / static_cast<float>(rings);
      const float phi = 2.0f * pi * static_cast<float>(j) / static_cast<float>(segments);
      const glm::vec3 n(std::sin(theta) * std::sin(phi), std::cos(theta),
                        std::sin(theta) * std::cos(phi));
      shape.corner(centre + radius * n, n);
      shape.uvs.values.insert(shape.uvs.values.end(),
                              {6.0f * static_cast<float>(j) / static_cast<float>(segments),
                               4.0f * static_cast<float>(i) / static_cast<float>(rings)});
    }
  const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(i * (segments + 1) + j); };
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < segments; ++j) {
      if (i > 0)
        for (const auto k : {at(i, j), at(i + 1, j + 1), at(i, j + 1)})
          shape.indices.push_back(k);
      if (i < rings - 1)
        for (const auto k : {at(i, j), at(i + 1, j), at(i + 1, j + 1)})
          shape.indices.push_back(k);
    }
  add(scene, material, shape);
}

void add_sheet(Scene& scene, const scene::Material& material, float half, float z) {
  Shape shape;
  rectangle(shape, {0.0f, 0.0f, z}, {half, 0.0f, 0.0f}, {0.0f, half, 0.0f});
  add(scene, material, shape);
}

void add_box(Scene& scene, const scene::Material& material, glm::vec3 centre, glm::vec3 half) {
  Shape shape;
  for (int axis = 0; axis < 3; ++axis)
    for (const float side : {-1.0f, 1.0f}) {
      glm::vec3 out(0.0f), x(0.0f), y(0.0f);
      out[axis] = side * half[axis];
      x[(axis + 1) % 3] = side * half[(axis + 1) % 3];
      y[(axis + 2) % 3] = half[(axis + 2) % 3];
      rectangle(shape, centre + out, x, y);
    }
  add(scene, material, shape);
}

scene::Material metal(float alpha) {
  return {.name = "metal", .metallic = 1.0f, .exact_alpha = alpha};
}

scene::Material glass(float alpha) {
  return {.name = "glass",
          .metallic = 0.0f,
          .ior = 1.5f,
          .transmission = 1.0f,
          .thickness = 1.0f,
          .exact_alpha = alpha};
}

scene::Material thin_glass(float alpha) {
  scene::Material m = glass(alpha);
  m.thickness = 0.0f;
  m.double_sided = true;
  return m;
}

scene::Material unlit(float grey) {
  return {.name = "unlit", .base_color = {grey, grey, grey, 1.0f}, .unlit = true};
}

scene::Camera orthographic(float half_height, float distance) {
  scene::Camera camera;
  camera.world[3] = glm::vec4(0.0f, 0.0f, distance, 1.0f);
  camera.orthographic = true;
  camera.magnification = glm::vec2(half_height);
  camera.near = 0.01f;
  camera.far = 2.0f * distance;
  return camera;
}

} // namespace gg::truth::test
