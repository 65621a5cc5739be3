#include "interior/models.h"

#include "scene/load.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gg::test {
namespace {

struct Mesh {
  std::vector<float> positions, normals;
  scene::Indices indices;

  std::uint32_t add(const glm::dvec3& p, const glm::dvec3& n) {
    for (int c = 0; c < 3; ++c) {
      positions.push_back(static_cast<float>(p[c]));
      normals.push_back(static_cast<float>(n[c]));
    }
    return static_cast<std::uint32_t>(positions.size() / 3 - 1);
  }
  void quad(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
    const glm::dvec3 n = glm::normalize(glm::cross(b - a, c - a));
    const std::uint32_t i = add(a, n);
    add(b, n), add(c, n), add(d, n);
    indices.insert(indices.end(), {i, i + 1, i + 2, i, i + 2, i + 3});
  }
  void triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 n = glm::normalize(glm::cross(b - a, c - a));
    const std::uint32_t i = add(a, n);
    add(b, n), add(c, n);
    indices.insert(indices.end(), {i, i + 1, i + 2});
  }
};

scene::Scene scene_of(Mesh mesh, float ior) {
  scene::Scene s;
  scene::Primitive p;
  for (std::size_t i = 0; i < mesh.positions.size(); i += 3)
    p.bounds.include({mesh.positions[i], mesh.positions[i + 1], mesh.positions[i + 2]});
  s.streams = {{3, std::move(mesh.positions)}, {3, std::move(mesh.normals)}};
  s.indices = {std::move(mesh.indices)};
  p.positions = 0, p.normals = 1, p.indices = 0, p.material = 0;
  s.bounds = p.bounds;
  s.meshes = {{"mesh", {p}}};
  s.instances = {{.mesh = 0, .name = "instance"}};
  s.materials = {glass(ior)};
  return s;
}

// A point of a profile in the half-plane x >= 0 and its normal there.
struct ProfilePoint {
  glm::dvec2 at, n;
};

// Turns a profile about Y. The profile runs so that its outside is to the left, where its
// normals point. Rings of radius 0 are poles.
Mesh revolve(const std::vector<ProfilePoint>& profile, int columns) {
  Mesh mesh;
  for (const auto& [at, n] : profile)
    for (int c = 0; c <= columns; ++c) {
      const double phi = 2.0 * std::numbers::pi * (c % columns) / columns;
      mesh.add({at.x * std::sin(phi), at.y, at.x * std::cos(phi)},
               {n.x * std::sin(phi), n.y, n.x * std::cos(phi)});
    }
  const auto width = static_cast<std::uint32_t>(columns) + 1;
  for (std::uint32_t r = 0; r + 1 < profile.size(); ++r)
    for (std::uint32_t c = 0; c + 1 < width; ++c) {
      const std::uint32_t a = r * width + c, b = a + width;
      if (profile[r].at.x > 0.0) mesh.indices.insert(mesh.indices.end(), {a, b, a + 1});
      if (profile[r + 1].at.x > 0.0) mesh.indices.insert(mesh.indices.end(), {a + 1, b, b + 1});
    }
  return mesh;
}

// A smooth curve through points: Catmull-Rom, `per_segment` pieces each, normals to the left.
std::vector<ProfilePoint> smooth(const std::vector<glm::dvec2>& points, int per_segment) {
  const auto at = [&](int i) {
    return points[static_cast<std::size_t>(std::clamp(i, 0, static_cast<int>(points.size()) - 1))];
  };
  std::vector<ProfilePoint> curve;
  const int segments = static_cast<int>(points.size()) - 1;
  for (int s = 0; s < segments; ++s)
    for (int k = 0; k < per_segment + (s + 1 == segments ? 1 : 0); ++k) {
      const double t = static_cast<double>(k) / per_segment;
      const glm::dvec2 a = at(s - 1), b = at(s), c = at(s + 1), d = at(s + 2);
      const glm::dvec2 p = 0.5
                           * (2.0 * b + t * (c - a) + t * t * (2.0 * a - 5.0 * b + 4.0 * c - d)
                              + t * t * t * (3.0 * b - a - 3.0 * c + d));
      const glm::dvec2 along = 0.5
                               * (c - a + 2.0 * t * (2.0 * a - 5.0 * b + 4.0 * c - d)
                                  + 3.0 * t * t * (3.0 * b - a - 3.0 * c + d));
      const glm::dvec2 unit = glm::normalize(along);
      curve.push_back({{std::max(p.x, 0.0), p.y}, {-unit.y, unit.x}});
    }
  // On the axis the surface is level.
  for (ProfilePoint* end : {&curve.front(), &curve.back()})
    if (end->at.x < 1e-9) *end = {{0.0, end->at.y}, {0.0, end->n.y < 0.0 ? -1.0 : 1.0}};
  return curve;
}

