#include "needs/hollows.h"

#include "needs/features.h"

#include <embree3/rtcore.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gg::needs {
namespace {

using scene::Primitive;

constexpr std::size_t tried = 256; // vertices of a part, that say whether it can see itself
constexpr int least_rays = 16;     // below: neighbouring vertices differ by .1 and more
constexpr double shallow = 0.02;   // coverage that nobody sees
constexpr float off_surface =
    1e-4f; // of the body's size: past the edges of a vertex's own triangles, which rounding may lift

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

// One body, as Embree traces it.
class Tracer {
public:
  Tracer(const scene::Scene& scene, const std::vector<Part>& parts)
      : device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_)) {
    for (const Part& part : parts) {
      const scene::Indices& indices =
          scene.indices[static_cast<std::size_t>(part.primitive->indices)];
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

  // The share of `rays` about n, spread by the cosine, that meet the body.
  float coverage(const glm::vec3& p, const glm::vec3& n, int rays) const {
    if (!(glm::dot(n, n) > 0.0f)) return 0.0f;
    const glm::vec3 z = glm::normalize(n);
    const glm::vec3 x = glm::normalize(
        glm::cross(std::abs(z.x) < 0.5f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0), z));
    const glm::vec3 y = glm::cross(z, x);
    const float lift = off_surface * size_.radius();
    int met = 0;
    for (int i = 0; i < rays; ++i) {
      // Vogel's spiral over the disc below the hemisphere (Malley's method).
      const float r2 = (static_cast<float>(i) + 0.5f) / static_cast<float>(rays), r = std::sqrt(r2);
      const float angle =
          static_cast<float>(i) * static_cast<float>(std::numbers::pi) * (3.0f - std::sqrt(5.0f));
      const glm::vec3 d =
          r * std::cos(angle) * x + r * std::sin(angle) * y + std::sqrt(1.0f - r2) * z;
      const glm::vec3 from = p + lift * z;
      RTCIntersectContext context;
      rtcInitIntersectContext(&context);
      RTCRay ray{};
      ray.org_x = from.x, ray.org_y = from.y, ray.org_z = from.z;
      ray.dir_x = d.x, ray.dir_y = d.y, ray.dir_z = d.z;
      ray.tfar = INFINITY;
      ray.mask = ~0u;
      rtcOccluded1(scene_, &context, &ray);
      met += ray.tfar < 0.0f ? 1 : 0;
    }
    return static_cast<float>(met) / static_cast<float>(rays);
  }

private:
  RTCDevice device_;
  RTCScene scene_;
  scene::Bounds size_;
};

bool sees_itself(const Part& part, const Tracer& tracer) {
  const std::size_t step = std::max<std::size_t>(1, part.points.size() / tried);
  for (std::size_t i = 0; i < part.points.size(); i += step)
    if (tracer.coverage(part.points[i], part.normals[i], least_rays) > 0.0f) return true;
  return false;
}

void add_body(Hollows& hollows, const scene::Scene& scene, std::vector<Part> parts) {
  const Tracer tracer(scene, parts);
  std::erase_if(parts, [&](const Part& part) { return !sees_itself(part, tracer); });
  std::size_t count = 0;
  for (const Part& part : parts)
    count += part.points.size();
  const std::size_t rays = most_rays / std::max<std::size_t>(count, 1);
  if (rays < least_rays) return;
  for (const Part& part : parts) {
    scene::Stream stream{.components = 1, .values = std::vector<float>(part.points.size())};
    tbb::parallel_for(std::size_t{0}, stream.values.size(), [&](std::size_t i) {
      stream.values[i] = tracer.coverage(part.points[i], part.normals[i],
                                         std::min(hollow_rays, static_cast<int>(rays)));
    });
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
