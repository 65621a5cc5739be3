#include "report/tables.h"

#include "report/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace gg::report {
namespace {

std::string td(const std::string& text, bool best = false) {
  return (best ? "<td class=\"best\">" : "<td>") + text + "</td>";
}

std::string table(const std::string& head, const std::string& rows) {
  return "<div class=\"scroll\"><table>\n<thead><tr>" + head + "</tr></thead>\n<tbody>\n" + rows
         + "</tbody></table></div>\n";
}

std::string head(const std::vector<std::string>& names) {
  std::string cells;
  for (const std::string& name : names)
    cells += "<th>" + escaped(name) + "</th>";
  return cells;
}

// The cells that have a column in tables by group and by pass: those of the most samples.
std::vector<const Cell*> columns_of(const Section& section) {
  int most = 0;
  for (const Cell& cell : section.cells)
    most = std::max(most, cell.samples);
  std::vector<const Cell*> columns;
  for (const Cell& cell : section.cells)
    if (cell.samples == most) columns.push_back(&cell);
  return columns;
}

std::vector<std::string> column_names(const Section& section, const std::string& first) {
  std::vector<std::string> names{first};
  for (const Cell* cell : columns_of(section))
    names.push_back(cell_name(section, *cell));
  return names;
}

std::string times(const Spread& ms) {
  return fmt::format("{:.2f} <span class=\"quiet\">{:.2f} – {:.2f}</span>", ms.median,
                     ms.low_quartile, ms.high_quartile);
}

// Reflected, refracted, after total reflection and of residual energy: "1 + 2 + 1 + 1"; without
// glass the first alone.
std::string lookups_of(const needs::Lookups& l) {
  if (l.refracted == 0) return std::to_string(l.reflected);
  return fmt::format("{} + {} + {} + {}", l.reflected, l.refracted, l.internally_reflected,
                     l.residual);
}

} // namespace

std::string cell_name(const Section& section, const Cell& cell) {
  const auto differs = [&](auto what) {
    return std::ranges::any_of(section.cells,
                               [&](const Cell& other) { return what(other) != what(cell); });
  };
  std::string name = cell.method;
  if (differs([](const Cell& c) { return c.samples; }))
    name += fmt::format(", {} sample{}", cell.samples, cell.samples == 1 ? "" : "s");
  if (differs([](const Cell& c) { return c.device.backend; })) name += " on " + cell.device.backend;
  return name;
}

std::string choice_text(const Section& section, const Limit& limit) {
  if (!section.choice) return {};
  const Cell& cell = section.cells[section.choice->index];
  const image::Errors& e = cell.verdict.objects;
  std::string is = fmt::format("{}: {}, relMSE {:.3g}", cell_name(section, cell),
                               ms_text(cell.timing.picture.median), e.relmse);
  if (image::outliers_dominate(e))
    is += fmt::format(", which outliers dominate: 1 %-trimmed it is {:.3g}", e.relmse_trimmed);
  if (limit.max_error)
    return section.choice->met
               ? fmt::format("{} (the fastest with a relMSE of at most {:g})", is, *limit.max_error)
               : fmt::format("no method has a relMSE of at most {:g}; the nearest is {}",
                             *limit.max_error, is);
  return section.choice->met
             ? fmt::format("{} (the most accurate within {:g} ms)", is, *limit.budget)
             : fmt::format("no method takes at most {:g} ms; the nearest is {}", *limit.budget, is);
}

std::string verdict_text(const Section& section, const Limit& limit) {
  if (section.front_trimmed.empty()) return {};
  if (section.choice) return "To use: " + choice_text(section, limit) + ".";
  // Of methods as accurate the fastest: on a front the first.
  constexpr double as_accurate = 1.01; // less than what another seed of the truth changes
  const auto error_at = [&](std::size_t i) {
    return section.cells[i].verdict.objects.relmse_trimmed;
  };
  const double least = error_at(section.front_trimmed.back());
  const Cell& best = section.cells[*std::ranges::find_if(
      section.front_trimmed, [&](std::size_t i) { return error_at(i) <= as_accurate * least; })];
  const double error = best.verdict.objects.relmse_trimmed;
  std::string text =
      fmt::format("The most accurate is {}: relMSE {:.3g} (1 %-trimmed) in {}",
                  cell_name(section, best), error, ms_text(best.timing.picture.median));
  const auto usual = std::ranges::find_if(section.cells, [&](const Cell& c) {
    return c.method == "standard" && c.samples == best.samples
           && c.device.backend == best.device.backend;
  });
  if (usual == section.cells.end() || &*usual == &best || !(error > 0.0)) return text + ".";
  return text
         + fmt::format(
             "; standard, with as many samples, has {:.2g} times the error in {:.2g} times "
             "the time.",
             usual->verdict.objects.relmse_trimmed / error,
             usual->timing.picture.median / best.timing.picture.median);
}