void add_box(Mesh& mesh, const glm::dvec3& h, bool inwards) {
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      glm::dvec3 n(0.0), u(0.0), v(0.0);
      n[axis] = side * h[axis];
      u[(axis + 1) % 3] = h[(axis + 1) % 3];
      v[(axis + 2) % 3] = h[(axis + 2) % 3];
      if ((side < 0.0) != inwards) std::swap(u, v);
      mesh.quad(n - u - v, n + u - v, n + u + v, n - u + v);
    }
}

} // namespace

scene::Material glass(float ior) {
  scene::Material m;
  m.name = "glass";
  m.metallic = 0.0f;
  m.roughness = 0.0f;
  m.transmission = 1.0f;
  m.thickness = 1.0f;
  m.ior = ior;
  return m;
}

scene::Scene sphere(float ior) {
  std::vector<ProfilePoint> profile;
  constexpr int rows = 160;
  for (int r = 0; r <= rows; ++r) {
    const double theta = std::numbers::pi * r / rows;
    const glm::dvec2 n(r % rows == 0 ? 0.0 : std::sin(theta), std::cos(theta));
    profile.push_back({0.5 * n, n});
  }
  return scene_of(revolve(profile, 2 * rows), ior);
}

scene::Scene box(const glm::vec3& size, float ior) {
  Mesh mesh;
  add_box(mesh, 0.5 * glm::dvec3(size), false);
  return scene_of(std::move(mesh), ior);
}

scene::Scene torus(float ior) {
  std::vector<ProfilePoint> profile;
  constexpr int rows = 96;
  for (int r = 0; r <= rows; ++r) {
    const double theta = 2.0 * std::numbers::pi * (r % rows) / rows;
    const glm::dvec2 n(std::sin(theta), std::cos(theta));
    profile.push_back({glm::dvec2(0.375, 0.0) + 0.125 * n, n});
  }
  return scene_of(revolve(profile, 256), ior);
}

scene::Scene wineglass(float ior) {
  // Inside of the bowl from its bottom up, over the rim, down the outside, the stem, the foot.
  const std::vector<glm::dvec2> outline = {
      {0.0, 0.012},   {0.08, 0.03},     {0.15, 0.10},    {0.178, 0.20},   {0.17, 0.32},
      {0.145, 0.46},  {0.141, 0.490},   {0.147, 0.498},  {0.153, 0.490},  {0.157, 0.46},
      {0.182, 0.32},  {0.19, 0.20},     {0.162, 0.09},   {0.09, 0.012},   {0.03, -0.03},
      {0.016, -0.10}, {0.014, -0.25},   {0.016, -0.40},  {0.03, -0.455},  {0.10, -0.478},
      {0.17, -0.489}, {0.176, -0.4945}, {0.17, -0.4995}, {0.10, -0.4995}, {0.0, -0.4995}};
  return scene_of(revolve(smooth(outline, 12), 192), ior);
}

scene::Scene hollow_box(float ior) {
  Mesh mesh;
  add_box(mesh, glm::dvec3(0.5), false);
  add_box(mesh, glm::dvec3(0.25), true);
  return scene_of(std::move(mesh), ior);
}

