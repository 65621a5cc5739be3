#include "report/plot.h"

#include "report/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>

namespace gg::report {
namespace {

// Okabe and Ito's colours (2008), which the common kinds of colour blindness keep apart.
constexpr std::array colours = {"#d55e00", "#0072b2", "#009e73", "#cc79a7",
                                "#e69f00", "#56b4e9", "#222222"};
constexpr double width = 460.0, height = 340.0;                        // of a panel
constexpr double left = 62.0, right = 18.0, top = 44.0, bottom = 46.0; // margins
constexpr double letter = 6.6, line = 13.0; // of 12 px type, about: to keep labels apart

struct Box {
  double x0, y0, x1, y1;
  bool meets(const Box& b) const { return x0 < b.x1 && b.x0 < x1 && y0 < b.y1 && b.y0 < y1; }
};

// A logarithmic axis on the picture.
struct Scale {
  double low, high, from, to;
  double operator()(double v) const {
    return from + (to - from) * std::log(v / low) / std::log(high / low);
  }
};

// An error of 0 has no place on the axis; this stands for it.
double drawable(double error) {
  return std::max(error, 1e-9);
}

class Panel {
public:
  Panel(const Section& section, const Limit& limit, Measure measure)
      : section_(section), limit_(limit), measure_(measure),
        front_(measure == Measure::all ? section.front : section.front_trimmed) {
    double fast = INFINITY, slow = 0.0, good = INFINITY, bad = 0.0;
    for (const Cell& cell : section.cells) {
      fast = std::min(fast, cell.timing.picture.low_quartile);
      slow = std::max(slow, cell.timing.picture.high_quartile);
      good = std::min(good, drawable(error_of(cell, measure_)));
      bad = std::max(bad, drawable(error_of(cell, measure_)));
    }
    // Room for labels beside the outermost points.
    x_ = {std::max(fast, 1e-3) / 1.25, std::max(slow, 1e-3) * 1.7, left, width - right};
    y_ = {good / 2.0, bad * 2.0, height - bottom, top};
  }

  std::string draw() {
    axes();
    lines();
    front();
    curves();
    for (std::size_t i = 0; i < section_.cells.size(); ++i)
      point(i);
    labels();
    return std::move(svg_);
  }

private:
  template <class... T>
  void add(fmt::format_string<T...> format, T&&... values) {
    fmt::format_to(std::back_inserter(svg_), format, std::forward<T>(values)...);
    svg_ += '\n';
  }

