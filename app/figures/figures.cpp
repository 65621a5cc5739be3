#include "figures/figures.h"

#include "core/error.h"
#include "figures/curves.h"
#include "figures/plot.h"
#include "scene/presets.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace gg::figures {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double glass_ior = 1.5;

Axis incidence_axis(double high = 90.0) {
  return {"angle of incidence", 0.0, high, ticks(0.0, high, high > 45.0 ? 15.0 : 5.0, 0, "°")};
}
Axis reflectance_axis() {
  return {"reflectance", 0.0, 1.0, ticks(0.0, 1.0, 0.2, 1)};
}

// y against an angle in degrees, fine enough for the square-root edge at a critical angle.
std::vector<Point> over_degrees(double high, const std::function<double(double)>& f) {
  return sampled(0.0, high, 1800, [&](double x) { return f(x * degree); });
}

// From dark to light, for quantities that have an order: even steps of luminance, told apart by all
// eyes.
Color ordered(std::size_t index, std::size_t count) {
  static constexpr std::array<Color, 7> ramp{{{0.267, 0.005, 0.329},
                                              {0.268, 0.224, 0.512},
                                              {0.191, 0.407, 0.556},
                                              {0.128, 0.567, 0.551},
                                              {0.208, 0.719, 0.473},
                                              {0.565, 0.804, 0.262},
                                              {0.880, 0.750, 0.090}}};
  return ramp[index * (ramp.size() - 1) / (count > 1 ? count - 1 : 1)];
}

std::vector<Curve> polarizations(double eta, double high) {
  const auto curve = [&](const char* label, Color color, Dash dash, Polarization polarization) {
    return Curve{label, color, dash,
                 over_degrees(high, [=](double x) { return fresnel(x, eta, polarization); })};
  };
  return {curve("s (across the plane of incidence)", ink::blue, Dash::dashed, Polarization::s),
          curve("p (in the plane)", ink::vermilion, Dash::dotted, Polarization::p),
          curve("mean: unpolarised light", ink::black, Dash::solid, Polarization::mean)};
}

void fresnel_glass(Canvas& canvas) {
  Plot plot{"Fresnel reflectance, air to glass", "IOR 1.5; 4 % at normal incidence",
            incidence_axis(), reflectance_axis(), polarizations(glass_ior, 90.0)};
  plot.marks = {{std::atan(glass_ior) / degree, "Brewster's angle, 56.3°", Anchor::end, 0.58}};
  draw(canvas, plot, {0.0, 0.0}, {560.0, 400.0});
}

constexpr std::array indices{1.1, 1.33, 1.5, 1.8, 2.4, 3.0, 4.0};

std::vector<Curve> by_ior(bool from_inside) {
  std::vector<Curve> curves;
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const double eta = from_inside ? 1.0 / indices[i] : indices[i];
    curves.push_back(
        {fmt::format("{:.4g}", indices[i]), ordered(i, indices.size()), Dash::solid,
         over_degrees(90.0, [=](double x) { return fresnel(x, eta, Polarization::mean); })});
  }
  return curves;
}

void fresnel_indices(Canvas& canvas) {
  const Plot plot{"Fresnel reflectance, air to other indices",
                  "unpolarised light; IOR of the far side", incidence_axis(), reflectance_axis(),
                  by_ior(false)};
  draw(canvas, plot, {0.0, 0.0}, {560.0, 400.0});
}

void fresnel_inside(Canvas& canvas) {
  Plot one{"From inside glass to air", "IOR 1.5; all is reflected past the critical angle",
           incidence_axis(), reflectance_axis(), polarizations(1.0 / glass_ior, 90.0)};
  one.marks = {{std::asin(1.0 / glass_ior) / degree, "critical angle, 41.8°", Anchor::start, 0.5}};
  one.legend = Legend::bottom_right;
  Plot all{"From inside by IOR to air", "unpolarised light; IOR of the near side", incidence_axis(),
           reflectance_axis(), by_ior(true)};
  all.legend = Legend::bottom_right;
  draw(canvas, one, {0.0, 0.0}, {500.0, 400.0});
  draw(canvas, all, {500.0, 0.0}, {1000.0, 400.0});
}

