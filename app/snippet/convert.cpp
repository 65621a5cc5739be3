#include "snippet/convert.h"

#include "core/error.h"
#include "gpu/shaders/compile.h"
#include "snippet/driver.h"
#include "snippet/scan.h"

#include <spirv_cross_c.h>

#include <memory>
#include <set>
#include <sstream>
#include <string_view>
#include <vector>

namespace gg::snippet {
namespace {

struct Destroy {
  void operator()(spvc_context context) const { spvc_context_destroy(context); }
};

std::string translate(const std::vector<std::uint32_t>& words, Foreign language) {
  spvc_context created = nullptr;
  if (spvc_context_create(&created) != SPVC_SUCCESS)
    throw Error(ExitCode::internal, "SPIRV-Cross", "cannot be started");
  const std::unique_ptr<spvc_context_s, Destroy> context(created);
  const auto check = [&](spvc_result result) {
    if (result != SPVC_SUCCESS)
      throw Error(ExitCode::internal, "SPIRV-Cross",
                  spvc_context_get_last_error_string(context.get()));
  };
  spvc_parsed_ir ir = nullptr;
  spvc_compiler compiler = nullptr;
  spvc_compiler_options options = nullptr;
  const bool hlsl = language == Foreign::hlsl;
  check(spvc_context_parse_spirv(context.get(), words.data(), words.size(), &ir));
  check(spvc_context_create_compiler(context.get(), hlsl ? SPVC_BACKEND_HLSL : SPVC_BACKEND_MSL, ir,
                                     SPVC_CAPTURE_MODE_TAKE_OWNERSHIP, &compiler));
  check(spvc_compiler_create_compiler_options(compiler, &options));
  if (hlsl)
    check(spvc_compiler_options_set_uint(options, SPVC_COMPILER_OPTION_HLSL_SHADER_MODEL, 50));
  else
    check(spvc_compiler_options_set_uint(options, SPVC_COMPILER_OPTION_MSL_VERSION,
                                         SPVC_MAKE_MSL_VERSION(2, 1, 0)));
  check(spvc_compiler_install_compiler_options(compiler, options));
  const char* text = nullptr;
  check(spvc_compiler_compile(compiler, &text));
  return text;
}

// The driver's own parts of what the converter wrote, which are not the snippet's.
bool is_scaffold(const std::string& text, const Item& item) {
  if (item.kind == Item::Kind::structure)
    return item.name.starts_with("SPIRV_Cross_") || item.name.starts_with("main0_");
  if (item.kind == Item::Kind::function)
    return item.name == "main" || item.name == "main0" || item.name == "frag_main";
  const std::string_view declaration =
      std::string_view(text).substr(item.begin, item.end - item.begin);
  return !declaration.starts_with("static const") && !declaration.starts_with("constant")
         && !declaration.starts_with("using") && item.kind != Item::Kind::prototype;
}

std::string directives(const std::string& text) {
  std::string out;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("#include") || line.starts_with("#pragma")) out += line + '\n';
  return out;
}

gpu::shaders::Module compiled(const std::string& text) {
  return gpu::shaders::compile_text("snippet.frag", gpu::shaders::Stage::fragment, text,
                                    gpu::Backend::vulkan);
}

} // namespace

std::string converted(const std::string& glsl, Foreign language) {
  std::set<std::string> declared_only;
  for (const Item& item : items(glsl))
    if (item.kind == Item::Kind::prototype) declared_only.insert(item.name);
  const std::string text = translate(compiled(calling_all(glsl)).words, language);
  std::string out = directives(text);
  for (const Item& item : items(text)) {
    if (is_scaffold(text, item)) continue;
    const bool supplied = item.kind == Item::Kind::function && declared_only.contains(item.name);
    const std::size_t end = supplied ? item.header_end : item.end;
    out += (out.empty() ? "" : "\n") + text.substr(item.begin, end - item.begin)
           + (supplied ? "; // supplied by the engine\n" : "\n");
  }
  return out;
}

} // namespace gg::snippet
