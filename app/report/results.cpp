#include "report/results.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gg::report {
namespace {

using nlohmann::json;

double quantile(const std::vector<double>& sorted, double fraction) {
  const double at = fraction * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], at - std::floor(at));
}

json to_json(const Spread& s) {
  return {{"median", s.median},
          {"low_quartile", s.low_quartile},
          {"high_quartile", s.high_quartile},
          {"min", s.least},
          {"max", s.most},
          {"pictures", s.count}};
}

Spread spread_from(const json& ms) {
  return {ms.at("median"), ms.at("low_quartile"), ms.at("high_quartile"),
          ms.at("min"),    ms.at("max"),          ms.at("pictures")};
}

json to_json(const std::vector<Group>& groups) {
  json list = json::array();
  for (const Group& g : groups)
    list.push_back({{"name", g.name},
                    {"pixels", g.pixels},
                    {"relmse", g.relmse},
                    {"relmse_trimmed", g.relmse_trimmed},
                    {"bias", g.bias},
                    {"flip", g.flip},
                    {"noise", g.noise}});
  return list;
}

std::vector<Group> groups_from(const json& list) {
  std::vector<Group> groups;
  for (const json& g : list)
    groups.push_back({g.at("name"), g.at("pixels"), g.at("relmse"), g.at("relmse_trimmed"),
                      g.at("bias"), g.at("flip"), g.at("noise")});
  return groups;
}

image::Errors errors_from(const json& value) {
  image::Errors e{.pixels = value.at("pixels"),
                  .relmse = value.at("relmse"),
                  .relmse_trimmed = value.at("relmse_trimmed"),
                  .rmse = value.at("rmse"),
                  .bias = value.at("bias"),
                  .reference_mean = value.at("reference_mean"),
                  .p99 = value.at("absolute_difference_p99"),
                  .psnr = std::numeric_limits<double>::infinity(),
                  .flip = value.at("flip")};
  if (!value.at("psnr_db").is_null()) e.psnr = value.at("psnr_db");
  if (const auto n = value.find("noise"); n != value.end())
    e.noise = image::Noise{.relmse = n->at("relmse"),
                           .relmse_trimmed = n->at("relmse_trimmed"),
                           .rmse = n->at("rmse"),
                           .bias = n->at("bias"),
                           .pixels_within = n->at("pixels_within"),
                           .of_reference = n->at("of_reference"),
                           .of_test = n->at("of_test")};
  return e;
}

} // namespace

Spread spread_of(std::vector<double> values) {
  if (values.empty()) return {};
  std::ranges::sort(values);
  return {quantile(values, 0.5), quantile(values, 0.25), quantile(values, 0.75),
          values.front(),        values.back(),          values.size()};
}

double error_of(const Cell& cell, Measure measure) {
  const image::Errors& e = cell.verdict.objects;
  return measure == Measure::all ? e.relmse : e.relmse_trimmed;
}

std::vector<Point> points_of(const std::vector<Cell>& cells, Measure measure) {
  std::vector<Point> points;
  for (const Cell& cell : cells)
    points.push_back({cell.timing.picture.median, error_of(cell, measure)});
  return points;
}

json to_json(const Timing& timing) {
  json passes = json::array();
  for (const auto& [label, spread] : timing.passes)
    passes.push_back({{"pass", label}, {"ms", to_json(spread)}});
  return {{"picture_ms", to_json(timing.picture)}, {"passes", passes}};
}

Timing timing_from(const json& value) {
  Timing timing{.picture = spread_from(value.at("picture_ms"))};
  for (const json& pass : value.at("passes"))
    timing.passes.emplace_back(pass.at("pass"), spread_from(pass.at("ms")));
  return timing;
}

json to_json(const image::Errors& e) {
  json result{{"pixels", e.pixels},
              {"relmse", e.relmse},
              {"relmse_trimmed", e.relmse_trimmed},
              {"outliers_dominate", image::outliers_dominate(e)},
              {"rmse", e.rmse},
              {"bias", e.bias},
              {"reference_mean", e.reference_mean},
              {"absolute_difference_p99", e.p99},
              {"psnr_db", std::isfinite(e.psnr) ? json(e.psnr) : json()}, // null: equal
              {"flip", e.flip}};
  if (e.noise)
    result["noise"] = {{"relmse", e.noise->relmse},
                       {"relmse_trimmed", e.noise->relmse_trimmed},
                       {"rmse", e.noise->rmse},
                       {"bias", e.noise->bias},
                       {"pixels_within", e.noise->pixels_within},
                       {"of_reference", e.noise->of_reference},
                       {"of_test", e.noise->of_test},
                       {"dominates", image::noise_dominates(e)}};
  return result;
}

json to_json(const Verdict& v) {
  return {{"objects", to_json(v.objects)},
          {"frame", to_json(v.frame)},
          {"by_class", to_json(v.by_class)},
          {"by_roughness", to_json(v.by_roughness)}};
}

Verdict verdict_from(const json& value) {
  return {.objects = errors_from(value.at("objects")),
          .frame = errors_from(value.at("frame")),
          .by_class = groups_from(value.at("by_class")),
          .by_roughness = groups_from(value.at("by_roughness"))};
}

nlohmann::json to_json(const needs::Lookups& l) {
  return {{"reflected", l.reflected},
          {"refracted", l.refracted},
          {"internally_reflected", l.internally_reflected},
          {"residual", l.residual}};
}

needs::Lookups lookups_from(const nlohmann::json& value) {
  return {.reflected = value.at("reflected"),
          .refracted = value.at("refracted"),
          .internally_reflected = value.at("internally_reflected"),
          .residual = value.at("residual")};
}

} // namespace gg::report