void fresnel_metals(Canvas& canvas) {
  constexpr std::array names{"gold", "copper", "silver", "aluminium", "iron", "chromium"};
  constexpr double width = 340.0, height = 300.0;
  for (std::size_t p = 0; p < names.size(); ++p) {
    const scene::Preset* metal = scene::find_preset(names[p]);
    Plot plot{names[p], {}, incidence_axis(), reflectance_axis(), {}};
    const std::array<std::pair<const char*, Curve>, 3> channels{
        {{"red", {"red", ink::vermilion, Dash::solid, {}}},
         {"green", {"green", ink::green, Dash::dashed, {}}},
         {"blue", {"blue", ink::blue, Dash::dotted, {}}}}};
    for (int c = 0; c < 3; ++c) {
      Curve curve = channels[static_cast<std::size_t>(c)].second;
      const double n = metal->conductor.n[c], k = metal->conductor.k[c];
      curve.label = fmt::format("{}: {:.3g} + {:.3g} i", curve.label, n, k);
      curve.points = over_degrees(90.0, [=](double x) { return fresnel_conductor(x, n, k); });
      plot.curves.push_back(std::move(curve));
    }
    plot.legend = Legend::bottom_left;
    const Point corner{width * static_cast<double>(p % 3), height * static_cast<double>(p / 3)};
    draw(canvas, plot, corner, {corner.x + width, corner.y + height});
  }
}

struct Shape {
  Distribution which;
  const char* name;
  Color color;
};
constexpr std::array<Shape, 3> shapes{{{Distribution::ggx, "GGX", ink::blue},
                                       {Distribution::beckmann, "Beckmann", ink::vermilion},
                                       {Distribution::phong, "Phong", ink::green}}};

void distributions(Canvas& canvas) {
  Plot linear{"D, the distribution of facets",
              "solid: slope width α = 0.5; dashed: α = 0.2",
              {"angle of the facet to the surface", 0.0, 60.0, ticks(0.0, 60.0, 10.0, 0, "°")},
              {"D (1 / sr)", 0.0, 8.0, ticks(0.0, 8.0, 2.0, 0)},
              {}};
  Plot tails{"The same on a logarithmic scale",
             "GGX has the long tail; it does not vanish at 90°",
             {"angle of the facet to the surface", 0.0, 90.0, ticks(0.0, 90.0, 15.0, 0, "°")},
             {"D (1 / sr)", -4.0, 1.0, {}},
             {}};
  for (int power = -4; power <= 1; ++power)
    tails.y.ticks.push_back(
        {static_cast<double>(power), fmt::format("{:g}", std::pow(10.0, power))});
  for (const double alpha : {0.5, 0.2})
    for (const Shape& shape : shapes) {
      const auto d = [=](double x) { return distribution(shape.which, alpha, x); };
      const std::string label = alpha == 0.5 ? shape.name : "";
      const Dash dash = alpha == 0.5 ? Dash::solid : Dash::dashed;
      linear.curves.push_back({label, shape.color, dash, over_degrees(60.0, d)});
      tails.curves.push_back({label, shape.color, dash, over_degrees(90.0, [=](double x) {
                                const double value = d(x);
                                // Below the axis of the plot, which ends at a millionth.
                                return value > 1e-6 ? std::log10(value)
                                                    : std::numeric_limits<double>::quiet_NaN();
                              })});
    }
  linear.legend = tails.legend = Legend::top_right;
  draw(canvas, linear, {0.0, 0.0}, {500.0, 400.0});
  draw(canvas, tails, {500.0, 0.0}, {1000.0, 400.0});
}

void shadowing_figure(Canvas& canvas) {
  Plot plot{"G1, what of a facet is seen from a direction",
            "Phong uses Beckmann's at the same width",
            {"angle of the direction to the normal", 0.0, 90.0, ticks(0.0, 90.0, 15.0, 0, "°")},
            {"G1", 0.0, 1.0, ticks(0.0, 1.0, 0.2, 1)},
            {}};
  const std::array<std::pair<double, Dash>, 3> widths{
      {{0.2, Dash::dotted}, {0.5, Dash::solid}, {1.0, Dash::dashed}}};
  for (std::size_t s = 0; s < 2; ++s)
    for (const auto& [alpha, dash] : widths)
      plot.curves.push_back(
          {fmt::format("{}, α = {}", s == 0 ? "GGX" : "Beckmann and Phong", alpha), shapes[s].color,
           dash, over_degrees(90.0, [=, a = alpha](double x) {
             return shadowing(shapes[s].which, a, x);
           })});
  plot.legend = Legend::bottom_left;
  draw(canvas, plot, {0.0, 0.0}, {560.0, 400.0});
}

