// What a report says, as data: what measuring fills in and what the writers write out.
#pragma once

#include "image/compare.h"
#include "needs/needs.h"
#include "report/choice.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gg::report {

// Of repeated measurements of one quantity.
struct Spread {
  double median = 0.0, low_quartile = 0.0, high_quartile = 0.0, least = 0.0, most = 0.0;
  std::size_t count = 0;
};
// Quantiles by linear interpolation between order statistics; all 0 for no values.
Spread spread_of(std::vector<double> values);

// Milliseconds of one picture, all its samples: by the clock, device idle before and after; and of
// each pass, summed over the samples, by the device's own timers, in the order of the frame.
struct Timing {
  Spread picture;
  std::vector<std::pair<std::string, Spread>> passes;
};

// Errors over the pixels of several objects together.
struct Group {
  std::string name;
  std::size_t pixels = 0;
  double relmse = 0.0, relmse_trimmed = 0.0, bias = 0.0, flip = 0.0; // trimmed: in each object
  double noise = 0.0; // the part of relmse that the truth's noise explains
};

// How wrong one picture is.
struct Verdict {
  // Over the pixels that shaded objects cover wholly (what is unlit shows the same in every
  // method), and over the whole frame. If no shaded object is seen, `objects` is the frame's too.
  image::Errors objects, frame;
  std::vector<Group> by_class, by_roughness;
};

struct DeviceFacts {
  std::string backend, surface, name, driver;
};

// One picture: a method with so many samples per pixel, on one backend. Times and errors are of it.
struct Cell {
  std::string method;
  int samples = 1;
  needs::Lookups lookups; // of pyramid and environment, by one pixel, at most
  DeviceFacts device;
  std::size_t bytes = 0; // device memory of the frame, environment included
  std::size_t triangles = 0;
  Timing timing;
  Verdict verdict;
  std::string picture, flip; // data URIs; empty: not shown
  std::string command;       // that draws the picture
};

struct Section {
  std::string name, path, environment;
  int width = 0, height = 0;
  std::size_t objects = 0;
  long truth_samples = 0;
  double truth_error = 0.0, truth_seconds = 0.0; // relative, as `truth` states it; 0 s: not traced
  std::string truth;                             // a data URI
  std::string truth_command;
  std::vector<std::string> needs; // lines; empty: nothing is known
  std::vector<Cell> cells;
  std::vector<std::size_t> front, front_trimmed; // Pareto fronts by Measure, by rising time
  std::optional<Choice> choice;
  std::string measured; // date of the timing, ISO 8601, UTC
};

struct Report {
  std::string version, command;
  Limit limit;
  std::vector<Section> sections;
};

// Errors to draw against time: relMSE over the objects, of all their pixels or 1 %-trimmed.
enum class Measure { all, trimmed };
double error_of(const Cell& cell, Measure measure);
// What a front is made of, with the median of the milliseconds.
std::vector<Point> points_of(const std::vector<Cell>& cells, Measure measure);

// To and from the cache, exactly.
nlohmann::json to_json(const Timing& timing);
nlohmann::json to_json(const Verdict& verdict);
nlohmann::json to_json(const needs::Lookups& lookups);
// Throw nlohmann::json::exception if something is missing.
Timing timing_from(const nlohmann::json& value);
Verdict verdict_from(const nlohmann::json& value);
needs::Lookups lookups_from(const nlohmann::json& value);
nlohmann::json to_json(const image::Errors& errors);

} // namespace gg::report
