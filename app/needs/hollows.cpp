#include "needs/hollows.h"

#include "needs/features.h"
#include "needs/vertex_fit.h"

#include <embree3/rtcore.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace gg::needs {
namespace {

using scene::Primitive;

constexpr std::size_t tried = 256; // triangles of a part, that say whether it can see itself
constexpr int trial_rays = 16;
constexpr int least_rays = 8;        // for each point: some 140 for a vertex among six triangles
constexpr double shallow = 0.02;     // coverage that nobody sees
constexpr float off_surface = 1e-4f; // of the body's size: past what rounding lifts over a point

bool hides(const scene::Scene& scene, const Primitive& primitive) {
  const scene::Material& material = scene.materials[static_cast<std::size_t>(primitive.material)];
  return !is_refractive(material) && material.alpha_mode == scene::AlphaMode::opaque
         && !primitive.bounds.empty();
}

// A primitive of an instance, in the world.
struct Part {
  std::pair<std::size_t, std::size_t> key;
  const Primitive* primitive;
  std::vector<glm::vec3> points, normals;
};

Part part_of(const scene::Scene& scene, const std::pair<std::size_t, std::size_t>& key) {
  const scene::Instance& instance = scene.instances[key.first];
  const Primitive& primitive =
      scene.meshes[static_cast<std::size_t>(instance.mesh)].primitives[key.second];
  Part part{key, &primitive, {}, {}};
  const glm::mat3 linear(instance.world);
  const glm::mat3 normal =
      std::abs(glm::determinant(linear)) > 0.0f ? glm::transpose(glm::inverse(linear)) : linear;
  const auto& points = scene.streams[static_cast<std::size_t>(primitive.positions)].values;
  const auto& normals = scene.streams[static_cast<std::size_t>(primitive.normals)].values;
  for (std::size_t i = 0; i + 2 < points.size(); i += 3) {
    part.points.emplace_back(instance.world
                             * glm::vec4(points[i], points[i + 1], points[i + 2], 1.0f));
    part.normals.push_back(normal * glm::vec3(normals[i], normals[i + 1], normals[i + 2]));
  }
  return part;
}

// A point of a triangle: unit normals, of shading and of the triangle (on the same side).
struct Sample {
  glm::vec3 point{0.0f}, normal{0.0f}, across{0.0f};
};

// At barycentric coordinates (1 - u - v, u, v) of triangle t; none of a triangle without area or normal.
std::optional<Sample> sample_of(const Part& part, const scene::Indices& corners, std::size_t t,
                                float u, float v) {
  const std::size_t a = corners[3 * t], b = corners[3 * t + 1], c = corners[3 * t + 2];
  const auto at = [&](const std::vector<glm::vec3>& of) {
    return (1.0f - u - v) * of[a] + u * of[b] + v * of[c];
  };
  Sample sample{at(part.points), at(part.normals),
                glm::cross(part.points[b] - part.points[a], part.points[c] - part.points[a])};
  const float long_normal = glm::length(sample.normal), area = glm::length(sample.across);
  if (!(long_normal > 0.0f && area > 0.0f)) return std::nullopt;
  sample.normal /= long_normal;
  sample.across /= glm::dot(sample.across, sample.normal) < 0.0f ? -area : area;
  return sample;
}

const scene::Indices& corners_of(const scene::Scene& scene, const Part& part) {
  return scene.indices[static_cast<std::size_t>(part.primitive->indices)];
}

// One body, as Embree traces it.
class Tracer {
public:
  Tracer(const scene::Scene& scene, const std::vector<Part>& parts)
      : device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_)) {
    for (const Part& part : parts) {
      const scene::Indices& indices = corners_of(scene, part);
      RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
      void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                               RTC_FORMAT_FLOAT3, 12, part.points.size());
      void* corners = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                              12, indices.size() / 3);
      std::ranges::copy(part.points, static_cast<glm::vec3*>(vertices));
      std::ranges::copy(indices, static_cast<std::uint32_t*>(corners));
      for (const glm::vec3& p : part.points)
        size_.include(p);
      rtcCommitGeometry(geometry);
      rtcAttachGeometry(scene_, geometry);
      rtcReleaseGeometry(geometry);
    }
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    rtcCommitScene(scene_);
  }
  ~Tracer() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  Tracer(const Tracer&) = delete;
  Tracer& operator=(const Tracer&) = delete;

  // The share of `rays` about the sample's normal, spread by the cosine, that meet the body. Those that go below the sample's own
  // triangle, as shading normals lean, say nothing of the body's shape and are left out. Every sample takes the same rays about its
  // normal: what they miss differs little from place to place, where others would show as grain.
  float coverage(const Sample& sample, int rays) const {
    const glm::vec3& z = sample.normal;
    const glm::vec3 x = glm::normalize(
        glm::cross(std::abs(z.x) < 0.5f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0), z));
    const glm::vec3 y = glm::cross(z, x);
    const glm::vec3 from = sample.point + off_surface * size_.radius() * sample.across;
    int met = 0, above = 0;
    for (int i = 0; i < rays; ++i) {
      // Vogel's spiral over the disc below the hemisphere (Malley's method).
      const float r2 = (static_cast<float>(i) + 0.5f) / static_cast<float>(rays), r = std::sqrt(r2);
      const float angle =
          std::numbers::pi_v<float> * static_cast<float>(i) * (3.0f - std::sqrt(5.0f));
      const glm::vec3 d =
          r * std::cos(angle) * x + r * std::sin(angle) * y + std::sqrt(1.0f - r2) * z;
      if (!(glm::dot(d, sample.across) > 0.0f)) continue;
      RTCIntersectContext context;
      rtcInitIntersectContext(&context);
      RTCRay ray{};
      ray.org_x = from.x, ray.org_y = from.y, ray.org_z = from.z;
      ray.dir_x = d.x, ray.dir_y = d.y, ray.dir_z = d.z;
      ray.tfar = INFINITY;
      ray.mask = ~0u;
      rtcOccluded1(scene_, &context, &ray);
      met += ray.tfar < 0.0f ? 1 : 0;
      ++above;
    }
    return above > 0 ? static_cast<float>(met) / static_cast<float>(above) : 0.0f;
  }

