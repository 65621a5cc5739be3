#include "viewer/sight.h"

#include "glsl/f64.h"
#include "image/heat_map.h"
#include "needs/features.h"
#include "needs/tables.h"
#include "tables/lookup.h"
#include "truth/geometry.h"
#include "uniforms/camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

namespace gg::viewer {
namespace {

namespace f64 = gg::glsl::f64;

constexpr std::array<float, 3> environment_colour{0.13f, 0.33f, 0.80f},
    screen_colour{1.0f, 0.65f, 0.20f};

// One standard deviation from the middle in eight directions, and two further out: what a share is counted by.
constexpr std::array<glm::dvec2, 8> lobe_places = {{{0.5, 0.0},
                                                    {0.0, 0.5},
                                                    {-0.5, 0.0},
                                                    {0.0, -0.5},
                                                    {1.1, 1.1},
                                                    {-1.1, 1.1},
                                                    {-1.1, -1.1},
                                                    {1.1, -1.1}}};

struct Lobe {
  glm::dvec3 from, direction; // where it leaves, unit
  double sigma = 0.0;         // radians, there
  double inside = 0.0;        // its spread where it leaves, metres
};

// Pixels across which a radian, or at a distance of a metre a metre, is seen.
double pixels_per_unit(const scene::Camera& camera, int height) {
  return camera.orthographic ? height / (2.0 * static_cast<double>(camera.magnification.y))
                             : height / (2.0 * std::tan(0.5 * static_cast<double>(camera.fovy)));
}

} // namespace

struct Sight::Tracer {
  explicit Tracer(std::shared_ptr<const scene::Scene> of)
      : scene(std::move(of)), geometry(*scene) {}
  std::shared_ptr<const scene::Scene> scene;
  truth::Geometry geometry;

