// A compiled stage, and what its SPIR-V says about itself.
#pragma once

#include "gpu/types.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace gg::gpu::shaders {

enum class Stage { vertex, fragment, compute };

// SPIR-V of one stage. `name` is the file's, as messages show it.
struct Module {
  std::string name;
  Stage stage = Stage::vertex;
  std::vector<std::uint32_t> words;
};

enum class Kind { uniform_block, storage_block, sampled, image };

// One resource. Its name is what GLSL calls it from outside: a block's block name ("Frame" in
// `uniform Frame {...} frame;`), a sampler's or an image's variable name.
struct Binding {
  std::string name;
  Kind kind = Kind::uniform_block;
  unsigned set = 0, binding = 0;
  unsigned count = 1;           // elements, if it is an array
  std::size_t bytes = 0;        // blocks: the declared size; an unsized array at the end counts 0
  bool reads = true;            // storage blocks and images: not `writeonly`
  bool writes = false;          // storage blocks and images: not `readonly`
  Shape shape = Shape::d2;      // samplers and images
  bool integer = false;         // samplers and images: usampler2D, uimage2D
  Format format = Format::none; // images: the layout qualifier
  unsigned binding_word = 0;    // where in Module::words its Binding decoration has its number
};

// A vertex input, or what one stage hands to the next.
struct Varying {
  std::string name;
  unsigned location = 0;
  unsigned components = 1;
  bool floats = true;
};

// A specialization constant and the value that it has unless told otherwise.
struct ConstantInfo {
  std::string name;
  std::uint32_t id = 0;
  std::uint32_t bits = 0;
};

struct Reflection {
  std::vector<Binding> bindings; // ordered by binding number
  std::vector<Varying> inputs, outputs;
  std::vector<ConstantInfo> constants;
  std::array<std::uint32_t, 3> local_size{1, 1, 1}; // compute
};

// What `module` declares and its entry point can reach. Throws Error(internal) if the words are not
// SPIR-V.
Reflection reflect(const Module& module);

} // namespace gg::gpu::shaders
