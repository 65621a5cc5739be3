#include "report/page.h"

#include "core/files.h"
#include "image/heat_map.h"
#include "report/plot.h"
#include "report/tables.h"
#include "report/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gg::report {
namespace {

std::string paragraph(const std::string& text, const char* of = "") {
  return text.empty() ? "" : fmt::format("<p class=\"{}\">{}</p>\n", of, text);
}

// The pictures to choose from: each method's on the first backend; the others draw the same.
std::vector<const Cell*> pictured(const Section& section) {
  std::vector<const Cell*> cells;
  for (const Cell& cell : section.cells)
    if (!cell.picture.empty()) cells.push_back(&cell);
  return cells;
}

std::string source(const Section& s, const std::string& uri, const std::string& name) {
  return fmt::format("<img class=\"source\" hidden src=\"{}\" width=\"{}\" height=\"{}\" "
                     "data-name=\"{}\" alt=\"{}\">\n",
                     uri, s.width, s.height, escaped(name), escaped(name));
}

// Any two of the pictures, left and right of a line: assets/report/script.js draws them.
std::string compared(const Section& s) {
  const std::vector<const Cell*> cells = pictured(s);
  if (cells.empty()) return {};
  // Begins with the truth beside the most accurate.
  const Cell* const first = *std::ranges::min_element(
      cells, {}, [](const Cell* cell) { return cell->verdict.objects.relmse_trimmed; });
  std::vector<std::string> names{"truth"};
  std::string html = "<figure class=\"compare\">\n" + source(s, s.truth, "truth");
  for (const Cell* cell : cells) {
    names.push_back(cell->method);
    html += source(s, cell->picture, cell->method);
  }
  for (const Cell* cell : cells) {
    names.push_back("FLIP of " + cell->method);
    html += source(s, cell->flip, names.back());
  }
  const auto choose = [&](const char* side, const std::string& chosen) {
    std::string options;
    for (const std::string& name : names)
      options +=
          fmt::format("<option{}>{}</option>", name == chosen ? " selected" : "", escaped(name));
    return fmt::format("<label>{0} <select data-side=\"{0}\">{1}</select></label>\n", side,
                       options);
  };
  html += "<div class=\"pick\">\n" + choose("left", "truth") + choose("right", first->method)
          + "</div>\n";
  html += fmt::format("<canvas style=\"aspect-ratio: {} / {}\"></canvas>\n"
                      "<input type=\"range\" min=\"0\" max=\"100\" step=\"0.1\" value=\"50\" "
                      "aria-label=\"where left ends and right begins\">\n"
                      "<p class=\"quiet\"><output>Wheel: zoom. Drag: move. Double click: the whole "
                      "picture.</output></p>\n",
                      s.width, s.height);
  return html + "</figure>\n";
}

// The colours of the FLIP maps.
std::string scale() {
  std::string stops;
  constexpr int count = 16;
  for (int i = 0; i <= count; ++i) {
    const auto rgb = image::heat_colour(static_cast<double>(i) / count);
    stops += fmt::format("{}rgb({:.0f} {:.0f} {:.0f})", i ? ", " : "", 255.0f * rgb[0],
                         255.0f * rgb[1], 255.0f * rgb[2]);
  }
  return fmt::format(
      "<div class=\"scale\" style=\"background: linear-gradient(to right, {})\"></div>\n"
      "<p class=\"quiet\"><span>FLIP 0: no difference seen</span><span>1</span></p>\n",
      stops);
}

std::string facts(const Section& s) {
  std::string text = fmt::format("{} · {} object{}, {} triangles · {} x {} · environment: {}",
                                 escaped(s.path), s.objects, s.objects == 1 ? "" : "s",
                                 s.cells.empty() ? 0 : s.cells.front().triangles, s.width, s.height,
                                 escaped(s.environment));
  return paragraph(text, "quiet")
         + paragraph(fmt::format("Truth: {} samples per pixel, relative error {:.2g} %, {:.0f} s. "
                                 "Each point is a picture: its time, of all its samples, and its "
                                 "error. {} timed of each, in turn, {}.",
                                 s.truth_samples, 100.0 * s.truth_error, s.truth_seconds,
                                 s.cells.empty() ? 0 : s.cells.front().timing.picture.count,
                                 escaped(s.measured)),
                     "quiet");
}

// The methods of whom something holds, by name.
std::string those(const Section& s, bool (*holds)(const image::Errors&)) {
  std::string names;
  for (const Cell& cell : s.cells)
    if (holds(cell.verdict.objects)) names += (names.empty() ? "" : ", ") + cell_name(s, cell);
  return escaped(names);
}

// What a reader must know before believing the numbers.
std::string remarks(const Section& s) {
  const std::string noisy = those(s, image::noise_dominates);
  const std::string uneven = those(s, image::outliers_dominate);
  std::string html;
  if (!noisy.empty())
    html += paragraph("More than half of the relMSE is the truth's own noise for: " + noisy
                      + ". For more, ask for a truth of more samples.");
  if (!uneven.empty())
    html += paragraph(
        "One pixel in a hundred carries more than half of the relMSE for: " + uneven
        + ". It tells of those pixels alone, such as a lamp in a mirror that glass between them "
          "should bend away; the 1 %-trimmed one tells of the picture.");
  return html;
}

std::string needs(const Section& s) {
  if (s.needs.empty()) return {};
  std::string lines;
  for (const std::string& line : s.needs)
    lines += escaped(line) + "\n";
  return "<h3>What the scene needs</h3>\n<pre>" + lines + "</pre>\n";
}

std::string truth_command(const Section& s) {
  return "<h3>The truth</h3>\n<pre>" + escaped(s.truth_command) + "</pre>\n";
}

std::string section_of(const Section& s, const Limit& limit) {
  std::string html = fmt::format("<section id=\"{0}\">\n<h2>{0}</h2>\n", escaped(s.name))
                     + paragraph(escaped(verdict_text(s, limit)),
                                 s.choice && !s.choice->met ? "choice unmet" : "choice")
                     + facts(s);
  html += "<div class=\"side\">\n<div>\n" + compared(s) + scale() + "</div>\n<div>\n"
          + plot(s, limit, Measure::trimmed) + plot(s, limit, Measure::all) + "</div>\n</div>\n";
  html += results_table(s) + remarks(s);
  const auto titled = [&](const char* title, const std::string& table) {
    if (!table.empty()) html += fmt::format("<h3>{}</h3>\n{}", title, table);
  };
  titled("relMSE by material: of all pixels / 1 %-trimmed in each object",
         groups_table(s, Grouping::material));
  titled("relMSE by roughness: of all pixels / 1 %-trimmed in each object",
         groups_table(s, Grouping::roughness));
  titled("Milliseconds per pass, all samples: median, quartiles", passes_table(s));
  return html + needs(s) + truth_command(s) + "</section>\n";
}

std::string devices(const Report& report) {
  std::vector<std::string> lines;
  for (const Section& s : report.sections)
    for (const Cell& cell : s.cells) {
      const DeviceFacts& d = cell.device;
      const std::string line =
          fmt::format("{} by {}: {}, {}", d.backend, d.surface, d.name, d.driver);
      if (std::ranges::find(lines, line) == lines.end()) lines.push_back(line);
    }
  std::string html;
  for (const std::string& line : lines)
    html += paragraph(escaped(line), "quiet");
  return html;
}

// What the numbers mean.
std::string reading() {
  std::string html;
  for (const char* line :
       {"Errors are over the pixels that shaded objects cover wholly, in linear light; x is the "
        "picture, r the truth. Unlit objects are the same in every method and do not count.",
        "relMSE: mean of (x - r)² / (r² + 0.01) over RGB. 1 %-trimmed: the same without the 1 % of "
        "pixels where it is largest; by this a method is the most accurate. --max-error is of all "
        "pixels.",
        "bias: mean of x - r. p99: 99th percentile of |x - r|. within noise: the share of pixels "
        "whose difference is no larger than the truth's own standard error there.",
        "FLIP, PSNR: of the displayed picture (clamped, sRGB, 67 pixels per degree).",
        "lookups: of prefiltered pictures, for one sample of one pixel, at most: reflected + "
        "refracted + internally reflected + residual.",
        "A line joins the points of one method, from few samples to many."})
    html += paragraph(line, "quiet");
  return html;
}

} // namespace

std::string page(const Report& report) {
  const std::filesystem::path assets = home_directory() / "assets/report";
  std::string html = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                     "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
                     "<title>Groundglass: speed against error</title>\n<style>\n"
                     + read_text(assets / "style.css")
                     + "</style>\n</head>\n<body>\n"
                       "<h1>Speed against error</h1>\n";
  html += summary_table(report) + devices(report) + reading();
  for (const Section& section : report.sections)
    html += section_of(section, report.limit);
  html +=
      fmt::format("<h3>This report</h3>\n<pre>{}</pre>\n<p class=\"quiet\">Groundglass {}</p>\n",
                  escaped(report.command), escaped(report.version));
  return html + "<script>\n" + read_text(assets / "script.js") + "</script>\n</body>\n</html>\n";
}

} // namespace gg::report