std::string results_table(const Section& section) {
  std::string rows;
  for (std::size_t i = 0; i < section.cells.size(); ++i) {
    const Cell& cell = section.cells[i];
    const image::Errors& e = cell.verdict.objects;
    const bool chosen = section.choice && section.choice->index == i;
    const bool all = std::ranges::find(section.front, i) != section.front.end();
    const bool best = std::ranges::find(section.front_trimmed, i) != section.front_trimmed.end();
    rows += chosen ? "<tr class=\"chosen\">" : "<tr>";
    rows += td(escaped(cell_name(section, cell))) + td(times(cell.timing.picture))
            + td(fmt::format("{:.3g}", e.relmse)) + td(fmt::format("{:.3g}", e.relmse_trimmed))
            + td(all && best ? "both"
                 : all       ? "relMSE"
                 : best      ? "trimmed"
                             : "")
            + td(fmt::format("{:.4f}", e.flip))
            + td(std::isfinite(e.psnr) ? fmt::format("{:.1f}", e.psnr) : "equal")
            + td(fmt::format("{:+.2g}", e.bias)) + td(fmt::format("{:.3g}", e.p99))
            + td(e.noise ? fmt::format("{:.0f} %", 100.0 * e.noise->pixels_within) : "")
            + td(fmt::format("{:.1f}", static_cast<double>(cell.bytes) / (1024.0 * 1024.0)))
            + td(lookups_of(cell.lookups))
            + td(fmt::format("<details><summary>show</summary><code>{}</code></details>",
                             escaped(cell.command)))
            + "</tr>\n";
  }
  return table(head({"method", "ms, quartiles", "relMSE", "1 %-trimmed", "Pareto front", "FLIP",
                     "PSNR dB", "bias", "p99", "within noise", "MiB", "lookups", "command"}),
               rows);
}

std::string groups_table(const Section& section, Grouping grouping) {
  const auto groups_of = [&](const Cell& cell) -> const std::vector<Group>& {
    return grouping == Grouping::material ? cell.verdict.by_class : cell.verdict.by_roughness;
  };
  const std::vector<const Cell*> columns = columns_of(section);
  if (columns.empty() || groups_of(*columns.front()).empty()) return {};
  std::string rows;
  for (std::size_t g = 0; g < groups_of(*columns.front()).size(); ++g) {
    const Group& first = groups_of(*columns.front())[g];
    double least = INFINITY;
    for (const Cell* cell : columns)
      least = std::min(least, groups_of(*cell)[g].relmse_trimmed);
    rows += "<tr>" + td(escaped(first.name));
    for (const Cell* cell : columns) {
      const Group& group = groups_of(*cell)[g];
      rows += td(fmt::format("{:.3g} / {:.3g}", group.relmse, group.relmse_trimmed),
                 group.relmse_trimmed <= least);
    }
    rows += td(fmt::format("{:.2g}", first.noise)) + td(std::to_string(first.pixels)) + "</tr>\n";
  }
  std::vector<std::string> names =
      column_names(section, grouping == Grouping::material ? "material" : "alpha");
  names.insert(names.end(), {"of it noise", "pixels"});
  return table(head(names), rows);
}

std::string passes_table(const Section& section) {
  // Of all methods, in the order of the frame: what one method has alone stands behind the pass that
  // comes before it there.
  const std::vector<const Cell*> columns = columns_of(section);
  std::vector<std::string> labels;
  for (const Cell* cell : columns) {
    auto at = labels.begin();
    for (const auto& [label, spread] : cell->timing.passes) {
      const auto found = std::ranges::find(labels, label);
      at = found == labels.end() ? labels.insert(at, label) + 1 : found + 1;
    }
  }
  std::string rows;
  for (const std::string& label : labels) {
    rows += "<tr>" + td(escaped(label));
    for (const Cell* cell : columns) {
      const auto found =
          std::ranges::find(cell->timing.passes, label, &std::pair<std::string, Spread>::first);
      rows += td(found == cell->timing.passes.end() ? "" : times(found->second));
    }
    rows += "</tr>\n";
  }
  return table(head(column_names(section, "pass, ms")), rows);
}

std::string summary_table(const Report& report) {
  std::string rows;
  for (const Section& s : report.sections) {
    if (s.front_trimmed.empty()) continue;
    const auto cell = [&](std::size_t i) {
      const Cell& c = s.cells[i];
      return td(fmt::format("{}: {}, {:.3g} / {:.3g}", escaped(cell_name(s, c)),
                            ms_text(c.timing.picture.median), error_of(c, Measure::all),
                            error_of(c, Measure::trimmed)));
    };
    rows += "<tr>" + td(fmt::format("<a href=\"#{0}\">{0}</a>", escaped(s.name)))
            + cell(s.front_trimmed.front()) + cell(s.front_trimmed.back());
    if (report.limit.asked())
      rows += s.choice ? cell(s.choice->index) + td(s.choice->met ? "" : "not within the limit")
                       : td("") + td("");
    rows += "</tr>\n";
  }
  std::vector<std::string> names{"scene", "fastest: ms, relMSE / 1 %-trimmed", "most accurate"};
  if (report.limit.asked()) names.insert(names.end(), {"to use", ""});
  return table(head(names), rows);
}

} // namespace gg::report