  void axes() {
    for (const double t : log_ticks(x_.low, x_.high)) {
      add(R"(<path d="M{0:.1f} {1}V{2}" stroke="#ddd"/>)", x_(t), top, height - bottom);
      add(R"(<text x="{:.1f}" y="{}" text-anchor="middle">{:g}</text>)", x_(t),
          height - bottom + 16, t);
    }
    for (const double t : log_ticks(y_.low, y_.high)) {
      add(R"(<path d="M{0} {1:.1f}H{2}" stroke="#ddd"/>)", left, y_(t), width - right);
      add(R"(<text x="{}" y="{:.1f}" text-anchor="end">{:g}</text>)", left - 6, y_(t) + 4, t);
    }
    add(R"(<path d="M{} {}V{}H{}" fill="none" stroke="#222"/>)", left, top, height - bottom,
        width - right);
    add(R"(<text x="{:.1f}" y="{}" text-anchor="middle">milliseconds per picture, {} x {}</text>)",
        0.5 * (left + width - right), height - 10, section_.width, section_.height);
    add(R"svg(<text transform="translate(14 {:.1f}) rotate(-90)" text-anchor="middle">relMSE {}</text>)svg",
        0.5 * (top + height - bottom),
        measure_ == Measure::all ? "over the objects" : "over the objects, 1 %-trimmed");
    add(R"(<text x="{}" y="18" font-weight="bold">{}</text>)", left, escaped(section_.name));
    legend();
  }

  // Which mark stands for which backend, where there are several.
  void legend() {
    const std::vector<std::string> all = backends();
    if (all.size() < 2) return;
    double x = left;
    for (std::size_t i = 0; i < all.size(); ++i) {
      mark(x + 5, 32, i, "#222");
      add(R"(<text x="{:.1f}" y="36">{}</text>)", x + 13, escaped(all[i]));
      x += 28 + letter * static_cast<double>(all[i].size());
    }
  }

  // The truth's noise and the limit, where they are in sight.
  void lines() {
    double noise = 0.0;
    for (const Cell& cell : section_.cells)
      if (const auto& n = cell.verdict.objects.noise)
        noise = std::max(noise, measure_ == Measure::all ? n->relmse : n->relmse_trimmed);
    across(noise, "#777", "2 3", "the truth's noise");
    if (limit_.max_error && measure_ == Measure::all)
      across(*limit_.max_error, "#222", "6 3", "--max-error");
    if (limit_.budget && *limit_.budget > x_.low && *limit_.budget < x_.high) {
      const double x = x_(*limit_.budget);
      add(R"(<path d="M{:.1f} {}V{}" stroke="#222" stroke-dasharray="6 3"/>)", x, top,
          height - bottom);
      add(R"(<text x="{:.1f}" y="{}" fill="#222">--budget</text>)", x + 4, top + 12);
    }
  }

  void across(double error, const char* colour, const char* dashes, const char* label) {
    if (!(error > y_.low && error < y_.high)) return;
    const double y = y_(error);
    add(R"(<path d="M{} {:.1f}H{}" stroke="{}" stroke-dasharray="{}"/>)", left, y, width - right,
        colour, dashes);
    add(R"(<text x="{}" y="{:.1f}" text-anchor="end" fill="{}">{}</text>)", width - right - 2,
        y - 4, colour, label);
    const double length = letter * static_cast<double>(std::string_view(label).size()) + 4;
    taken_.push_back({width - right - length, y - line - 2, width - right, y + 1});
  }

  // What the front reaches: with more time never a larger error.
  void front() {
    if (front_.empty()) return;
    std::string path;
    double before = top;
    for (std::size_t k = 0; k < front_.size(); ++k) {
      const auto [x, y] = at(front_[k]);
      path += path.empty() ? fmt::format("M{:.1f} {:.1f}V{:.1f}", x, top, y)
                           : fmt::format("H{:.1f}V{:.1f}", x, y);
      const double until = k + 1 < front_.size() ? at(front_[k + 1]).x : width - right;
      taken_.push_back({x - 1, before, x + 1, y});
      taken_.push_back({x, y - 1, until, y + 1});
      before = y;
    }
    add(R"(<path class="front" d="{}H{}" fill="none" stroke="#222" stroke-width="1.5" stroke-opacity="0.55"/>)",
        path, width - right);
  }

  // From few samples to many, a method at a time.
  void curves() {
    std::map<std::pair<std::string, std::string>, std::vector<std::size_t>> of;
    for (std::size_t i = 0; i < section_.cells.size(); ++i)
      of[{section_.cells[i].device.backend, section_.cells[i].method}].push_back(i);
    for (auto& [name, cells] : of) {
      if (cells.size() < 2) continue;
      std::ranges::sort(cells, {}, [&](std::size_t i) { return section_.cells[i].samples; });
      std::string path;
      for (const std::size_t i : cells)
        path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", at(i).x, at(i).y);
      add(R"(<path class="curve" d="{}" fill="none" stroke="{}" stroke-opacity="0.7"/>)", path,
          colour_of(name.second));
    }
  }

  void point(std::size_t i) {
    const Cell& cell = section_.cells[i];
    const auto [x, y] = at(i);
    const Spread& ms = cell.timing.picture;
    const char* const colour = colour_of(cell.method);
    add(R"(<g><title>{} on {}, {} samples: {} (quartiles {} to {}), relMSE {:.3g}</title>)",
        escaped(cell.method), escaped(cell.device.backend), cell.samples, ms_text(ms.median),
        ms_text(ms.low_quartile), ms_text(ms.high_quartile), error_of(cell, measure_));
    add(R"(<path d="M{:.1f} {:.1f}H{:.1f}" stroke="{}" stroke-width="2"/>)",
        x_(std::max(ms.low_quartile, x_.low)), y, x_(std::max(ms.high_quartile, x_.low)), colour);
    const std::vector<std::string> all = backends();
    mark(x, y, static_cast<std::size_t>(std::ranges::find(all, cell.device.backend) - all.begin()),
         colour, radius(cell.samples));
    svg_ += "</g>\n";
    taken_.push_back({x - 6, y - 6, x + 6, y + 6});
    taken_.push_back({x_(std::max(ms.low_quartile, x_.low)), y - 2,
                      x_(std::max(ms.high_quartile, x_.low)), y + 2});
  }

  void mark(double x, double y, std::size_t backend, const char* colour, double r = 5.0) {
    if (backend % 2 == 0)
      add(R"(<circle cx="{:.1f}" cy="{:.1f}" r="{:.1f}" fill="{}"/>)", x, y, r, colour);
    else
      add(R"(<rect x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}" fill="{}"/>)", x - 0.9 * r,
          y - 0.9 * r, 1.8 * r, 1.8 * r, colour);
  }

  // 3, 4, 5 for 1, 4, 16 samples, and no more.
  static double radius(int samples) {
    return std::min(6.0, 3.0 + 0.5 * std::log2(static_cast<double>(samples)));
  }

  // One label for a method, as near to its first point as there is room, with a line to the point
  // where others lie between.
  void labels() {
    std::vector<std::string> done;
    for (std::size_t i = 0; i < section_.cells.size(); ++i) {
      const std::string& name = section_.cells[i].method;
      if (std::ranges::find(done, name) != done.end()) continue;
      done.push_back(name);
      const double w = letter * static_cast<double>(name.size()) + 2;
      const auto [x, y] = at(i);
      const auto [place, far] = place_for(x, y, w);
      taken_.push_back(place);
      if (far)
        add(R"(<path d="M{:.1f} {:.1f}L{:.1f} {:.1f}" stroke="{}" stroke-opacity="0.6"/>)", x, y,
            std::clamp(x, place.x0, place.x1), y < place.y0 ? place.y0 : place.y1, colour_of(name));
      add(R"(<text x="{:.1f}" y="{:.1f}" fill="{}" font-weight="bold">{}</text>)", place.x0,
          place.y1 - 3, colour_of(name), escaped(name));
    }
  }

  // Beside the point, above or below it, then line by line further away.
  std::pair<Box, bool> place_for(double x, double y, double w) const {
    const auto free = [&](const Box& place) {
      return place.x0 > left && place.x1 < width && place.y0 > top - line
             && place.y1 < height - bottom
             && std::ranges::none_of(taken_, [&](const Box& b) { return b.meets(place); });
    };
    const double aside[] = {x + 8, x - 8 - w, x - w / 2};
    for (const double x0 : {aside[0], aside[1]})
      if (const Box place = box(x0, y - line / 2, w); free(place)) return {place, false};
    for (int away = 0; away * line < height; ++away)
      for (const double x0 : {aside[2], aside[0], aside[1]})
        for (const double y0 : {y - 8 - (away + 1) * line, y + 8 + away * line})
          if (const Box place = box(x0, y0, w); free(place)) return {place, away > 0};
    return {box(x + 8, y - line / 2, w), false}; // a plot full of labels
  }

  static Box box(double x, double y, double w) { return {x, y, x + w, y + line}; }

  struct Place {
    double x, y;
  };
  Place at(std::size_t i) const {
    const Cell& cell = section_.cells[i];
    return {x_(std::max(cell.timing.picture.median, 1e-3)), y_(drawable(error_of(cell, measure_)))};
  }

  std::vector<std::string> backends() const {
    std::vector<std::string> all;
    for (const Cell& cell : section_.cells)
      if (std::ranges::find(all, cell.device.backend) == all.end())
        all.push_back(cell.device.backend);
    return all;
  }

  const char* colour_of(const std::string& method) {
    const auto [found, added] = numbers_.try_emplace(method, numbers_.size());
    return colours[found->second % colours.size()];
  }

  const Section& section_;
  const Limit& limit_;
  Measure measure_;
  const std::vector<std::size_t>& front_;
  Scale x_{}, y_{};
  std::string svg_;
  std::vector<Box> taken_;
  std::map<std::string, std::size_t> numbers_; // of methods, in order of appearance
};

std::string element(double columns, double rows, bool alone, const std::string& inside) {
  return fmt::format(
      R"(<svg {}viewBox="0 0 {} {}" {}font-family="DejaVu Sans, Helvetica, Arial, sans-serif" )"
      R"(font-size="12" fill="#222" role="img">{}{}</svg>)",
      alone ? R"(xmlns="http://www.w3.org/2000/svg" )" : "", columns * width, rows * height,
      alone ? fmt::format(R"(width="{}" height="{}" )", columns * width, rows * height) : "",
      alone ? R"(<rect width="100%" height="100%" fill="#fff"/>)" : "", inside);
}

} // namespace

std::vector<double> log_ticks(double low, double high) {
  constexpr std::size_t most = 8;
  const int first = static_cast<int>(std::floor(std::log10(low)));
  const int last = static_cast<int>(std::ceil(std::log10(high)));
  const auto ticks = [&](int every, std::initializer_list<double> steps) {
    std::vector<double> values;
    for (int power = first; power <= last; power += every)
      for (const double step : steps)
        if (const double v = step * std::pow(10.0, power); v >= low && v <= high)
          values.push_back(v);
    return values;
  };
  if (auto finest = ticks(1, {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0}); finest.size() <= most)
    return finest;
  if (auto fine = ticks(1, {1.0, 2.0, 5.0}); fine.size() <= most) return fine;
  for (int every = 1;; ++every)
    if (auto coarse = ticks(every, {1.0}); coarse.size() <= most) return coarse;
}

std::string plot(const Section& section, const Limit& limit, Measure measure) {
  return element(1, 1, false, Panel(section, limit, measure).draw());
}

std::string plots(const Report& report) {
  constexpr std::size_t across = 3;
  const std::size_t count = std::max<std::size_t>(report.sections.size(), 1);
  const std::size_t columns = std::min(count, across), rows = (count + columns - 1) / columns;
  std::string inside;
  for (std::size_t i = 0; i < report.sections.size(); ++i)
    for (const Measure measure : {Measure::trimmed, Measure::all}) {
      // A row by 1 %-trimmed relMSE, and one by that of all pixels beneath it.
      const std::size_t row = 2 * (i / columns) + (measure == Measure::all ? 1 : 0);
      inside +=
          fmt::format("<g transform=\"translate({} {})\">\n{}</g>\n",
                      static_cast<double>(i % columns) * width, static_cast<double>(row) * height,
                      Panel(report.sections[i], report.limit, measure).draw());
    }
  return element(static_cast<double>(columns), 2.0 * static_cast<double>(rows), true, inside)
         + "\n";
}

} // namespace gg::report
