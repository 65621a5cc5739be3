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
  return part;
}

} // namespace

namespace {

// The origin of a ray is rounded to float (2^-24 of each coordinate, at most sqrt(3) of that along
// the normal), Embree's edges and its plane test lose a few times 2^-24 of the triangle's size.
// 2^-20 is sixteen such roundings: enough for all of them, a millionth of the scene.
constexpr double leave_offset = 0x1p-20;

scene::Bounds world_bounds(const scene::Scene& scene, const Part& part) {
  scene::Bounds bounds;
  const scene::Stream& positions =
      scene.streams[static_cast<std::size_t>(part.primitive->positions)];
  for (std::uint32_t i = 0; i < positions.count(); ++i)
    bounds.include(glm::vec3(part.world_from_mesh * glm::dvec4(vertex(positions, i), 1.0)));
  return bounds;
}

// By a sweep along x.
void mark_overlaps(const scene::Scene& scene, std::vector<Part>& parts) {
  struct Box {
    Part* part;
    scene::Bounds bounds;
  };
  std::vector<Box> boxes;
  const float margin = static_cast<float>(2.0 * leave_offset) * scene.bounds.radius();
  for (Part& part : parts) {
    Box box{&part, world_bounds(scene, part)};
    box.bounds.low -= margin, box.bounds.high += margin;
    boxes.push_back(box);
  }
  std::ranges::sort(boxes, std::less{}, [](const Box& box) { return box.bounds.low.x; });
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = i + 1; j < boxes.size() && boxes[j].bounds.low.x <= boxes[i].bounds.high.x;
         ++j) {
      const scene::Bounds &a = boxes[i].bounds, &b = boxes[j].bounds;
      if (a.low.y <= b.high.y && b.low.y <= a.high.y && a.low.z <= b.high.z && b.low.z <= a.high.z)
        boxes[i].part->meets_others = boxes[j].part->meets_others = true;
    }
}

// Calls what(k, bounds) for each triangle k of the part, with a margin for what counts as near: of `leave`, at most twice
// the radius on each side, and what rounding to float loses far from the origin.
template <class What>
void for_triangles(const scene::Scene& scene, const Part& part, const What& what) {
  const scene::Stream& positions =
      scene.streams[static_cast<std::size_t>(part.primitive->positions)];
  const scene::Indices& indices = scene.indices[static_cast<std::size_t>(part.primitive->indices)];
  const float margin =
      static_cast<float>(8.0 * leave_offset) * scene.bounds.radius()
      + 0x1p-22f * (glm::length(scene.bounds.low) + glm::length(scene.bounds.high));
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    scene::Bounds bounds;
    for (std::size_t k = 0; k < 3; ++k)
      bounds.include(
          glm::vec3(part.world_from_mesh * glm::dvec4(vertex(positions, indices[i + k]), 1.0)));
    bounds.low -= margin, bounds.high += margin;
    what(i / 3, bounds);
  }
}

} // namespace

struct Geometry::Embree {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  // Its own copies of a part's triangles: relative to the centre of the scene.
  struct Mesh {
    const float* vertices = nullptr;
    const std::uint32_t* corners = nullptr;
    glm::vec3 vertex(std::uint32_t i) const {
      const float* const v = vertices + 3 * static_cast<std::size_t>(i);
      return {v[0], v[1], v[2]};
    }
  };

