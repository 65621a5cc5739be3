#include "core/error.h"
#include "gpu/shaders/compile.h"

#include <algorithm>

namespace gg::gpu::shaders {
namespace {

const char* word(Kind kind) {
  switch (kind) {
  case Kind::uniform_block:
    return "a uniform block";
  case Kind::storage_block:
    return "a storage block";
  case Kind::sampled:
    return "a sampler";
  case Kind::image:
    return "an image";
  }
  return "";
}

[[noreturn]] void refuse(const std::string& label, const Module& module, const std::string& what) {
  throw Error(ExitCode::internal, "pipeline '" + label + "', " + module.name, what);
}

// Adds one stage's bindings to those of the stages before it.
void join(const std::string& label, const Module& module, const Reflection& reflection,
          std::vector<Binding>& all) {
  for (const Binding& binding : reflection.bindings) {
    const std::string number = std::to_string(binding.binding);
    if (binding.set != 0)
      refuse(label, module, binding.name + " is in set " + std::to_string(binding.set) + ", not 0");
    if (binding.count != 1) refuse(label, module, binding.name + " is an array of resources");
    const auto same_name = std::ranges::find(all, binding.name, &Binding::name);
    const auto same_number = std::ranges::find(all, binding.binding, &Binding::binding);
    if (same_number != all.end() && same_number->name != binding.name)
      refuse(label, module,
             binding.name + " and " + same_number->name + " both have binding " + number);
    if (same_name == all.end()) {
      all.push_back(binding);
      continue;
    }
    if (same_name->binding != binding.binding)
      refuse(label, module,
             binding.name + " has binding " + number + " here and "
                 + std::to_string(same_name->binding) + " in another stage");
    if (same_name->kind != binding.kind || same_name->shape != binding.shape
        || same_name->integer != binding.integer || same_name->bytes != binding.bytes)
      refuse(label, module,
             binding.name + " is " + word(binding.kind)
                 + " unlike the one of that name in another stage");
    same_name->reads |= binding.reads;
    same_name->writes |= binding.writes;
  }
}

void check_constants(const std::string& label, std::span<const Constant> constants,
                     std::span<const std::shared_ptr<const Module>> modules) {
  std::vector<ConstantInfo> known;
  for (const auto& module : modules) {
    const std::vector<ConstantInfo> some = reflect(*module).constants;
    known.insert(known.end(), some.begin(), some.end());
  }
  for (const Constant& constant : constants)
    if (std::ranges::find(known, constant.id, &ConstantInfo::id) == known.end())
      throw Error(ExitCode::internal, "pipeline '" + label + "'",
                  "none of its stages has a constant_id " + std::to_string(constant.id));
}

void check_varyings(const std::string& label, const Program& program) {
  if (program.modules.size() != 2) return;
  const std::vector<Varying>& written = program.reflections[0].outputs;
  for (const Varying& input : program.reflections[1].inputs) {
    const auto output = std::ranges::find(written, input.location, &Varying::location);
    if (output == written.end() || output->components < input.components
        || output->floats != input.floats)
      refuse(label, program.modules[1],
             "input " + input.name + " at location " + std::to_string(input.location)
                 + " is not written as such by " + program.modules[0].name);
  }
}

} // namespace

Program link(const std::string& label, std::span<const std::string> stages,
             std::span<const Constant> constants, Backend backend) {
  std::vector<std::shared_ptr<const Module>> modules;
  for (const std::string& stage : stages)
    modules.push_back(compile(stage, backend));
  if (!constants.empty()) check_constants(label, constants, modules);

  Program program;
  for (const auto& module : modules) {
    program.modules.push_back(specialize(*module, constants, backend));
    program.reflections.push_back(reflect(program.modules.back()));
    join(label, program.modules.back(), program.reflections.back(), program.bindings);
  }
  check_varyings(label, program);
  std::ranges::sort(program.bindings, {}, &Binding::name);
  return program;
}

} // namespace gg::gpu::shaders
