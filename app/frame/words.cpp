#include "frame/words.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace gg::frame {
namespace {

std::vector<std::string> reads_of(const needs::Needs& needs, const Graph& graph, const Pass& pass) {
  std::vector<std::string> names;
  for (const Input& input : pass.reads)
    if (const std::string name = name_of(graph, input.part);
        std::ranges::find(names, name) == names.end())
      names.push_back(name);
  if (!pass.shades) return names;
  if (needs.view.environment) names.emplace_back("environment");
  if (!needs.tables.empty()) names.emplace_back("tables");
  if (!needs.images.empty()) names.emplace_back("textures");
  return names;
}

std::vector<std::string> writes_of(const Graph& graph, const Pass& pass) {
  std::vector<std::string> names;
  for (const ColorOutput& color : pass.colors)
    names.push_back(name_of(graph, color.part));
  if (pass.depth) names.push_back(graph.targets[pass.depth->target].name);
  return names;
}

// How many of the picture's pixels in a row are one of the pass's.
int rate_of(const Graph& graph, const Pass& pass) {
  const std::size_t target =
      pass.colors.empty() ? pass.depth->target : pass.colors.front().part.target;
  const int width = std::max(graph.targets[target].width, 1);
  return std::max((graph.width + width / 2) / width, 1); // corners of cells are one more
}

std::string joined(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, ", "));
}

const char* word(gpu::Format format) {
  switch (format) {
  case gpu::Format::rgba32f:
    return "rgba32f";
  case gpu::Format::rgba16f:
    return "rgba16f";
  case gpu::Format::rg32f:
    return "rg32f";
  case gpu::Format::rg16f:
    return "rg16f";
  case gpu::Format::r32f:
    return "r32f";
  case gpu::Format::r16f:
    return "r16f";
  case gpu::Format::rgba32ui:
    return "rgba32ui";
  case gpu::Format::depth32f:
    return "depth32f";
  default:
    return "other";
  }
}

std::string size_of(const Target& t) {
  std::string text = fmt::format("{}x{}", t.width, t.height);
  if (t.layers > 1) text += fmt::format(" x {} layers", t.layers);
  if (t.levels > 1) text += fmt::format(", {} levels", t.levels);
  return text;
}

// Passes of one label that follow each other (a pyramid's levels) are one line: of the last one's target.
std::string passes_text(const needs::Needs& needs, const Graph& graph) {
  std::string text =
      fmt::format("{:<28}{:>6}{:>6}  {}\n", "pass", "draws", "rate", "writes, and below it reads");
  for (std::size_t i = 0; i < graph.passes.size(); ++i) {
    const std::size_t first = i;
    while (i + 1 < graph.passes.size() && graph.passes[i + 1].label == graph.passes[first].label
           && graph.passes[first].draws == 0)
      ++i;
    const Pass& pass = graph.passes[i];
    const std::string label =
        i > first ? fmt::format("{} x {}", pass.label, i - first + 1) : pass.label;
    text +=
        fmt::format("{:<28}{:>6}{:>6}  {}\n", label, pass.draws ? std::to_string(pass.draws) : "",
                    fmt::format("1/{}", rate_of(graph, pass)), joined(writes_of(graph, pass)));
    if (const auto reads = reads_of(needs, graph, pass); !reads.empty())
      text += "    " + joined(reads) + "\n";
  }
  return text;
}

} // namespace

std::string text_of(const needs::Needs& needs, const Graph& graph) {
  std::string text = passes_text(needs, graph);
  text += "\ntargets\n";
  for (const Target& target : graph.targets)
    text += fmt::format("  {:<26}{:<32}{:>12}\n", target.name,
                        size_of(target) + " " + word(target.format), bytes_of(target));
  text += "\nbytes on the device (targets that are not in use at the same time share memory)\n";
  const std::vector<Share> memory = memory_of(needs, graph);
  for (const Share& share : memory)
    if (share.bytes > 0) text += fmt::format("  {:<44}{:>12}\n", share.of, share.bytes);
  text += fmt::format("  {:<44}{:>12}\n", "together", bytes_of(memory));
  return text;
}

nlohmann::json json_of(const needs::Needs& needs, const Graph& graph) {
  using nlohmann::json;
  json passes = json::array(), targets = json::array(), shares = json::object();
  for (const Pass& pass : graph.passes)
    passes.push_back({{"label", pass.label},
                      {"draws", pass.draws},
                      {"rate", rate_of(graph, pass)},
                      {"reads", reads_of(needs, graph, pass)},
                      {"writes", writes_of(graph, pass)}});
  for (const Target& target : graph.targets)
    targets.push_back({{"name", target.name},
                       {"texel", word(target.format)},
                       {"width", target.width},
                       {"height", target.height},
                       {"layers", target.layers},
                       {"levels", target.levels},
                       {"bytes", bytes_of(target)}});
  const std::vector<Share> memory = memory_of(needs, graph);
  for (const Share& share : memory)
    shares[share.of] = share.bytes;
  return {
      {"passes", passes}, {"targets", targets}, {"memory", shares}, {"bytes", bytes_of(memory)}};
}

} // namespace gg::frame