  std::optional<Lobe> lobe(const truth::Hit& hit, const glm::dvec3& direction,
                           const needs::View& view) const;
  double sigma_in_pixels(const Lobe& lobe, const Seen& seen) const;
  double screen_share(const Lobe& lobe, const glm::dmat4& clip) const;
};

std::optional<Lobe> Sight::Tracer::lobe(const truth::Hit& hit, const glm::dvec3& direction,
                                        const needs::View& view) const {
  const scene::Material& m = *hit.part->material;
  if (!needs::is_refractive(m)) return std::nullopt;
  const double eta = static_cast<double>(m.ior);
  glm::dvec3 normal = hit.normal;
  if (glm::dot(normal, direction) > 0.0) normal = -normal;
  // Grazing lines of sight: the tables' first node is no nearer to the horizon.
  const double cosine = std::clamp(-glm::dot(normal, direction), 1e-3, 1.0);
  const double alpha = static_cast<double>(scene::microfacet_alpha(m));
  double sigma = 0.0;
  if (alpha > 0.0 && eta != 1.0) {
    const tables::Model model = needs::model_of(m, view.correlated_smith);
    const int lobes = std::max(needs::interface_lobes(view.method), 1);
    double mean = 0.0, square = 0.0;
    for (int k = 0; k < lobes; ++k) {
      const auto one = tables::interface_lobe_at(model, k, lobes, cosine, alpha, eta);
      mean += one.weight * one.angle;
      square += one.weight * (one.sigma * one.sigma + one.angle * one.angle);
    }
    sigma = std::sqrt(std::max(square - mean * mean, 0.0));
  }
  if (!(m.thickness > 0.0f)) return Lobe{geometry.leave(hit, direction), direction, sigma, 0.0};

  const auto refracted = [](const glm::dvec3& d, const glm::dvec3& n, double relative) {
    const f64::vec3 wi = f64::refractAbout(-d, n, relative);
    return glm::dvec3(wi.x, wi.y, wi.z);
  };
  glm::dvec3 within = eta == 1.0 ? direction : refracted(direction, normal, eta);
  glm::dvec3 at = geometry.leave(hit, within);
  double length = 0.0;
  for (int bounce = 0; bounce <= needs::most_bounces; ++bounce) {
    const auto back = geometry.intersect({at, within});
    if (!back) return std::nullopt; // not closed
    length += glm::distance(at, back->position);
    const glm::dvec3 n = glm::dot(back->normal, within) > 0.0 ? -back->normal : back->normal;
    const glm::dvec3 out = eta == 1.0 ? within : refracted(within, n, 1.0 / eta);
    if (out != glm::dvec3(0.0))
      // Small angles grow by the IOR where they leave.
      return Lobe{geometry.leave(*back, out), glm::normalize(out), eta * sigma, sigma * length};
    within = glm::reflect(within, n);
    at = geometry.leave(*back, within);
  }
  return std::nullopt;
}

double Sight::Tracer::sigma_in_pixels(const Lobe& lobe, const Seen& seen) const {
  const double scale = pixels_per_unit(seen.camera, seen.height);
  const auto met = geometry.intersect({lobe.from, lobe.direction});
  if (!met) return seen.camera.orthographic ? 0.0 : lobe.sigma * scale;
  const double spread = lobe.inside + lobe.sigma * glm::distance(lobe.from, met->position);
  if (seen.camera.orthographic) return spread * scale;
  const glm::dvec3 eye(seen.camera.world[3]), forward = -glm::dvec3(seen.camera.world[2]);
  const double depth = glm::dot(met->position - eye, glm::normalize(forward));
  return depth > 0.0 ? spread * scale / depth : 0.0;
}

double Sight::Tracer::screen_share(const Lobe& lobe, const glm::dmat4& clip) const {
  const glm::dvec3 d = lobe.direction;
  const glm::dvec3 x = glm::normalize(
      glm::cross(std::abs(d.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0), d));
  const glm::dvec3 y = glm::cross(d, x);
  int seen = 0;
  for (const glm::dvec2& place : lobe_places) {
    const glm::dvec3 along = glm::normalize(d + lobe.sigma * (place.x * x + place.y * y));
    const auto met = geometry.intersect({lobe.from, along});
    if (!met) continue;
    const glm::dvec4 p = clip * glm::dvec4(met->position, 1.0);
    if (p.w > 0.0 && std::abs(p.x) <= p.w && std::abs(p.y) <= p.w) ++seen;
  }
  return static_cast<double>(seen) / static_cast<double>(lobe_places.size());
}

Sight::Sight(std::shared_ptr<const scene::Scene> scene)
    : tracer_(std::make_unique<const Tracer>(std::move(scene))) {}

Sight::~Sight() = default;

DebugView::Drawn Sight::draw(const Seen& seen, const needs::Needs& needs) const {
  // The frame's draws are of a copy of the scene: by instance and place in its mesh.
  std::map<std::pair<std::ptrdiff_t, std::ptrdiff_t>, int> lookups;
  for (const needs::Draw& draw : needs.draws.all) {
    const scene::Instance* instance = needs.draws.instances[draw.instance_index];
    const auto& parts = needs.scene->meshes[static_cast<std::size_t>(instance->mesh)].primitives;
    lookups[{instance - needs.scene->instances.data(), draw.primitive - parts.data()}] =
        needs::lookups_of(draw, needs.view.method).sum();
  }
  const auto value = [&](const truth::Hit& hit, const glm::dvec3& direction,
                         const glm::dmat4& clip) -> double {
    if (seen.kind == DebugKind::samples) {
      const auto& of = tracer_->scene->instances[static_cast<std::size_t>(hit.part->instance)];
      const auto& parts = tracer_->scene->meshes[static_cast<std::size_t>(of.mesh)].primitives;
      const auto found = lookups.find({hit.part->instance, hit.part->primitive - parts.data()});
      return found == lookups.end() ? -1.0 : seen.samples * found->second;
    }
    const auto lobe = tracer_->lobe(hit, direction, needs.view);
    if (!lobe) return -1.0;
    return seen.kind == DebugKind::sigma_in_pixels ? tracer_->sigma_in_pixels(*lobe, seen)
                                                   : tracer_->screen_share(*lobe, clip);
  };

  // One line of sight for each square of pixels: some 20,000 of them.
  const double wanted = seen.coarse ? 2000.0 : 20000.0;
  const int side = std::max(1, static_cast<int>(std::ceil(std::sqrt(static_cast<double>(seen.width)
                                                                    * seen.height / wanted))));
  const int columns = (seen.width + side - 1) / side, rows = (seen.height + side - 1) / side;
  const truth::Camera camera(seen.camera, seen.width, seen.height);
  const glm::dmat4 clip =
      uniforms::clip_from_view(seen.camera, static_cast<double>(seen.width) / seen.height)
      * uniforms::view_from_world(seen.camera);
  std::vector<double> values(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows),
                             -1.0);
  DebugView::Drawn drawn{.colours = image::Image(seen.width, seen.height, 3)};
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const truth::Ray ray = camera.through((column + 0.5) * side, (row + 0.5) * side);
      const auto hit = tracer_->geometry.intersect(ray);
      if (!hit) continue;
      double& v = values[static_cast<std::size_t>(row * columns + column)];
      v = value(*hit, ray.direction, clip);
      drawn.greatest = std::max(drawn.greatest, v);
    }
  for (int y = 0; y < seen.height; ++y)
    for (int x = 0; x < seen.width; ++x) {
      const double v = values[static_cast<std::size_t>(y / side * columns + x / side)];
      if (v < 0.0) continue;
      std::array<float, 3> colour{};
      if (seen.kind == DebugKind::screen_share)
        for (std::size_t c = 0; c < 3; ++c)
          colour[c] = static_cast<float>(std::lerp(static_cast<double>(environment_colour[c]),
                                                   static_cast<double>(screen_colour[c]), v));
      else if (drawn.greatest > 0.0)
        colour = image::heat_colour(v / drawn.greatest);
      for (int c = 0; c < 3; ++c)
        drawn.colours.at(x, y, c) = colour[static_cast<std::size_t>(c)];
    }
  return drawn;
}

} // namespace gg::viewer
