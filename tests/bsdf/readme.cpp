// The blocks of code in shaders/README.md, compiled as they stand there. CMake extracts its C++
// block (CMakeLists.txt), and it is called here.
#include "bsdf/snippets.h"
#include "core/files.h"
#include "glsl/f32.h"
#include "glsl/f64.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <gtest/gtest.h>

#include <sstream>

double readme_glint(glm::dvec3 wi, glm::dvec3 wo, glm::dvec3 n); // readme_block.cpp
float readme_glint(glm::vec3 wi, glm::vec3 wo, glm::vec3 n);

namespace gg::snippet_test {
namespace {

// The fenced block that opens with ```glsl NAME, its includes replaced by the files, each once.
std::string block(const std::string& name) {
  std::istringstream lines(read_text(shaders() / "README.md"));
  const std::string opening = std::string("```glsl ").append(name);
  std::vector<std::filesystem::path> files;
  std::string before, after;
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    if (line == "```") inside = false;
    if (inside) {
      if (line.starts_with("#include \""))
        files.emplace_back(line.substr(10, line.size() - 11));
      else
        (files.empty() ? before : after) += line + "\n";
    }
    if (line == opening) inside = true;
  }
  return before + glsl::flatten(shaders(), files).text + after;
}

std::string complaint(const std::string& text, glslang::EShClient client) {
  glslang::InitializeProcess();
  const char* pointer = text.c_str();
  glslang::TShader shader(EShLangFragment);
  shader.setStrings(&pointer, 1);
  if (client != glslang::EShClientNone) {
    shader.setEnvInput(glslang::EShSourceGlsl, EShLangFragment, client, 100);
    shader.setEnvClient(client, client == glslang::EShClientVulkan ? glslang::EShTargetVulkan_1_0
                                                                   : glslang::EShTargetOpenGL_450);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_0);
  }
  const bool good = shader.parse(GetDefaultResources(), 100, false, EShMsgDefault);
  const std::string log = shader.getInfoLog();
  glslang::FinalizeProcess();
  return good ? std::string() : std::string("refused: ").append(log);
}

TEST(readme, shaders_compile_as_they_stand) {
  EXPECT_EQ(complaint(block("opengl"), glslang::EShClientOpenGL), "");
  EXPECT_EQ(complaint(block("vulkan"), glslang::EShClientVulkan), "");
  EXPECT_EQ(complaint(block("webgl2"), glslang::EShClientNone), "");
}

TEST(readme, cpp_compiles_as_it_stands_and_gives_the_same_number) {
  const glm::dvec3 wi(0.6, 0, 0.8), wo(-0.48, 0.36, 0.8), n(0, 0, 1);
  const auto m = glsl::f64::reflectionFacet(wi, wo, n, 1.5);
  const double d = glsl::f64::ggxD(m.h, 0.2), v = glsl::f64::ggxV(m.wi, m.wo, 0.2);
  EXPECT_EQ(readme_glint(wi, wo, n), glsl::f64::reflectionF(m, d, v, 1.5));

  const glm::vec3 singleWi(wi), singleWo(wo), singleN(n);
  const auto f = glsl::f32::reflectionFacet(singleWi, singleWo, singleN, 1.5F);
  const float e = glsl::f32::ggxD(f.h, 0.2F), w = glsl::f32::ggxV(f.wi, f.wo, 0.2F);
  EXPECT_EQ(readme_glint(singleWi, singleWo, singleN), glsl::f32::reflectionF(f, e, w, 1.5F));
}

TEST(readme, names_every_snippet_of_the_bsdf) {
  const std::string text = read_text(shaders() / "README.md");
  for (const auto& file : glsl::list_snippets(shaders(), "bsdf"))
    EXPECT_NE(text.find(std::string("`").append(file.stem()).append("`")), std::string::npos)
        << file;
}

} // namespace
} // namespace gg::snippet_test
