// groundglass compare: how wrong a picture is, and how much of that is the reference's noise.
#include "image/compare.h"

#include "commands/commands.h"
#include "commands/json_file.h"
#include "commands/options.h"
#include "core/error.h"
#include "core/files.h"
#include "core/suggest.h"
#include "image/heat_map.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>
#include <optional>

namespace gg::commands {
namespace {

using image::Comparison;
using image::Errors;
using image::Picture;
using nlohmann::json;

struct CompareOptions {
  std::string test, reference, map, map_of = "flip", json_file;
  std::vector<std::string> objects;
};

struct Column {
  std::string title;
  const Errors* errors;
};

std::vector<Column> columns(const Comparison& comparison, const Picture& with_names) {
  std::vector<Column> result{{"frame", &comparison.frame}};
  if (comparison.objects) result.push_back({"objects", &*comparison.objects});
  // With one object its column would repeat the one before; more than eight do not fit a terminal
  // and are in the JSON.
  if (comparison.by_object.size() > 1 && comparison.by_object.size() <= 8)
    for (const auto& [id, errors] : comparison.by_object) {
      const auto name = with_names.object_names.find(id);
      result.push_back({name != with_names.object_names.end() ? name->second.substr(0, 12)
                                                              : "object " + std::to_string(id),
                        &errors});
    }
  return result;
}

template <class Cell>
void print_row(std::FILE* to, const char* label, const std::vector<Column>& table,
               const Cell& cell) {
  fmt::print(to, "{:<22}", label);
  for (const Column& column : table)
    fmt::print(to, " {:>12}", column.errors->pixels > 0 ? cell(*column.errors) : std::string("-"));
  fmt::print(to, "\n");
}

void print_table(std::FILE* to, const std::vector<Column>& table) {
  fmt::print(to, "{:<22}", "");
  for (const Column& column : table)
    fmt::print(to, " {:>12}", column.title);
  fmt::print(to, "\n{:<22}", "pixels");
  for (const Column& column : table)
    fmt::print(to, " {:>12}", column.errors->pixels);
  fmt::print(to, "\n");
  const auto row = [&](const char* label, double Errors::*value, const char* format) {
    print_row(to, label, table,
              [&](const Errors& e) { return fmt::format(fmt::runtime(format), e.*value); });
  };
  row("relMSE", &Errors::relmse, "{:.4g}");
  row("relMSE, 1 %-trimmed", &Errors::relmse_trimmed, "{:.4g}");
  row("RMSE", &Errors::rmse, "{:.4g}");
  row("bias", &Errors::bias, "{:+.4g}");
  row("p99 of |difference|", &Errors::p99, "{:.4g}");
  row("reference's mean", &Errors::reference_mean, "{:.4g}");
  row("PSNR, dB (display)", &Errors::psnr, "{:.2f}");
  row("FLIP, mean (display)", &Errors::flip, "{:.4f}");
  if (!table.front().errors->noise) return;
  print_row(to, "relMSE from noise", table,
            [](const Errors& e) { return fmt::format("{:.4g}", e.noise->relmse); });
  print_row(to, "... 1 %-trimmed", table,
            [](const Errors& e) { return fmt::format("{:.4g}", e.noise->relmse_trimmed); });
  print_row(to, "std. error of mean", table,
            [](const Errors& e) { return fmt::format("{:.4g}", e.noise->bias); });
  print_row(to, "pixels within noise", table, [](const Errors& e) {
    return fmt::format("{:.1f} %", 100.0 * e.noise->pixels_within);
  });
}

// Where the pictures differ most, for a look at what rules the error.
std::string worst_pixel(const Comparison& comparison, const Picture& test,
                        const Picture& reference) {
  const std::vector<float>& errors = comparison.relative_map.values;
  const int at = static_cast<int>(std::ranges::max_element(errors) - errors.begin());
  const int x = at % comparison.relative_map.width, y = at / comparison.relative_map.width;
  const auto rgb = [&](const image::Image& image) {
    return fmt::format("{:.4g}, {:.4g}, {:.4g}", image.at(x, y, 0), image.at(x, y, 1),
                       image.at(x, y, 2));
  };
  return fmt::format("({}, {}): {} where the reference has {}", x, y, rgb(test.colour),
                     rgb(reference.colour));
}

// What a reader must know before believing the numbers.
std::vector<std::string> remarks(const std::vector<Column>& table, const Comparison& comparison,
                                 const Picture& test, const Picture& reference) {
  std::vector<std::string> lines;
  const auto& noise = comparison.frame.noise;
  if (!noise || !noise->of_reference)
    lines.push_back(
        "The reference does not state its standard error: its own noise, if it has any, "
        "is part of the errors.");
  for (const Column& column : table) {
    if (column.errors->pixels == 0) {
      lines.push_back(fmt::format("No pixel is wholly covered: {}.", column.title));
    } else if (image::noise_dominates(*column.errors)) {
      const Errors& e = *column.errors;
      lines.push_back(fmt::format(
          "Noise dominates ({}): it explains {:.0f} % of the relMSE. The test is within {:.2g} of "
          "the truth; for more, render the reference with more samples.",
          column.title, std::min(100.0, 100.0 * e.noise->relmse / e.relmse), e.relmse));
    }
  }
  std::string uneven;
  for (const Column& column : table)
    if (image::outliers_dominate(*column.errors))
      uneven += (uneven.empty() ? "" : ", ") + column.title;
  if (!uneven.empty())
    lines.push_back(fmt::format("Outliers dominate relMSE ({}): one in a hundred carries more than "
                                "half of it. The worst of "
                                "the frame is {}.",
                                uneven, worst_pixel(comparison, test, reference)));
  return lines;
}

json to_json(const Errors& e) {
  json result{{"pixels", e.pixels}};
  if (e.pixels == 0) return result;
  result.update({{"relmse", e.relmse},
                 {"relmse_trimmed", e.relmse_trimmed},
                 {"outliers_dominate", image::outliers_dominate(e)},
                 {"rmse", e.rmse},
                 {"bias", e.bias},
                 {"reference_mean", e.reference_mean},
                 {"absolute_difference_p99", e.p99},
                 {"psnr_db", std::isfinite(e.psnr) ? json(e.psnr) : json()}, // null: equal
                 {"flip", e.flip}});
  if (e.noise)
    result["noise"] = {{"of_reference", e.noise->of_reference},
                       {"of_test", e.noise->of_test},
                       {"relmse", e.noise->relmse},
                       {"relmse_trimmed", e.noise->relmse_trimmed},
                       {"rmse", e.noise->rmse},
                       {"bias", e.noise->bias},
                       {"pixels_within", e.noise->pixels_within},
                       {"dominates", image::noise_dominates(e)}};
  return result;
}

json to_json(const CompareOptions& options, const Comparison& comparison, const Picture& with_names,
             const std::vector<std::string>& remarks) {
  json result{{"test", options.test},
              {"reference", options.reference},
              {"width", comparison.flip_map.width},
              {"height", comparison.flip_map.height},
              {"frame", to_json(comparison.frame)},
              {"remarks", remarks}};
  if (!comparison.objects) return result;
  result["objects"] = to_json(*comparison.objects);
  result["by_object"] = json::array();
  for (const auto& [id, errors] : comparison.by_object) {
    json object = to_json(errors);
    object["id"] = id;
    if (const auto name = with_names.object_names.find(id); name != with_names.object_names.end())
      object["name"] = name->second;
    result["by_object"].push_back(object);
  }
  return result;
}

void write_map(const CompareOptions& options, const Comparison& comparison) {
  if (options.map_of == "flip") {
    const std::string title = fmt::format("FLIP, mean {:.4f}", comparison.frame.flip);
    return image::write(options.map, image::heat_map(comparison.flip_map, 1.0, title));
  }
  const double top = image::round_top(comparison.relative_map);
  const std::string title =
      fmt::format("relative error, RMS {:.3g}", std::sqrt(comparison.frame.relmse));
  image::write(options.map, image::heat_map(comparison.relative_map, top, title));
}

// The ids of the objects that are named: all that bear a name, or the one with that number, which
// image::compare looks up.
std::vector<int> object_ids(const std::vector<std::string>& wanted, const Picture& with_names) {
  std::vector<int> ids;
  std::vector<std::string> names;
  for (const auto& [id, name] : with_names.object_names)
    names.push_back(name);
  for (const std::string& word : wanted) {
    const std::size_t before = ids.size();
    for (const auto& [id, name] : with_names.object_names)
      if (name == word) ids.push_back(id);
    if (ids.size() > before) continue;
    int id = 0;
    const char* const end = word.data() + word.size();
    if (const auto [at, error] = std::from_chars(word.data(), end, id);
        error != std::errc() || at != end || id < 1)
      throw Error(ExitCode::usage, "--objects",
                  "'" + word + "' is neither an object of " + with_names.name + " nor an id",
                  did_you_mean(word, names)
                      + (names.empty() ? std::string()
                                       : fmt::format("Its objects: {}. ", fmt::join(names, ", ")))
                      + "Ids are whole numbers from 1.");
    ids.push_back(id);
  }
  return ids;
}

void run(const CompareOptions& options) {
  // Complaints about names come before the work.
  if (!options.map.empty()
      && (!image::is_writable_extension(options.map) || !options.map.ends_with(".png")))
    throw Error(ExitCode::usage, options.map, "is no name for a heat map", "Use --map OUT.png.");
  probe_outputs({options.map, options.json_file});
  const Picture test = image::load_picture(options.test);
  const Picture reference = image::load_picture(options.reference);
  if (test.display_referred != reference.display_referred)
    note((test.display_referred ? options.test : options.reference)
         + " holds 8-bit display values, clipped at 1; they are compared as the light that they "
           "stand for, which is right only for a picture written with --tonemap none. Write .exr "
           "to compare radiance");
  const Picture& with_names = reference.id.empty() ? test : reference;
  const Comparison comparison =
      image::compare(test, reference, object_ids(options.objects, with_names));
  const std::vector<Column> table = columns(comparison, with_names);
  const std::vector<std::string> lines = remarks(table, comparison, test, reference);
  // Both or neither: the map is written while the other file is complete but not yet in place.
  std::optional<OutputFile> numbers;
  if (!options.json_file.empty()) {
    numbers.emplace(options.json_file);
    json document = to_json(options, comparison, with_names, lines);
    document["schema"] = json_schema;
    numbers->write(document.dump(2) + "\n");
  }
  if (!options.map.empty()) write_map(options, comparison);
  if (numbers) numbers->commit();
  std::FILE* const to = text_stream({options.map, options.json_file});
  print_table(to, table);
  for (const std::string& line : lines)
    fmt::print(to, "{}\n", line);
}

} // namespace

void add_compare(Command program) {
  auto options = std::make_shared<CompareOptions>();
  Command command = program.subcommand(
      "compare", "Measure a picture against a reference: relMSE, RMSE, bias, p99, PSNR, FLIP");
  command.option("TEST", &options->test, "The picture to judge (.exr, .hdr, .pfm, .png)")
      .required();
  command.option("REFERENCE", &options->reference, "The picture to judge it by").required();
  command.option("--map", &options->map, "Write a heat map with its scale (.png)");
  command.option("--map-of", &options->map_of, "What the heat map shows: flip or relative")
      .one_of({"flip", "relative"});
  command.option("--objects", &options->objects, "Only these objects: names or ids, as Ball,2")
      .comma_separated();
  command.option("--json", &options->json_file,
                 "Write the numbers as JSON; - for standard output, in place of the table");
  command.action([options] { run(*options); });
}

} // namespace gg::commands
