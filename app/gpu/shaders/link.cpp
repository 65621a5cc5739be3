#include "core/error.h"
#include "gpu/shaders/compile.h"
#include "gpu/shaders/module_cache.h"

#include <algorithm>
#include <functional>
#include <future>
#include <map>
#include <mutex>
#include <optional>
#include <semaphore>
#include <thread>

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

// A stage that no earlier run has specialised: to be kept once the pipeline is found sound.
struct Fresh {
  std::size_t stage;
  std::string key;
};

Program linked(const std::string& label, std::span<const std::string> stages,
               std::span<const Constant> constants, Backend backend) {
  Program program;
  std::vector<std::shared_ptr<const Module>> compiled;
  std::vector<Fresh> fresh;
  for (const std::string& stage : stages) {
    const std::optional<std::string> key = module_key(stage, constants, backend);
    std::optional<Module> known = key ? load_module(*key, stage) : std::nullopt;
    if (!known) {
      compiled.push_back(compile(stage, backend));
      if (key) fresh.push_back({program.modules.size(), *key});
    }
    program.modules.push_back(known ? std::move(*known)
                                    : specialize(*compiled.back(), constants, backend));
  }
  // Of stages that are kept the constants were checked when they were linked first.
  if (!constants.empty() && compiled.size() == stages.size())
    check_constants(label, constants, compiled);
  for (const Module& module : program.modules) {
    program.reflections.push_back(reflect(module));
    join(label, module, program.reflections.back(), program.bindings);
  }
  check_varyings(label, program);
  std::ranges::sort(program.bindings, {}, &Binding::name);
  for (const Fresh& stage : fresh)
    store_module(stage.key, program.modules[stage.stage]);
  return program;
}

// Programs that are being linked, by what they are made of. Each is handed out once.
class Ahead {
public:
  Ahead() { // after the statics that its threads use
    keep_modules();
    keep_keys();
  }

  static std::string key_of(const std::string& label, std::span<const std::string> stages,
                            std::span<const Constant> constants, Backend backend) {
    std::string key = label + (backend == Backend::vulkan ? " vulkan" : " opengl");
    for (const std::string& stage : stages)
      key += ' ' + stage;
    for (const Constant& constant : constants)
      key += ' ' + std::to_string(constant.id) + '=' + std::to_string(constant.bits);
    return key;
  }

  void start(const std::string& key, std::function<Program()> link) {
    const std::lock_guard lock(mutex_);
    std::future<Program>& program = programs_[key];
    if (program.valid()) return;
    program = std::async(std::launch::async, [this, link = std::move(link)] {
      cores_.acquire();
      struct Release {
        std::counting_semaphore<>& cores;
        ~Release() { cores.release(); }
      } const release{cores_};
      return link();
    });
  }

  std::optional<std::future<Program>> take(const std::string& key) {
    const std::lock_guard lock(mutex_);
    auto node = programs_.extract(key);
    if (node.empty()) return std::nullopt;
    return std::move(node.mapped());
  }

private:
  std::mutex mutex_;
  std::counting_semaphore<> cores_{
      static_cast<std::ptrdiff_t>(std::max(std::thread::hardware_concurrency(), 1u))};
  std::map<std::string, std::future<Program>> programs_; // last: its threads use the others
};

Ahead& ahead() {
  static Ahead all;
  return all;
}

} // namespace

Program link(const std::string& label, std::span<const std::string> stages,
             std::span<const Constant> constants, Backend backend) {
  if (auto under_way = ahead().take(Ahead::key_of(label, stages, constants, backend)))
    return under_way->get();
  return linked(label, stages, constants, backend);
}

void link_ahead(const std::string& label, std::span<const std::string> stages,
                std::span<const Constant> constants, Backend backend) {
  ahead().start(Ahead::key_of(label, stages, constants, backend),
                [label, stages = std::vector(stages.begin(), stages.end()),
                 constants = std::vector(constants.begin(), constants.end()),
                 backend] { return linked(label, stages, constants, backend); });
}

} // namespace gg::gpu::shaders
