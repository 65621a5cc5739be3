#include "render/shapes.h"

#include <cmath>
#include <numbers>

namespace gg::test {
namespace {

scene::Index add_stream(scene::Scene& scene, int components, std::vector<float> values) {
  scene.streams.push_back({components, std::move(values)});
  return static_cast<scene::Index>(scene.streams.size()) - 1;
}

void append(std::vector<float>& values, std::initializer_list<double> more) {
  for (const double v : more)
    values.push_back(static_cast<float>(v));
}

scene::Scene one_mesh(scene::Primitive primitive, const scene::Material& material,
                      scene::Scene scene) {
  primitive.indices = 0;
  primitive.material = 0;
  for (std::size_t i = 0; i < scene.streams[0].values.size(); i += 3) {
    const float* p = &scene.streams[0].values[i];
    primitive.bounds.include({p[0], p[1], p[2]});
  }
  scene.bounds = primitive.bounds;
  scene.meshes.push_back({"mesh", {primitive}});
  scene.instances.push_back({.mesh = 0, .name = "instance"});
  scene.materials.push_back(material);
  return scene;
}

} // namespace

scene::Scene ball(const scene::Material& material) {
  constexpr int rows = 96, columns = 192;
  std::vector<float> positions, tangents, uvs;
  for (int r = 0; r <= rows; ++r)
    for (int c = 0; c <= columns; ++c) {
      // Closed to the bit: the last column is the first, and a pole one point.
      const double theta = std::numbers::pi * r / rows;
      const double phi = 2.0 * std::numbers::pi * (c % columns) / columns;
      const double ring = r % rows == 0 ? 0.0 : std::sin(theta);
      append(positions, {ring * std::sin(phi) + 0.0, std::cos(theta), ring * std::cos(phi) + 0.0});
      append(tangents, {std::cos(phi), 0.0, -std::sin(phi), 1.0});
      append(uvs, {static_cast<double>(c) / columns, static_cast<double>(r) / rows});
    }
  scene::Scene scene;
  scene::Indices& indices = scene.indices.emplace_back();
  for (unsigned r = 0; r < rows; ++r)
    for (unsigned c = 0; c < columns; ++c) {
      const unsigned a = r * (columns + 1) + c, b = a + columns + 1;
      if (r > 0) indices.insert(indices.end(), {a, b, a + 1});
      if (r + 1 < rows) indices.insert(indices.end(), {a + 1, b, b + 1});
    }
  scene::Primitive p;
  p.positions = add_stream(scene, 3, positions);
  p.normals = add_stream(scene, 3, positions); // of a unit sphere at the origin
  p.tangents = add_stream(scene, 4, tangents);
  p.uvs = {add_stream(scene, 2, uvs)};
  return one_mesh(p, material, std::move(scene));
}

scene::Scene square(const scene::Material& material) {
  scene::Scene scene;
  scene.indices.push_back({0, 1, 2, 0, 2, 3});
  scene::Primitive p;
  p.positions = add_stream(scene, 3, {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0});
  p.normals = add_stream(scene, 3, {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
  p.tangents = add_stream(scene, 4, {1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1});
  p.uvs = {add_stream(scene, 2, {0, 1, 1, 1, 1, 0, 0, 0})};
  return one_mesh(p, material, std::move(scene));
}

scene::Scene box(const scene::Material& material) {
  scene::Scene scene;
  scene::Indices& indices = scene.indices.emplace_back();
  std::vector<float> positions, normals;
  for (unsigned face = 0; face < 6; ++face) {
    const int axis = static_cast<int>(face / 2);
    const double sign = face % 2 ? -1.0 : 1.0;
    glm::dvec3 n(0.0), u(0.0);
    n[axis] = sign;
    u[(axis + 1) % 3] = 1.0;
    const glm::dvec3 v = glm::cross(n, u); // u, v, n right-handed: counter-clockwise from outside
    for (const glm::dvec2 corner : {glm::dvec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
      const glm::dvec3 p = n + corner.x * u + corner.y * v;
      append(positions, {p.x, p.y, p.z});
      append(normals, {n.x, n.y, n.z});
    }
    for (const unsigned k : {0u, 1u, 2u, 0u, 2u, 3u})
      indices.push_back(4 * face + k);
  }
  scene::Primitive p;
  p.positions = add_stream(scene, 3, positions);
  p.normals = add_stream(scene, 3, normals);
  return one_mesh(p, material, std::move(scene));
}

void add(scene::Scene& scene, const scene::Scene& other, const glm::mat4& world) {
  const auto size = [](const auto& list) { return static_cast<scene::Index>(list.size()); };
  const scene::Index streams = size(scene.streams), indices = size(scene.indices),
                     meshes = size(scene.meshes), materials = size(scene.materials);
  const auto move = [](scene::Index& i, scene::Index by) {
    if (i != scene::none) i += by;
  };
  for (scene::Mesh mesh : other.meshes) {
    for (scene::Primitive& p : mesh.primitives) {
      for (scene::Index* i : {&p.positions, &p.normals, &p.tangents, &p.colors})
        move(*i, streams);
      for (scene::Index& uv : p.uvs)
        move(uv, streams);
      move(p.indices, indices);
      move(p.material, materials);
    }
    scene.meshes.push_back(mesh);
  }
  for (scene::Instance instance : other.instances) {
    instance.mesh += meshes;
    instance.world = world * instance.world;
    instance.mirrored = glm::determinant(glm::mat3(instance.world)) < 0.0f;
    scene.instances.push_back(instance);
    for (int corner = 0; corner < 8; ++corner) {
      const glm::vec3 at(corner & 1 ? other.bounds.low.x : other.bounds.high.x,
                         corner & 2 ? other.bounds.low.y : other.bounds.high.y,
                         corner & 4 ? other.bounds.low.z : other.bounds.high.z);
      scene.bounds.include(glm::vec3(world * glm::vec4(at, 1.0f)));
    }
  }
  scene.streams.insert(scene.streams.end(), other.streams.begin(), other.streams.end());
  scene.indices.insert(scene.indices.end(), other.indices.begin(), other.indices.end());
  scene.materials.insert(scene.materials.end(), other.materials.begin(), other.materials.end());
}

scene::Camera camera_at(const glm::vec3& eye) {
  const glm::vec3 z = glm::normalize(eye);
  const glm::vec3 up = std::abs(z.y) > 0.99f ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0);
  const glm::vec3 x = glm::normalize(glm::cross(up, z));
  scene::Camera camera;
  camera.world = glm::mat4(glm::vec4(x, 0), glm::vec4(glm::cross(z, x), 0), glm::vec4(z, 0),
                           glm::vec4(eye, 1));
  camera.near = 0.1f;
  return camera;
}

scene::Material metal(float roughness, const glm::vec3& color) {
  scene::Material m;
  m.name = "metal";
  m.base_color = glm::vec4(color, 1.0f);
  m.metallic = 1.0f;
  m.roughness = roughness;
  return m;
}

scene::Material dielectric(float roughness, const glm::vec3& color) {
  scene::Material m = metal(roughness, color);
  m.name = "dielectric";
  m.metallic = 0.0f;
  return m;
}

scene::Material unlit(const glm::vec3& color) {
  scene::Material m = metal(1.0f, color);
  m.name = "unlit";
  m.unlit = true;
  return m;
}

scene::Material glass(float roughness, float ior) {
  scene::Material m = dielectric(roughness, glm::vec3(1.0f));
  m.name = "glass";
  m.ior = ior;
  m.transmission = 1.0f;
  m.thickness = 1.0f;
  return m;
}

} // namespace gg::test
