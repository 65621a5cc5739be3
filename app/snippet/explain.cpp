#include "core/files.h"
#include "glsl/flatten.h"
#include "snippet/catalog.h"
#include "snippet/convert.h"
#include "snippet/print.h"
#include "snippet/scan.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <sstream>

namespace gg::snippet {
namespace fs = std::filesystem;
namespace {

std::string one_line(std::string text) {
  std::string out;
  for (const char c : text) {
    const bool space = c == '\n' || c == ' ';
    if (!space)
      out += c;
    else if (!out.empty() && out.back() != ' ')
      out += ' ';
  }
  return out;
}

// The comment lines right above a declaration.
std::string comment_above(const std::string& text, std::size_t begin) {
  std::string comment;
  std::size_t end = text.rfind('\n', begin);
  while (end != std::string::npos && end > 0) {
    const std::size_t start = text.rfind('\n', end - 1) + 1;
    const std::string line = text.substr(start, end - start);
    if (!line.starts_with("//")) break;
    comment = line + '\n' + comment;
    end = start == 0 ? std::string::npos : start - 1;
  }
  return comment;
}

std::string cost_of(const std::string& flat, const Item& item) {
  const Cost c = cost(flat, item.name);
  return fmt::format("    cost: {} arithmetic, {} root, {} transcendental, {} texture, {} branch\n",
                     c.arithmetic, c.roots, c.trigonometric, c.reads, c.branches);
}

// What shaders/compiled.txt, which tests/snippet/matrix.py writes, says of each snippet; its first line names the compilers.
std::map<std::string, std::string> compiled(const fs::path& shaders) {
  std::map<std::string, std::string> results;
  std::istringstream lines(read_text(shaders / "compiled.txt"));
  for (std::string line; std::getline(lines, line);) {
    const std::size_t name = std::min(line.find(' '), line.size());
    const std::size_t result = std::min(line.find_first_not_of(' ', name), line.size());
    results[line.substr(0, name)] = line.substr(result);
  }
  return results;
}

} // namespace

std::string list(const fs::path& shaders) {
  const std::vector<Snippet> all = catalog(shaders);
  std::map<std::string, std::string> results = compiled(shaders);
  std::string out =
      fmt::format("Compiled by: {}\nok: compiles; made: printed, nothing here compiles "
                  "it; -: takes combined samplers, which the target has not;\n?: not "
                  "compiled since it was written. {}\n",
                  results["compilers:"], "tests/snippet/matrix.py compiles all again.");
  std::string folder;
  for (const Snippet& one : all) {
    if (one.file.parent_path() != folder) {
      folder = one.file.parent_path();
      out += fmt::format("\n{:<26}{}\n", folder + '/', results["snippet"]);
    }
    const std::string result = results[folder + '/' + one.name];
    out += fmt::format("  {:<24}{:<54} {}\n", one.name, result.empty() ? "?" : result, one.summary);
  }
  return out;
}

std::string explain(const fs::path& shaders, const std::string& name) {
  const std::vector<Snippet> all = catalog(shaders);
  const Snippet& one = find(all, shaders, name);
  const std::string text = read_text(shaders / one.file),
                    flat = glsl::flatten(shaders, one.file).text;
  const std::vector<Item> declared = items(text);
  const bool whole =
      std::ranges::none_of(declared, [&](const Item& item) { return item.name == name; });
  std::string out = fmt::format("{}: {}\n\n", one.file.generic_string(), one.summary);
  for (const Item& item : declared) {
    if (!whole && item.name != name) continue;
    const bool function = item.kind == Item::Kind::function;
    const std::size_t end = function ? item.header_end : item.end;
    if (!whole) out += comment_above(text, item.begin);
    if (item.kind == Item::Kind::structure)
      out += text.substr(item.begin, end - item.begin) + '\n';
    else
      out += one_line(text.substr(item.begin, end - item.begin))
             + (item.kind == Item::Kind::prototype ? "  // yours to supply\n" : "\n");
    if (function) out += cost_of(flat, item);
  }
  out += fmt::format(
      "\nframe:   {}\nranges:  {}\nreturns: {}\nlimits:  {}\nsource:  {} (shaders/REFERENCES.md)\n",
      one.frame, one.alpha, one.returns, one.limits, one.source);
  std::string needs;
  for (const fs::path& file : glsl::flatten(shaders, one.file).files)
    if (file != one.file) needs += (needs.empty() ? "" : ", ") + file.stem().string();
  out += fmt::format("needs:   {}\ncost counts SPIR-V instructions after inlining and "
                     "optimisation, vectors as one, all branches taken.\n",
                     needs.empty() ? "nothing" : needs);
  return out;
}

} // namespace gg::snippet
