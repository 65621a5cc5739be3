#include "snippet/print.h"

#include "core/error.h"
#include "core/files.h"
#include "glsl/cpp_text.h"
#include "glsl/flatten.h"
#include "snippet/catalog.h"
#include "snippet/convert.h"
#include "snippet/rewrite.h"
#include "snippet/wgsl.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace gg::snippet {
namespace fs = std::filesystem;
namespace {

constexpr std::array<std::pair<const char*, Target>, 7> target_names{{{"glsl", Target::glsl},
                                                                      {"vulkan", Target::vulkan},
                                                                      {"essl", Target::essl},
                                                                      {"hlsl", Target::hlsl},
                                                                      {"msl", Target::msl},
                                                                      {"wgsl", Target::wgsl},
                                                                      {"cpp", Target::cpp}}};

void check_prefix(const std::string& prefix) {
  const bool word = std::ranges::all_of(
      prefix, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; });
  const bool digit = !prefix.empty() && std::isdigit(static_cast<unsigned char>(prefix.front()));
  if (!word || digit || prefix.find("__") != std::string::npos || prefix.starts_with("gl_"))
    throw Error(ExitCode::usage, "--prefix " + prefix, "cannot begin a name in every language",
                "Use letters, digits and single underscores, as gg_.");
}

// As glsl/f32.h and f64.h, in one header. The snippets' own guards would keep the second copy out.
std::string header_for_cpp(const fs::path& shaders, const std::string& glsl,
                           const std::string& prefix) {
  const std::string text = without_guards(glsl);
  const std::string shim = read_text(shaders.parent_path() / "app" / "glsl" / "shim.inl");
  const std::string space = prefix + "groundglass";
  return fmt::format(R"(#pragma once
// Compile with -ffp-contract=off if the digits of compensated.glsl matter. A function that is only declared is yours to define.
// A program takes one such header, or several with a --prefix each.
#include <cmath>
#include <type_traits>

#include <glm/glm.hpp>

namespace {0}::f32 {{
using Real = float;
{1}{2}}} // namespace {0}::f32

namespace {0}::f64 {{
using Real = double;
#define BSDF_DOUBLE
{1}{3}#undef BSDF_DOUBLE
}} // namespace {0}::f64
)",
                     space, shim, glsl::cpp_text(text, glsl::Literals::suffixed),
                     glsl::cpp_text(text, glsl::Literals::bare));
}

// Converters drop comments: those that the asked-for files open with stand in for all.
std::string header_blocks(const fs::path& shaders, const std::vector<fs::path>& files) {
  std::string out;
  for (const fs::path& file : files) {
    const std::string text = read_text(shaders / file);
    out += text.substr(0, text.find("#ifndef")) + '\n';
  }
  return out;
}

} // namespace

std::optional<Target> target_named(const std::string& name) {
  for (const auto& [known, target] : target_names)
    if (name == known) return target;
  return {};
}

std::string print(const fs::path& shaders, const std::vector<std::string>& names,
                  const PrintOptions& options) {
  check_prefix(options.prefix);
  const std::vector<Snippet> snippets = catalog(shaders);
  std::vector<fs::path> files;
  for (const std::string& name : names)
    files.push_back(find(snippets, shaders, name).file);
  const glsl::Flattened flat = glsl::flatten(shaders, files);
  const bool pure_only = options.target == Target::cpp || options.target == Target::wgsl;
  for (const fs::path& file : flat.files)
    if (pure_only && glsl::is_fetch(file))
      throw Error(ExitCode::unsupported, file.generic_string(),
                  "takes combined samplers, which the target does not have",
                  "Take the file of the same name without _fetch, and read the texture yourself.");

  const std::string text = with_prefix(flat.text, options.prefix);
  std::string out;
  switch (options.target) {
  case Target::glsl:
  case Target::vulkan:
    out = text;
    break;
  case Target::essl:
    out = glsl::essl_precisions() + text;
    break;
  case Target::hlsl:
    out = header_blocks(shaders, files) + converted(text, Foreign::hlsl);
    break;
  case Target::msl:
    out = header_blocks(shaders, files) + converted(text, Foreign::msl);
    break;
  case Target::wgsl:
    out = header_blocks(shaders, files) + with_prefix(wgsl_of(shaders, flat.text), options.prefix);
    break;
  case Target::cpp:
    out = header_for_cpp(shaders, text, options.prefix);
    break;
  }
  return options.strip ? without_comments(out) : out;
}

} // namespace gg::snippet
