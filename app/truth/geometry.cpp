#include "truth/geometry.h"

#include "core/error.h"
#include "scene/bodies.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>

namespace gg::truth {
namespace {

// Of a triangle that is met from behind, for surfaces that are not there from behind: no hit. The
// user pointer says whether the part is mirrored.
void pass_from_behind(const RTCFilterFunctionNArguments* args) {
  const bool mirrored = args->geometryUserPtr != nullptr;
  for (unsigned i = 0; i < args->N; ++i) {
    if (args->valid[i] != -1) continue;
    const float along =
        RTCRayN_dir_x(args->ray, args->N, i) * RTCHitN_Ng_x(args->hit, args->N, i)
        + RTCRayN_dir_y(args->ray, args->N, i) * RTCHitN_Ng_y(args->hit, args->N, i)
        + RTCRayN_dir_z(args->ray, args->N, i) * RTCHitN_Ng_z(args->hit, args->N, i);
    if ((along > 0.0f) != mirrored) args->valid[i] = 0;
  }
}

// A surface that light cannot cross, drawn by the raster from its front only. Both faces of a solid
// are interfaces, whatever the material says about its sides.
bool is_one_sided(const scene::Material& m) {
  return !m.double_sided && !scene::is_solid(m);
}

glm::dvec3 vertex(const scene::Stream& stream, std::uint32_t i) {
  const float* v = stream.values.data() + 3 * static_cast<std::size_t>(i);
  return {v[0], v[1], v[2]};
}

Part part_of(const scene::Scene& scene, scene::Index instance, const scene::Primitive& primitive) {
  const scene::Instance& placed = scene.instances[static_cast<std::size_t>(instance)];
  Part part;
  part.primitive = &primitive;
  part.material_index = primitive.material;
  part.material = &scene.materials[static_cast<std::size_t>(primitive.material)];
  part.instance = instance;
  part.world_from_mesh = glm::dmat4(placed.world);
  const glm::dmat3 linear(part.world_from_mesh);
  // As in the raster: a singular transform has no inverse, but its numbers must stay finite.
  part.normal_from_mesh =
      std::abs(glm::determinant(linear)) > 0.0 ? glm::transpose(glm::inverse(linear)) : linear;
  part.mirrored = placed.mirrored;
  part.one_sided = is_one_sided(*part.material);
  return part;
}

} // namespace

struct Geometry::Embree {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;

  Embree() : device(rtcNewDevice(nullptr)) {
    if (!device)
      throw Error(ExitCode::internal, "Embree", "cannot be started",
                  "It needs a processor with SSE2 and memory for its tables.");
    scene = rtcNewScene(device);
    // Without it a ray may slip through the edge between two triangles: light would leak into and
    // out of solids.
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  }
  ~Embree() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
  Embree(const Embree&) = delete;
  Embree& operator=(const Embree&) = delete;

  void check() const {
    if (const RTCError error = rtcGetDeviceError(device); error != RTC_ERROR_NONE)
      throw Error(ExitCode::internal, "Embree",
                  error == RTC_ERROR_OUT_OF_MEMORY ? "is out of memory"
                                                   : "failed with code " + std::to_string(error),
                  "Try a smaller scene.");
  }

  void add(const Part& part, const scene::Stream& positions, const scene::Indices& indices,
           const glm::dvec3& centre) const {
    const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    const std::size_t count = positions.count();
    auto* const vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), count));
    auto* const corners = static_cast<std::uint32_t*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(std::uint32_t), indices.size() / 3));
    check();
    for (std::size_t i = 0; i < count; ++i) {
      const glm::dvec3 p =
          glm::dvec3(part.world_from_mesh
                     * glm::dvec4(vertex(positions, static_cast<std::uint32_t>(i)), 1.0))
          - centre;
      for (int c = 0; c < 3; ++c)
        vertices[3 * i + static_cast<std::size_t>(c)] = static_cast<float>(p[c]);
    }
    std::ranges::copy(indices, corners);
    if (part.one_sided) {
      rtcSetGeometryUserData(geometry, part.mirrored ? const_cast<Part*>(&part) : nullptr);
      rtcSetGeometryIntersectFilterFunction(geometry, pass_from_behind);
      rtcSetGeometryOccludedFilterFunction(geometry, pass_from_behind);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    check();
  }

  glm::dvec3 corner(unsigned geometry, std::uint32_t i) const {
    const auto* v = static_cast<const float*>(
        rtcGetGeometryBufferData(rtcGetGeometry(scene, geometry), RTC_BUFFER_TYPE_VERTEX, 0));
    v += 3 * static_cast<std::size_t>(i);
    return {v[0], v[1], v[2]};
  }
  const std::uint32_t* corners(unsigned geometry, unsigned triangle) const {
    return static_cast<const std::uint32_t*>(
               rtcGetGeometryBufferData(rtcGetGeometry(scene, geometry), RTC_BUFFER_TYPE_INDEX, 0))
           + 3 * static_cast<std::size_t>(triangle);
  }
};

