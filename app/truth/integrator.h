// The light that arrives along a ray: all of it, or what a surface makes of the environment by
// itself.
//
// A path is followed from the camera. At every interface the next direction is drawn from the BSDF
// (visible normals, then reflection or refraction by Fresnel's shares), and direct light is
// gathered: from the environment by multiple importance sampling (power heuristic) of the BSDF and
// of the map's brightness, from a punctual light, which no ray can hit, by a shadow ray.
//
// Splitting and Russian roulette [ArvoKirk90]. Glass reflects a few hundredths of the light; were
// that followed by chance, the few paths that are would count in full, and a lamp that one of them
// finds would be a firefly. So where both parts of what an interface scatters carry enough
// (`worth_following`: more after rough interfaces than after smooth ones) both are followed, each with
// its own weight; and only paths that carry less are ended by chance. Unless it is asked for, nothing is cut off, clamped or thrown away: the mean has
// no bias, and rare bright paths show in the standard error.
//
// Dispersion. A path that comes to glass whose index depends on the wavelength goes on as three, of
// one channel each.
//
// Shading normals. A direction that leaves towards one side of the shading normal and the other
// side of the triangle would go through the surface the wrong way. Where the BSDF about the shading
// normal draws such a direction, its light is scattered by the BSDF about the triangle's normal
// instead; so no light is lost, none leaks, and where both normals agree nothing changes.
#pragma once

#include "truth/albedo.h"
#include "truth/environment_light.h"
#include "truth/intersection.h"
#include "truth/sample.h"

#include <optional>

namespace gg::truth {

enum class Transport {
  full,        // all paths of any length
  surface_only // the first visible surface, lit by everything through its BSDF alone: nothing
  // shadows, nothing is reflected twice. The environment is dimmed by the occlusion map,
  // which full transport ignores as it finds occlusion itself. Behind a solid's first
  // interface the environment goes on, radiance / index² kept
};

class Integrator {
public:
  struct Settings {
    Smith smith = Smith::separable;
    Transport transport = Transport::full;
    bool multiple_scattering = false; // between the facets of metals, as `capture --multiscatter`
    // The most that light which was scattered may bring along one path: its largest channel, radiance.
    // Less noise for less light: the mean is too small by what Sample::clamped says on average.
    double clamp = INFINITY;
    // What rays of the camera see that meet nothing; light comes from the environment as it is.
    struct Background {
      double sigma = 0.0;              // radians, of a Gaussian over the environment
      std::optional<glm::dvec3> plain; // radiance, in its place
    } background;
  };

  // Without an environment only lights and emissive surfaces shine. `eye`: where perspective rays
  // start; the solids around it are found once.
  Integrator(const scene::Scene& scene, const EnvironmentLight* environment,
             const std::optional<glm::dvec3>& eye, const Settings& settings);

  Sample trace(const Ray& camera_ray, Random& random) const;

private:
  struct Walk;

  void advance(Walk& walk, Path path) const;
  void meet(Walk& walk, Path path, Intersection& intersection, SolidId medium, SolidId next) const;
  void scatter(Walk& walk, const Path& path, const Intersection& intersection) const;
  void follow(Walk& walk, Path path, const Intersection& intersection, const Drawn& drawn,
              const Closure& closure) const;
  void cross_plate(Path& path, Intersection& intersection, const glm::dvec3& wi) const;
  bool survives(Walk& walk, Path& path, double worth_following) const;
  void add_environment(Walk& walk, const Path& path) const;
  void add_background(Walk& walk, const Path& path) const;
  // What a path brings to its sample, clamped if it was scattered.
  void add(Walk& walk, const Path& path, const glm::dvec3& radiance) const;

  // direct_light.cpp
  void add_direct_light(Walk& walk, Path path, const Intersection& intersection,
                        const Closure& closure) const;
  glm::dvec3 shadow(Ray ray, glm::dvec3 from, Whereabouts where, int channel, bool through_walls,
                    Random& random) const;
  glm::dvec3 straight_through(const Crossing& crossing, const Ray& ray, int channel,
                              bool through_walls) const;

  std::optional<glm::dvec3> unbent(const Surface& surface, SolidId medium, SolidId next,
                                   int channel) const;
  Closure closure_at(const Intersection& intersection, const Arriving& arriving) const;
  Interface interface_at(const Surface& surface, double near_ior, double far_ior,
                         const glm::dvec3& tint, bool from_within) const;

  const scene::Scene& scene_;
  const EnvironmentLight* environment_;
  Settings settings_;
  Geometry geometry_;
  Media media_;
  Surfaces surfaces_;
  Whereabouts around_eye_;
  // Some surface may let a straight ray from air pass: through holes or a body that does not bend it,
  // and towards lights, which no path can meet, through a wall too.
  bool passes_straight_ = false, passes_to_lights_ = false;
  std::array<std::optional<Albedo>, 3>
      albedos_; // by distribution, where many bounces are asked for
};

} // namespace gg::truth
