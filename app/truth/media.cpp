#include "truth/media.h"

#include "scene/bodies.h"

#include <algorithm>
#include <cmath>

namespace gg::truth {

void Inside::enter(SolidId solid) {
  if (count_ == solids_.size()) {
    std::shift_left(solids_.begin(), solids_.end(), 1);
    --count_;
  }
  solids_[count_++] = solid;
}

void Inside::leave(SolidId solid) {
  auto* const last = solids_.data() + count_;
  // The order within does not matter, so the last one takes the place of the one that goes.
  if (auto* const found = std::find(solids_.data(), last, solid); found != last) {
    *found = *(last - 1);
    --count_;
  }
}

bool Inside::contains(SolidId solid) const {
  return std::find(begin(), end(), solid) != end();
}

Media::Media(const scene::Scene& scene, const Geometry& geometry) {
  std::map<std::pair<scene::Index, scene::Index>, SolidId> known;
  const std::vector<scene::Index> bodies = scene::body_materials(scene);
  std::vector<scene::Bounds> bounds;
  if (!geometry.parts().empty()) first_ = geometry.parts().data();
  for (const Part& part : geometry.parts()) {
    if (!part.solid) {
      of_part_.push_back(air);
      continue;
    }
    const scene::Index body = bodies[static_cast<std::size_t>(part.material_index)];
    const scene::Material& m = scene.materials[static_cast<std::size_t>(body)];
    const auto [entry, is_new] =
        known.try_emplace({part.instance, body}, static_cast<SolidId>(solids_.size()));
    if (is_new) {
      solids_.push_back({.ior = static_cast<double>(m.ior),
                         .dispersion = static_cast<double>(m.dispersion),
                         .attenuation_color = glm::dvec3(m.attenuation_color),
                         .attenuation_distance = static_cast<double>(m.attenuation_distance)});
      bounds.emplace_back();
    }
    const scene::Stream& positions =
        scene.streams[static_cast<std::size_t>(part.primitive->positions)];
    for (std::size_t i = 0; i + 2 < positions.values.size(); i += 3)
      bounds[static_cast<std::size_t>(entry->second)].include(
          glm::vec3(part.world_from_mesh
                    * glm::dvec4(positions.values[i], positions.values[i + 1],
                                 positions.values[i + 2], 1.0)));
    of_part_.push_back(entry->second);
  }
  for (std::size_t i = 0; i < solids_.size(); ++i) {
    const glm::dvec3 size(bounds[i].high - bounds[i].low);
    solids_[i].volume = size.x * size.y * size.z;
  }
}

SolidId Media::bounded_by(const Part& part) const {
  return of_part_[static_cast<std::size_t>(&part - first_)];
}

SolidId Media::at(const Inside& inside) const {
  SolidId found = air;
  for (const SolidId id : inside) {
    if (found == air || displaces(id, found)) found = id;
  }
  return found;
}

bool Media::displaces(SolidId a, SolidId b) const {
  const double volume = solids_[static_cast<std::size_t>(a)].volume;
  const double other = solids_[static_cast<std::size_t>(b)].volume;
  return volume < other || (volume == other && a > b);
}

double Media::ior(SolidId medium, int channel) const {
  if (medium == air) return 1.0;
  const Solid& solid = solids_[static_cast<std::size_t>(medium)];
  if (channel == white || solid.dispersion == 0.0) return solid.ior;
  // KHR_materials_dispersion: red below and blue above, by half of (ior - 1) / 20 times the
  // dispersion. As in the raster (shaders/stages/glass_faces.glsl) no index falls below a quarter.
  return std::max(solid.ior + 0.025 * (channel - 1) * (solid.ior - 1.0) * solid.dispersion, 0.25);
}

bool Media::disperses(SolidId medium) const {
  if (medium == air) return false;
  const Solid& solid = solids_[static_cast<std::size_t>(medium)];
  return solid.dispersion > 0.0 && solid.ior != 1.0;
}

bool Media::all_bend() const {
  for (SolidId id = 0; id < static_cast<SolidId>(solids_.size()); ++id)
    for (int channel = white; channel < 3; ++channel)
      if (ior(id, channel) == 1.0) return false;
  return true;
}

glm::dvec3 transmittance(const glm::dvec3& color, double depth) {
  if (!(depth > 0.0)) return glm::dvec3(1.0);
  return {std::pow(color.x, depth), std::pow(color.y, depth), std::pow(color.z, depth)};
}

glm::dvec3 Media::transmittance(SolidId medium, double distance) const {
  if (medium == air) return glm::dvec3(1.0);
  const Solid& solid = solids_[static_cast<std::size_t>(medium)];
  return truth::transmittance(solid.attenuation_color, distance / solid.attenuation_distance);
}

Inside solids_around(const glm::dvec3& point, const Geometry& geometry, const Media& media) {
  Inside found;
  if (media.empty()) return found;
  // A direction that is unlikely to run along a wall or through an edge of what people model.
  Ray ray{point, glm::normalize(glm::dvec3(0.3183, 0.8660, 0.4142))};
  std::map<SolidId, int> depth; // crossings in, less crossings out, since the point
  const auto pass = [&](const Hit& hit) {
    const SolidId solid = media.bounded_by(*hit.part);
    if (solid == air) return;
    // Left before it was entered: it was around the point.
    if (glm::dot(ray.direction, hit.normal) < 0.0)
      ++depth[solid];
    else if (--depth[solid] < 0) {
      found.enter(solid);
      ++depth[solid];
    }
  };
  while (const auto hit = geometry.intersect(ray)) {
    pass(*hit);
    for (const Hit& other : geometry.touching(*hit, ray.direction))
      if (media.bounded_by(*other.part) != media.bounded_by(*hit->part)) pass(other);
    ray.origin = geometry.leave(*hit, ray.direction);
  }
  return found;
}

} // namespace gg::truth
