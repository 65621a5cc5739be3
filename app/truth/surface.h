// What the material and its maps say about a point that a ray met: the same rules as the raster's
// shaders/stages/surface.glsl.
#pragma once

#include "truth/closure.h"
#include "truth/geometry.h"
#include "truth/textures.h"

namespace gg::truth {

enum class SurfaceKind {
  unlit,  // shows its colour and nothing else
  opaque, // scatters on the side that it is seen from
  thin,   // a wall of no thickness, or a plate: two interfaces at one place of the mesh
  solid   // one interface between two media
};

// Directions are world and unit; `front` says which side wo is on.
struct Surface {
  Hit hit;
  SurfaceKind kind = SurfaceKind::opaque;
  const scene::Material* material = nullptr;
  glm::dvec3 wo{0.0};        // to the viewer
  glm::dvec3 geometric{0.0}; // the triangle's normal, on wo's side
  glm::dvec3 n{0.0};         // shading normal, on wo's side
  bool front = true;

  glm::dvec3 base_color{1.0}, emissive{0.0}, specular_color{1.0};
  double metallic = 0.0, alpha = 0.0, specular = 1.0, occlusion = 1.0;
  double transmission = 0.0;         // share of the dielectric's base that is refracted
  double thickness = 0.0;            // of a plate, metres: a sheet with a volume that has no inside
  double diffuse_transmission = 0.0; // share of an opaque base's light that comes out behind it
  glm::dvec3 diffuse_transmission_color{1.0};
  std::optional<Coat> coat;
  std::optional<ThinFilm> film;
  std::optional<Brushing> brushing;
  bool tinted_reflectance = false; // by specular and specular_color: Schlick's form
};

// The least turn of n that puts the viewer above it: interpolated and mapped normals can turn away
// from a viewer who sees the surface, and microfacet theory has no answer there.
glm::dvec3 face_viewer(const glm::dvec3& n, const glm::dvec3& wo);

class Surfaces {
public:
  explicit Surfaces(const scene::Scene& scene) : scene_(scene), textures_(scene) {}

  // How much of the surface is there at the hit, in [0, 1], without reading the rest.
  double coverage(const Hit& hit) const;
  // True if coverage() can be less than 1.
  static bool has_holes(const scene::Material& material);
  Surface read(const Hit& hit, const glm::dvec3& wo) const;

private:
  glm::dvec2 uv(const Hit& hit, int set) const;
  bool reads(const Hit& hit, const scene::Slot& slot) const;
  glm::dvec4 map(const Hit& hit, const scene::Slot& slot, Encoding encoding) const;
  glm::dvec4 interpolate(const Hit& hit, scene::Index stream) const;
  glm::dvec3 direction(const Hit& hit, scene::Index stream, const glm::dmat3& world) const;
  glm::dvec4 base_color(const Hit& hit) const;
  struct Basis {
    glm::dvec3 normal, tangent, bitangent; // as they are interpolated, on the front side
  };
  Basis basis(const Hit& hit) const;
  // On the front side, unit; bent by the map if the mesh has what it takes.
  glm::dvec3 normal(const Hit& hit, const Basis& basis, const scene::Slot& bent_by) const;
  void read_layers(const Hit& hit, const Basis& basis, Surface& s) const;

  const scene::Scene& scene_;
  Textures textures_;
};

// The interface that the surface shows to wo, between media of these indices (near: where wo is).
// A wall's or a solid's base colour tints what is transmitted by `tint`. from_within: wo is on the
// side of a solid's glass, where an opaque base hides the coat.
Interface interface_of(const Surface& surface, double near_ior, double far_ior, Smith smith,
                       const glm::dvec3& tint, bool from_within);

} // namespace gg::truth