namespace {

RTCRay embree_ray(const Ray& ray, const glm::dvec3& centre) {
  const glm::vec3 origin(ray.origin - centre), direction(ray.direction);
  RTCRay r{};
  r.org_x = origin.x, r.org_y = origin.y, r.org_z = origin.z;
  r.dir_x = direction.x, r.dir_y = direction.y, r.dir_z = direction.z;
  r.tnear = static_cast<float>(ray.near);
  r.tfar = static_cast<float>(ray.far);
  r.mask = ~0u;
  return r;
}

} // namespace

Geometry::Geometry(const scene::Scene& scene) : embree_(std::make_unique<Embree>()) {
  if (!scene.bounds.empty()) centre_ = glm::dvec3(scene.bounds.centre());
  for (std::size_t i = 0; i < scene.instances.size(); ++i)
    for (const scene::Primitive& primitive :
         scene.meshes[static_cast<std::size_t>(scene.instances[i].mesh)].primitives)
      parts_.push_back(part_of(scene, static_cast<scene::Index>(i), primitive));
  for (const Part& part : parts_)
    embree_->add(part, scene.streams[static_cast<std::size_t>(part.primitive->positions)],
                 scene.indices[static_cast<std::size_t>(part.primitive->indices)], centre_);
  rtcCommitScene(embree_->scene);
  embree_->check();
}

Geometry::~Geometry() = default;
Geometry::Geometry(Geometry&&) noexcept = default;

std::optional<Hit> Geometry::intersect(const Ray& ray) const {
  RTCRayHit query{};
  query.ray = embree_ray(ray, centre_);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(embree_->scene, &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;

  const unsigned geometry = query.hit.geomID;
  Hit hit;
  hit.part = &parts_[geometry];
  std::copy_n(embree_->corners(geometry, query.hit.primID), 3, hit.vertices);
  const double u = static_cast<double>(query.hit.u), v = static_cast<double>(query.hit.v);
  hit.weights = {1.0 - u - v, u, v};
  glm::dvec3 p[3];
  for (int k = 0; k < 3; ++k)
    p[k] = embree_->corner(geometry, hit.vertices[k]);
  // From the corners, in double: on the triangle's plane to the last place, wherever rounding put
  // the ray's end.
  const glm::dvec3 local = hit.weights[0] * p[0] + hit.weights[1] * p[1] + hit.weights[2] * p[2];
  hit.position = centre_ + local;
  glm::dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
  if (hit.part->mirrored) normal = -normal;
  hit.normal = glm::normalize(normal);
  const auto size = [](const glm::dvec3& a) {
    return std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)});
  };
  hit.scale = std::max({size(local), size(p[1] - p[0]), size(p[2] - p[0])});
  return hit;
}

bool Geometry::occluded(const Ray& ray) const {
  RTCRay query = embree_ray(ray, centre_);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(embree_->scene, &context, &query);
  return query.tfar < 0.0f;
}

// The origin is rounded to float (2^-24 of each coordinate, at most sqrt(3) of that along the
// normal), Embree's edges and its plane test lose a few times 2^-24 of the triangle's size. 2^-20
// is sixteen such roundings: enough for all of them, a millionth of the scene.
glm::dvec3 Geometry::leave(const Hit& hit, const glm::dvec3& w) const {
  const double offset = 0x1p-20 * hit.scale;
  return hit.position + (glm::dot(w, hit.normal) >= 0.0 ? offset : -offset) * hit.normal;
}

} // namespace gg::truth
