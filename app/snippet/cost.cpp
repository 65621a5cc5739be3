#include "core/error.h"
#include "gpu/shaders/compile.h"
#include "snippet/convert.h"
#include "snippet/driver.h"

#include <GLSL.std.450.h>
#include <spirv-tools/optimizer.hpp>
#include <spirv.hpp>

#include <algorithm>

namespace gg::snippet {
namespace {

std::vector<std::uint32_t> inlined(const std::vector<std::uint32_t>& words) {
  spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_1);
  optimizer.RegisterPerformancePasses();
  spvtools::OptimizerOptions options;
  options.set_run_validator(false);
  std::vector<std::uint32_t> result;
  if (!optimizer.Run(words.data(), words.size(), &result, options))
    throw Error(ExitCode::internal, "SPIRV-Tools", "cannot optimise a snippet");
  return result;
}

void count_extended(std::uint32_t instruction, Cost& cost) {
  switch (instruction) {
  case GLSLstd450Sqrt:
  case GLSLstd450InverseSqrt:
  case GLSLstd450Length:
  case GLSLstd450Distance:
  case GLSLstd450Normalize:
    ++cost.roots;
    break;
  case GLSLstd450Sin:
  case GLSLstd450Cos:
  case GLSLstd450Tan:
  case GLSLstd450Asin:
  case GLSLstd450Acos:
  case GLSLstd450Atan:
  case GLSLstd450Atan2:
  case GLSLstd450Pow:
  case GLSLstd450Exp:
  case GLSLstd450Log:
  case GLSLstd450Exp2:
  case GLSLstd450Log2:
    ++cost.trigonometric;
    break;
  default:
    ++cost.arithmetic;
  }
}

void count(spv::Op op, const std::uint32_t* operands, Cost& cost) {
  const auto within = [&](spv::Op first, spv::Op last) { return op >= first && op <= last; };
  if (op == spv::OpExtInst)
    count_extended(operands[3], cost);
  else if (within(spv::OpSNegate, spv::OpDot)
           || within(spv::OpLogicalEqual, spv::OpFUnordGreaterThanEqual))
    ++cost.arithmetic;
  else if (within(spv::OpImageSampleImplicitLod, spv::OpImageRead))
    ++cost.reads;
  else if (op == spv::OpBranchConditional || op == spv::OpSwitch)
    ++cost.branches;
}

} // namespace

Cost cost(const std::string& glsl, const std::string& function) {
  const std::vector<Item> declared = items(glsl);
  const auto found = std::ranges::find_if(declared, [&](const Item& item) {
    return item.kind == Item::Kind::function && item.name == function;
  });
  if (found == declared.end())
    throw Error(ExitCode::internal, function, "is no function of this snippet");
  const gpu::shaders::Module module =
      gpu::shaders::compile_text("snippet.frag", gpu::shaders::Stage::fragment,
                                 calling_one(glsl, *found), gpu::Backend::vulkan);
  const std::vector<std::uint32_t> words = inlined(module.words);
  Cost cost;
  constexpr std::size_t header = 5;
  for (std::size_t at = header; at < words.size(); at += words[at] >> spv::WordCountShift)
    count(static_cast<spv::Op>(words[at] & spv::OpCodeMask), words.data() + at + 1, cost);
  return cost;
}

} // namespace gg::snippet
