#include "core/error.h"
#include "gpu/shaders/compile.h"

#include <spirv-tools/optimizer.hpp>

#include <unordered_map>

namespace gg::gpu::shaders {

Module specialize(const Module& module, std::span<const Constant> constants, Backend backend) {
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> values;
  for (const Constant& constant : constants)
    values[constant.id] = {constant.bits};

  spvtools::Optimizer optimizer(backend == Backend::vulkan ? SPV_ENV_VULKAN_1_1
                                                           : SPV_ENV_OPENGL_4_5);
  std::string log;
  optimizer.SetMessageConsumer(
      [&](spv_message_level_t, const char*, const spv_position_t&, const char* text) {
        log += std::string(log.empty() ? "" : "; ") + text;
      });
  // Fix the values, fold what follows from them, cut the branches never taken and then what only
  // those used. Nothing more: drivers optimise, and should see code close to the text. (So a
  // feature's branch must test the constant or an expression of constants, not a local copy.)
  optimizer.RegisterPass(spvtools::CreateSetSpecConstantDefaultValuePass(values))
      .RegisterPass(spvtools::CreateFreezeSpecConstantValuePass())
      .RegisterPass(spvtools::CreateFoldSpecConstantOpAndCompositePass())
      .RegisterPass(spvtools::CreateDeadBranchElimPass())
      .RegisterPass(spvtools::CreateEliminateDeadFunctionsPass())
      .RegisterPass(spvtools::CreateAggressiveDCEPass());
  spvtools::OptimizerOptions options;
  options.set_run_validator(false);
  Module result{module.name, module.stage, {}};
  if (!optimizer.Run(module.words.data(), module.words.size(), &result.words, options))
    throw Error(ExitCode::internal, module.name, "cannot be specialised: " + log);
  return result;
}

} // namespace gg::gpu::shaders