private:
  RTCDevice device_;
  RTCScene scene_;
  scene::Bounds size_;
};

bool sees_itself(const scene::Scene& scene, const Part& part, const Tracer& tracer) {
  const scene::Indices& corners = corners_of(scene, part);
  const std::size_t triangles = corners.size() / 3;
  const std::size_t step = std::max<std::size_t>(1, triangles / tried);
  for (std::size_t t = 0; t < triangles; t += step) {
    const auto middle = sample_of(part, corners, t, 1.0f / 3.0f, 1.0f / 3.0f);
    if (middle && tracer.coverage(*middle, trial_rays) > 0.0f) return true;
  }
  return false;
}

// Coverage at the part's vertices that, interpolated, is nearest to that of its triangles' points, by area: at a vertex itself it
// may be anything, as one in the edge of a wall and a floor sees half of the floor, which the wall's middle does not
// [Kavan et al. 2011].
std::vector<float> baked(const scene::Scene& scene, const Part& part, const Tracer& tracer,
                         int rays) {
  const scene::Indices& corners = corners_of(scene, part);
  std::vector<std::array<float, 3>> covered(corners.size() / 3);
  tbb::parallel_for(std::size_t{0}, covered.size(), [&](std::size_t t) {
    for (std::size_t q = 0; q < 3; ++q) {
      // The quadrature of degree 2 inside triangles: two thirds towards each corner.
      const auto sample = sample_of(part, corners, t, q == 1 ? 2.0f / 3.0f : 1.0f / 6.0f,
                                    q == 2 ? 2.0f / 3.0f : 1.0f / 6.0f);
      if (!sample) continue;
      covered[t][q] = tracer.coverage(*sample, rays);
    }
  });
  return fitted_at_vertices(part.points, part.normals, corners, covered);
}

void add_body(Hollows& hollows, const scene::Scene& scene, std::vector<Part> parts) {
  const Tracer tracer(scene, parts);
  std::erase_if(parts, [&](const Part& part) { return !sees_itself(scene, part, tracer); });
  std::size_t count = 0; // of points
  for (const Part& part : parts)
    count += corners_of(scene, part).size();
  if (least_rays * count > most_rays) return;
  const auto rays = static_cast<int>(std::clamp<std::size_t>(
      enough_rays / std::max<std::size_t>(count, 1), least_rays, hollow_rays));
  for (const Part& part : parts) {
    scene::Stream stream{.components = 1, .values = baked(scene, part, tracer, rays)};
    if (std::ranges::max(stream.values) < static_cast<float>(shallow)) continue;
    hollows.of[part.key] = hollows.streams.size();
    hollows.streams.push_back(std::move(stream));
  }
}

} // namespace

Hollows hollows_of(const scene::Scene& scene, const Proxies& proxies) {
  std::map<std::size_t, std::vector<Part>> bodies;
  for (const auto& [key, body] : proxies.bodies) {
    Part part = part_of(scene, key);
    if (hides(scene, *part.primitive)) bodies[body].push_back(std::move(part));
  }
  Hollows hollows;
  for (auto& [body, parts] : bodies)
    add_body(hollows, scene, std::move(parts));
  return hollows;
}

} // namespace gg::needs
