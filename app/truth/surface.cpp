#include "truth/surface.h"

#include <algorithm>
#include <cmath>

namespace gg::truth {
namespace {

using scene::Material;

SurfaceKind kind_of(const Part& part) {
  const Material& m = *part.material;
  if (m.unlit) return SurfaceKind::unlit;
  if (!(m.transmission > 0.0f)) return SurfaceKind::opaque;
  return part.solid ? SurfaceKind::solid : SurfaceKind::thin;
}

// A coloured or weakened reflectance has no IOR: Schlick's form is used.
// glTF's ior 0 asks for F = 1 at every angle, which Schlick's form gives with F0 = 1.
bool has_tinted_reflectance(const Material& m) {
  return m.specular != 1.0f || m.specular_color != glm::vec3(1.0f) || m.ior == 0.0f
         || m.specular_map || m.specular_color_map;
}

} // namespace

glm::dvec3 face_viewer(const glm::dvec3& n, const glm::dvec3& wo) {
  // Exactly on the horizon rounding would decide whether there is a reflection; a microradian above
  // it none does, and no picture shows the difference.
  constexpr double above_horizon = 1e-6;
  const double c = glm::dot(n, wo);
  return c >= above_horizon ? n : glm::normalize(n - (c - above_horizon) * wo);
}

bool Surfaces::has_holes(const Material& material) {
  return material.alpha_mode != scene::AlphaMode::opaque;
}

glm::dvec4 Surfaces::interpolate(const Hit& hit, scene::Index index) const {
  const scene::Stream& stream = scene_.streams[static_cast<std::size_t>(index)];
  const std::size_t components = static_cast<std::size_t>(stream.components);
  glm::dvec4 sum(0.0);
  for (int corner = 0; corner < 3; ++corner) {
    const float* v = stream.values.data() + components * hit.vertices[corner];
    for (std::size_t c = 0; c < components && c < 4; ++c)
      sum[static_cast<int>(c)] += hit.weights[corner] * static_cast<double>(v[c]);
  }
  return sum;
}

bool Surfaces::reads(const Hit& hit, const scene::Slot& slot) const {
  const auto& uvs = hit.part->primitive->uvs;
  return slot && slot.uv_set < static_cast<int>(uvs.size())
         && uvs[static_cast<std::size_t>(slot.uv_set)] != scene::none;
}

glm::dvec2 Surfaces::uv(const Hit& hit, int set) const {
  return glm::dvec2(interpolate(hit, hit.part->primitive->uvs[static_cast<std::size_t>(set)]));
}

// White where the primitive has no such coordinates: glTF has no meaning for it.
glm::dvec4 Surfaces::map(const Hit& hit, const scene::Slot& slot, Encoding encoding) const {
  if (!reads(hit, slot)) return glm::dvec4(1.0);
  return textures_.at(slot, uv(hit, slot.uv_set), encoding);
}

glm::dvec4 Surfaces::base_color(const Hit& hit) const {
  const Material& m = *hit.part->material;
  glm::dvec4 color = glm::dvec4(m.base_color) * map(hit, m.base_color_map, Encoding::srgb);
  if (const scene::Index colors = hit.part->primitive->colors; colors != scene::none) {
    glm::dvec4 vertex = interpolate(hit, colors);
    if (scene_.streams[static_cast<std::size_t>(colors)].components < 4) vertex.w = 1.0;
    color *= vertex;
  }
  return color;
}

double Surfaces::coverage(const Hit& hit) const {
  const Material& m = *hit.part->material;
  if (!has_holes(m)) return 1.0;
  const double alpha = base_color(hit).w;
  if (m.alpha_mode == scene::AlphaMode::blend) return std::clamp(alpha, 0.0, 1.0);
  return alpha < static_cast<double>(m.alpha_cutoff) ? 0.0 : 1.0;
}

// A stream of directions, made unit in the world at the corners and interpolated between them.
glm::dvec3 Surfaces::direction(const Hit& hit, scene::Index index, const glm::dmat3& world) const {
  const scene::Stream& stream = scene_.streams[static_cast<std::size_t>(index)];
  const std::size_t components = static_cast<std::size_t>(stream.components);
  glm::dvec3 sum(0.0);
  for (int corner = 0; corner < 3; ++corner) {
    const float* v = stream.values.data() + components * hit.vertices[corner];
    const glm::dvec3 moved = world * glm::dvec3(v[0], v[1], v[2]);
    const double length = glm::length(moved);
    if (length > 0.0) sum += (hit.weights[corner] / length) * moved;
  }
  return sum;
}

// MikkTSpace: the basis is unit at the corners, interpolated, and used as it arrives, neither made
// unit nor orthogonal again.
Surfaces::Basis Surfaces::basis(const Hit& hit) const {
  const Part& part = *hit.part;
  Basis b{.normal = hit.smooth, .tangent = glm::dvec3(0.0), .bitangent = glm::dvec3(0.0)};
  if (part.primitive->tangents == scene::none) return b;
  b.tangent = direction(hit, part.primitive->tangents, glm::dmat3(part.world_from_mesh));
  const double sign = interpolate(hit, part.primitive->tangents).w;
  b.bitangent = (part.mirrored ? -sign : sign) * glm::cross(b.normal, b.tangent);
  return b;
}

glm::dvec3 Surfaces::normal(const Hit& hit, const Basis& b, const scene::Slot& bent_by) const {
  glm::dvec3 n = b.normal;
  if (hit.part->primitive->tangents != scene::none && reads(hit, bent_by)) {
    glm::dvec3 bend = glm::dvec3(map(hit, bent_by, Encoding::linear)) * 2.0 - 1.0;
    const double scale = static_cast<double>(bent_by.scale);
    bend.x *= scale, bend.y *= scale;
    n = bend.x * b.tangent + bend.y * b.bitangent + bend.z * b.normal;
  }
  const double length = glm::length(n);
  return length > 0.0 && std::isfinite(length) ? n / length : hit.normal;
}

// What lies over the base and how it is brushed: KHR_materials_clearcoat, _iridescence, _anisotropy. Coats and films lie on the
// outside of glass; a wall's own faces are told apart by the integrator.
void Surfaces::read_layers(const Hit& hit, const Basis& b, Surface& s) const {
  const Material& m = *s.material;
  const bool outside = s.kind != SurfaceKind::solid || s.front;
  if (m.clearcoat > 0.0f && outside) {
    const double roughness = static_cast<double>(m.clearcoat_roughness)
                             * map(hit, m.clearcoat_roughness_map, Encoding::linear).y;
    const glm::dvec3 n = normal(hit, b, m.clearcoat_normal_map);
    s.coat = Coat{.strength = static_cast<double>(m.clearcoat)
                              * map(hit, m.clearcoat_map, Encoding::linear).x,
                  .alpha = roughness * roughness,
                  .n = face_viewer(s.front ? n : -n, s.wo)};
  }
  if (m.iridescence > 0.0f && outside) {
    const double at = map(hit, m.iridescence_thickness_map, Encoding::linear).y;
    const glm::dvec2 thickness(m.iridescence_thickness);
    s.film = ThinFilm{.share = static_cast<double>(m.iridescence)
                               * map(hit, m.iridescence_map, Encoding::linear).x,
                      .ior = static_cast<double>(m.iridescence_ior),
                      .thickness = thickness.x + (thickness.y - thickness.x) * at};
    if (!(s.film->thickness > 0.0)) s.film.reset();
  }
  if (m.anisotropy_strength > 0.0f && m.distribution == scene::Distribution::ggx
      && hit.part->primitive->tangents != scene::none) {
    double strength = static_cast<double>(m.anisotropy_strength);
    glm::dvec2 along(1.0, 0.0);
    if (reads(hit, m.anisotropy_map)) {
      const glm::dvec4 texel = map(hit, m.anisotropy_map, Encoding::linear);
      along = glm::dvec2(texel) * 2.0 - 1.0;
      strength *= texel.z;
    }
    const double turn = static_cast<double>(m.anisotropy_rotation);
    const double c = std::cos(turn), sine = std::sin(turn);
    along = {c * along.x - sine * along.y, sine * along.x + c * along.y};
    glm::dvec3 world = along.x * b.tangent + along.y * b.bitangent;
    world -= glm::dot(world, s.n) * s.n;
    if (const double length = glm::length(world); length > 0.0 && strength > 0.0)
      s.brushing =
          Brushing{.alpha = glsl::f64::ggxAnisoWidths(s.alpha, strength), .along = world / length};
  }
}

Surface Surfaces::read(const Hit& hit, const glm::dvec3& wo) const {
  const Material& m = *hit.part->material;
  Surface s;
  s.hit = hit;
  s.material = &m;
  s.kind = kind_of(*hit.part);
  s.wo = wo;
  s.front = glm::dot(hit.normal, wo) >= 0.0;
  s.geometric = s.front ? hit.normal : -hit.normal;
  const glm::dvec4 base = base_color(hit);
  s.base_color = glm::dvec3(base);
  if (s.kind == SurfaceKind::unlit) return s;

  const Basis b = basis(hit);
  const glm::dvec3 n = normal(hit, b, m.normal_map);
  s.n = face_viewer(s.front ? n : -n, wo); // glTF: a back face's normal is turned before lighting

  double roughness = static_cast<double>(m.roughness);
  s.metallic = m.conductor ? 1.0 : static_cast<double>(m.metallic);
  if (reads(hit, m.metallic_roughness_map)) {
    const glm::dvec4 texel = map(hit, m.metallic_roughness_map, Encoding::linear);
    if (!m.conductor) s.metallic *= texel.z;
    roughness *= texel.y;
  }
  s.alpha = m.exact_alpha ? static_cast<double>(*m.exact_alpha) : roughness * roughness;
  if (!s.front && s.kind == SurfaceKind::solid && m.back_alpha)
    s.alpha = static_cast<double>(*m.back_alpha);
  s.tinted_reflectance = has_tinted_reflectance(m);
  s.specular = static_cast<double>(m.specular) * map(hit, m.specular_map, Encoding::linear).w;
  s.specular_color =
      glm::dvec3(m.specular_color) * glm::dvec3(map(hit, m.specular_color_map, Encoding::srgb));
  if (s.kind == SurfaceKind::thin || s.kind == SurfaceKind::solid)
    s.transmission =
        static_cast<double>(m.transmission) * map(hit, m.transmission_map, Encoding::linear).x;
  if (s.kind == SurfaceKind::thin && m.thickness > 0.0f) {
    // In units of the mesh: the mean of its axes' lengths, as in the raster.
    const glm::dmat4& world = hit.part->world_from_mesh;
    const double unit = (glm::length(glm::dvec3(world[0])) + glm::length(glm::dvec3(world[1]))
                         + glm::length(glm::dvec3(world[2])))
                        / 3.0;
    s.thickness =
        unit * static_cast<double>(m.thickness) * map(hit, m.thickness_map, Encoding::linear).y;
  }
  if (reads(hit, m.occlusion_map))
    s.occlusion = 1.0
                  + static_cast<double>(m.occlusion_map.scale)
                        * (map(hit, m.occlusion_map, Encoding::linear).x - 1.0);
  s.emissive = glm::dvec3(m.emissive) * glm::dvec3(map(hit, m.emissive_map, Encoding::srgb));
  if (s.kind == SurfaceKind::opaque && m.diffuse_transmission > 0.0f) {
    s.diffuse_transmission = static_cast<double>(m.diffuse_transmission)
                             * map(hit, m.diffuse_transmission_map, Encoding::linear).w;
    s.diffuse_transmission_color =
        glm::dvec3(m.diffuse_transmission_color)
        * glm::dvec3(map(hit, m.diffuse_transmission_color_map, Encoding::srgb));
  }
  read_layers(hit, b, s);
  if (s.coat) // what the base emits is under it
    s.emissive *= 1.0 - glsl::f64::coatShare(s.coat->strength, glm::dot(s.coat->n, s.wo));
  return s;
}

Interface interface_of(const Surface& s, double near_ior, double far_ior, Smith smith,
                       const glm::dvec3& tint, bool from_within) {
  const Material& m = *s.material;
  Interface i;
  i.distribution = m.distribution;
  i.alpha = s.alpha;
  i.smith = smith;
  i.eta = near_ior > 0.0 ? far_ior / near_ior : 0.0;
  i.metallic = s.metallic;
  i.metal_f0 = s.base_color;
  if (m.conductor) {
    const float near = static_cast<float>(near_ior > 0.0 ? near_ior : 1.0);
    i.metal = scene::Conductor{m.conductor->n / near, m.conductor->k / near};
  }
  if (s.tinted_reflectance) {
    // KHR_materials_specular: f0 = min(f0 of the index * colour, 1) * strength, f90 = strength.
    const double f0 = i.eta > 0.0 ? glsl::f64::fresnelNormalIncidence(i.eta) : 1.0;
    i.tinted = TintedReflectance{glm::min(f0 * s.specular_color, glm::dvec3(1.0)) * s.specular,
                                 s.specular};
  }
  i.diffuse = (1.0 - s.transmission) * (1.0 - s.diffuse_transmission) * s.base_color;
  i.diffuse_behind = s.diffuse_transmission * s.diffuse_transmission_color;
  i.transmit = s.transmission * tint;
  if (from_within) i.coated = s.transmission;
  i.coat = s.coat;
  i.film = s.film;
  i.brushing = s.brushing;
  return i;
}

} // namespace gg::truth