scene::Scene prism(float ior) {
  // Corners of a triangle of side 1 in the plane across X.
  const double h = 0.5 * std::sqrt(3.0);
  const glm::dvec2 corners[3] = {{-0.5, -h / 3.0}, {0.5, -h / 3.0}, {0.0, 2.0 * h / 3.0}}; // z, y
  const auto at = [&](int k, double x) {
    return glm::dvec3(x, corners[k % 3].y, corners[k % 3].x);
  };
  Mesh mesh;
  for (int k = 0; k < 3; ++k)
    mesh.quad(at(k, 0.5), at(k + 1, 0.5), at(k + 1, -0.5), at(k, -0.5));
  mesh.triangle(at(0, -0.5), at(1, -0.5), at(2, -0.5));
  mesh.triangle(at(0, 0.5), at(2, 0.5), at(1, 0.5));
  return scene_of(std::move(mesh), ior);
}

scene::Scene asset(const std::string& file, float ior) {
  scene::Scene s = scene::load(std::string(GROUNDGLASS_SOURCE_DIR) + "/assets/scenes/" + file);
  // All in one instance: the parts of one instance and material bound one solid.
  scene::Mesh merged{.name = "merged"};
  const glm::vec3 size = s.bounds.high - s.bounds.low;
  const float scale = 1.0f / std::max({size.x, size.y, size.z});
  const glm::mat4 normalise =
      glm::translate(glm::scale(glm::mat4(1.0f), glm::vec3(scale)), -s.bounds.centre());
  for (const scene::Instance& instance : s.instances)
    for (scene::Primitive p : s.meshes[static_cast<std::size_t>(instance.mesh)].primitives) {
      const glm::mat4 world = normalise * instance.world;
      const glm::mat3 normal_from_mesh = glm::transpose(glm::inverse(glm::mat3(world)));
      scene::Stream positions = s.streams[static_cast<std::size_t>(p.positions)],
                    normals = s.streams[static_cast<std::size_t>(p.normals)];
      p.bounds = {};
      for (std::size_t i = 0; i + 2 < positions.values.size(); i += 3) {
        float* const at = &positions.values[i];
        float* const n = &normals.values[i];
        const glm::vec3 moved(world * glm::vec4(at[0], at[1], at[2], 1.0f));
        const glm::vec3 turned = glm::normalize(normal_from_mesh * glm::vec3(n[0], n[1], n[2]));
        p.bounds.include(moved);
        for (int c = 0; c < 3; ++c)
          at[c] = moved[c], n[c] = turned[c];
      }
      p.positions = static_cast<scene::Index>(s.streams.size());
      s.streams.push_back(std::move(positions));
      p.normals = static_cast<scene::Index>(s.streams.size());
      s.streams.push_back(std::move(normals));
      p.tangents = p.colors = scene::none;
      p.uvs.clear();
      p.material = 0;
      merged.primitives.push_back(p);
    }
  s.bounds = {};
  for (const scene::Primitive& p : merged.primitives)
    s.bounds.include(p.bounds.low), s.bounds.include(p.bounds.high);
  s.meshes = {merged};
  s.instances = {{.mesh = 0, .name = "merged"}};
  s.materials = {glass(ior)};
  s.images.clear();
  s.textures.clear();
  s.lights.clear();
  return s;
}

scene::Camera camera_from(const glm::vec3& direction, float share) {
  const glm::vec3 z = glm::normalize(direction);
  const glm::vec3 up = std::abs(z.y) > 0.99f ? glm::vec3(0, 0, -1) : glm::vec3(0, 1, 0);
  const glm::vec3 x = glm::normalize(glm::cross(up, z));
  scene::Camera camera;
  camera.fovy = 0.6f;
  const float distance = 0.5f / (share * std::tan(0.5f * camera.fovy)) + 0.5f;
  camera.world = glm::mat4(glm::vec4(x, 0), glm::vec4(glm::cross(z, x), 0), glm::vec4(z, 0),
                           glm::vec4(distance * z, 1));
  camera.near = 0.1f;
  camera.far = 10.0f;
  return camera;
}

} // namespace gg::test