  Embree() : device(rtcNewDevice(nullptr)) {
    if (!device)
      throw Error(ExitCode::internal, "Embree", "cannot be started",
                  "It needs a processor with SSE2 and memory for its tables.");
    scene = rtcNewScene(device);
    // Longer to build, as rays by the million are worth it.
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
    // Without it a ray may slip through the edge between two triangles: light would leak into and
    // out of solids.
    rtcSetSceneFlags(scene, static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST
                                                       | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
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

  Mesh add(const Part& part, const scene::Stream& positions, const scene::Indices& indices,
           const glm::dvec3& centre) {
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
    return {vertices, corners}; // as long as the scene has the geometry
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
  // Both faces of a solid are interfaces, whatever the material says about its sides; else a surface
  // is drawn by the raster from its front only.
  scene::Bodies bodies(scene);
  for (Part& part : parts_) {
    part.solid = bodies.has_inside(scene.instances[static_cast<std::size_t>(part.instance)].mesh,
                                   part.material_index);
    part.one_sided = !part.material->double_sided && !part.solid;
  }
  mark_overlaps(scene, parts_);
  for (const Part& part : parts_)
    add_triangles(scene, part);
  if (std::ranges::any_of(parts_, &Part::meets_others)) find_neighbours(scene);
  rtcCommitScene(embree_->scene);
  embree_->check();
}

void Geometry::add_triangles(const scene::Scene& scene, const Part& part) {
  const scene::Indices& indices = scene.indices[static_cast<std::size_t>(part.primitive->indices)];
  const Embree::Mesh mesh = embree_->add(
      part, scene.streams[static_cast<std::size_t>(part.primitive->positions)], indices, centre_);
  const scene::Stream& normals = scene.streams[static_cast<std::size_t>(part.primitive->normals)];
  first_triangle_.push_back(triangles_.size());
  triangles_.reserve(triangles_.size() + indices.size() / 3);
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    Triangle& triangle = triangles_.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      triangle.vertices[k] = indices[i + k];
      triangle.corners[k] = mesh.vertex(indices[i + k]);
      const glm::dvec3 n = part.normal_from_mesh * vertex(normals, indices[i + k]);
      const double length = glm::length(n);
      triangle.normals[k] = length > 0.0 ? glm::vec3(n / length) : glm::vec3(0.0f);
    }
  }
}

void Geometry::find_neighbours(const scene::Scene& scene) {
  neighbourhoods_.emplace(scene.bounds);
  for (std::size_t i = 0; i < parts_.size(); ++i)
    if (parts_[i].meets_others)
      for_triangles(scene, parts_[i], [&](std::size_t, const scene::Bounds& bounds) {
        neighbourhoods_->add(static_cast<std::uint32_t>(i), bounds);
      });
  neighbourhoods_->close();
  for (std::size_t i = 0; i < parts_.size(); ++i)
    if (parts_[i].meets_others)
      for_triangles(scene, parts_[i], [&](std::size_t k, const scene::Bounds& bounds) {
        triangles_[first_triangle_[i] + k].near_others = neighbourhoods_->several(bounds);
      });
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

  return hit_of(query.hit.geomID, query.hit.primID, static_cast<double>(query.hit.u),
                static_cast<double>(query.hit.v));
}

Hit Geometry::hit_of(unsigned geometry, unsigned number, double u, double v) const {
  const Triangle& triangle = triangles_[first_triangle_[geometry] + number];
  Hit hit;
  hit.part = &parts_[geometry];
  hit.near_others = triangle.near_others;
  std::copy_n(triangle.vertices, 3, hit.vertices);
  hit.weights = {1.0 - u - v, u, v};
  const glm::dvec3 p[3] = {glm::dvec3(triangle.corners[0]), glm::dvec3(triangle.corners[1]),
                           glm::dvec3(triangle.corners[2])};
  for (int k = 0; k < 3; ++k)
    hit.smooth += hit.weights[k] * glm::dvec3(triangle.normals[k]);
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

namespace {

// A query that asks for everything on its way.
struct Everything {
  RTCIntersectContext context; // first: Embree hands back its address
  const Part* parts;
  const Part* except;
  struct Met {
    unsigned geometry, triangle;
    double u, v;
  };
  std::vector<Met> met;
};

void note_and_go_on(const RTCFilterFunctionNArguments* args) {
  auto& all = *reinterpret_cast<Everything*>(args->context);
  for (unsigned i = 0; i < args->N; ++i) {
    if (args->valid[i] != -1) continue;
    args->valid[i] = 0;
    const unsigned geometry = RTCHitN_geomID(args->hit, args->N, i);
    const bool known =
        std::ranges::any_of(all.met, [&](const auto& m) { return m.geometry == geometry; });
    if (&all.parts[geometry] == all.except || known) continue;
    all.met.push_back({geometry, RTCHitN_primID(args->hit, args->N, i),
                       static_cast<double>(RTCHitN_u(args->hit, args->N, i)),
                       static_cast<double>(RTCHitN_v(args->hit, args->N, i))});
  }
}

} // namespace

std::vector<Hit> Geometry::touching(const Hit& hit, const glm::dvec3& direction) const {
  std::vector<Hit> found;
  if (!hit.near_others || !neighbourhoods_->several(hit.position)) return found;
  // Across the hit, from one side's `leave` to the other's.
  const double offset = leave_offset * hit.scale;
  const glm::dvec3 across = glm::dot(direction, hit.normal) < 0.0 ? -hit.normal : hit.normal;
  RTCRayHit query{};
  query.ray = embree_ray({hit.position - offset * across, across, 0.0, 2.0 * offset}, centre_);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  Everything all{.context = {}, .parts = parts_.data(), .except = hit.part, .met = {}};
  rtcInitIntersectContext(&all.context);
  all.context.filter = note_and_go_on;
  rtcIntersect1(embree_->scene, &all.context, &query);
  for (const Everything::Met& met : all.met)
    found.push_back(hit_of(met.geometry, met.triangle, met.u, met.v));
  return found;
}

bool Geometry::occluded(const Ray& ray) const {
  RTCRay query = embree_ray(ray, centre_);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(embree_->scene, &context, &query);
  return query.tfar < 0.0f;
}

glm::dvec3 Geometry::leave(const Hit& hit, const glm::dvec3& w) const {
  const double offset = leave_offset * hit.scale;
  return hit.position + (glm::dot(w, hit.normal) >= 0.0 ? offset : -offset) * hit.normal;
}

} // namespace gg::truth