void lobes(Canvas& canvas, double eta, const std::array<double, 4>& angles,
           const std::string& title) {
  constexpr double alpha = 0.3, width = 260.0, height = 370.0, top = 44.0;
  canvas.text({20.0, 24.0}, title, 13.0, ink::black, Anchor::start, Weight::bold);
  for (std::size_t p = 0; p < angles.size(); ++p) {
    const double incidence = angles[p] * degree;
    const PolarPanel panel{fmt::format("light from {:g}°", angles[p]), incidence,
                           reflected_lobe(incidence, alpha, eta),
                           transmitted_lobe(incidence, alpha, eta), eta < 1.0};
    const double left = width * static_cast<double>(p);
    draw(canvas, panel, {left, top}, {left + width, top + height});
  }
  draw_polar_legend(canvas, {20.0, top + height + 24.0});
}

void mean_directions(Canvas& canvas) {
  const auto panel = [](const std::string& title, double eta) {
    Plot plot{title,
              "IOR 1.5, GGX; averaged over f_t |o·n|",
              incidence_axis(),
              {"angle of the mean direction", 0.0, 90.0, ticks(0.0, 90.0, 15.0, 0, "°")},
              {}};
    const std::array<double, 4> widths{0.1, 0.3, 0.5, 0.8};
    for (std::size_t w = 0; w < widths.size(); ++w)
      plot.curves.push_back({fmt::format("α = {}", widths[w]), ordered(w, widths.size() + 1),
                             Dash::solid, sampled(0.0, 88.0, 44, [&](double x) {
                               return mean_transmitted(x * degree, widths[w], eta) / degree;
                             })});
    const double last = eta < 1.0 ? std::asin(eta) / degree : 90.0;
    plot.curves.push_back(
        {"Snell (α = 0)", ink::black, Dash::dashed, sampled(0.0, last, 900, [&](double x) {
           return std::asin(std::min(std::sin(x * degree) / eta, 1.0)) / degree;
         })});
    plot.legend = eta < 1.0 ? Legend::bottom_right : Legend::top_left;
    return plot;
  };
  draw(canvas, panel("Mean refracted direction, entering glass", glass_ior), {0.0, 0.0},
       {500.0, 400.0});
  draw(canvas, panel("Mean refracted direction, leaving glass", 1.0 / glass_ior), {500.0, 0.0},
       {1000.0, 400.0});
}

struct Figure {
  const char* name;
  double width, height;
  std::function<void(Canvas&)> draw;
};

std::vector<Figure> all_figures() {
  return {
      {"fresnel-glass", 560, 400, fresnel_glass},
      {"fresnel-indices", 560, 400, fresnel_indices},
      {"fresnel-inside", 1000, 400, fresnel_inside},
      {"fresnel-metals", 1020, 600, fresnel_metals},
      {"distributions", 1000, 400, distributions},
      {"shadowing", 560, 400, shadowing_figure},
      {"lobes-entering", 1040, 455,
       [](Canvas& c) {
         lobes(c, glass_ior, {0, 30, 60, 80}, "Rough glass from outside: IOR 1.5, GGX, α = 0.3");
       }},
      {"lobes-leaving", 1040, 455,
       [](Canvas& c) {
         lobes(c, 1.0 / glass_ior, {0, 20, 38, 60},
               "Rough glass from inside: IOR 1.5, GGX, α = 0.3");
       }},
      {"mean-directions", 1000, 400, mean_directions},
  };
}

} // namespace

std::vector<std::string> write_all(const std::filesystem::path& directory) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (!std::filesystem::is_directory(directory))
    throw Error(ExitCode::output, directory,
                "cannot be made" + (error ? ": " + error.message() : std::string()),
                "Name a directory that can be written.");
  std::vector<std::string> written;
  for (const Figure& figure : all_figures()) {
    write_figure(directory, figure.name, figure.width, figure.height, figure.draw);
    written.push_back(std::string(figure.name) + ".svg");
    written.push_back(std::string(figure.name) + ".png");
  }
  return written;
}

} // namespace gg::figures
