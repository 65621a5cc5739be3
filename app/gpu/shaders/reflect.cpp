#include "core/error.h"
#include "gpu/shaders/module.h"

#include <spirv_cross_c.h>

#include <algorithm>
#include <memory>
#include <span>

namespace gg::gpu::shaders {
namespace {

struct Destroy {
  void operator()(spvc_context context) const { spvc_context_destroy(context); }
};
using Context = std::unique_ptr<spvc_context_s, Destroy>;

// One SPIRV-Cross compiler over a module; all of its answers live as long as the context.
class Reader {
public:
  explicit Reader(const Module& module) : module_(module) {
    spvc_context context = nullptr;
    check(spvc_context_create(&context));
    context_.reset(context);
    spvc_parsed_ir ir = nullptr;
    check(spvc_context_parse_spirv(context, module.words.data(), module.words.size(), &ir));
    check(spvc_context_create_compiler(context, SPVC_BACKEND_NONE, ir,
                                       SPVC_CAPTURE_MODE_TAKE_OWNERSHIP, &compiler_));
    spvc_set active = nullptr;
    check(spvc_compiler_get_active_interface_variables(compiler_, &active));
    check(
        spvc_compiler_create_shader_resources_for_active_variables(compiler_, &resources_, active));
  }

  Reflection read() const {
    Reflection result;
    for (const auto& resource : list(SPVC_RESOURCE_TYPE_UNIFORM_BUFFER))
      result.bindings.push_back(block(resource, Kind::uniform_block));
    for (const auto& resource : list(SPVC_RESOURCE_TYPE_STORAGE_BUFFER))
      result.bindings.push_back(block(resource, Kind::storage_block));
    for (const auto& resource : list(SPVC_RESOURCE_TYPE_SAMPLED_IMAGE))
      result.bindings.push_back(image(resource, Kind::sampled));
    for (const auto& resource : list(SPVC_RESOURCE_TYPE_STORAGE_IMAGE))
      result.bindings.push_back(image(resource, Kind::image));
    std::ranges::sort(result.bindings, {}, &Binding::binding);
    result.inputs = varyings(SPVC_RESOURCE_TYPE_STAGE_INPUT);
    result.outputs = varyings(SPVC_RESOURCE_TYPE_STAGE_OUTPUT);
    result.constants = constants();
    if (module_.stage == Stage::compute)
      for (unsigned axis = 0; axis < 3; ++axis)
        result.local_size[axis] = spvc_compiler_get_execution_mode_argument_by_index(
            compiler_, SpvExecutionModeLocalSize, axis);
    return result;
  }

private:
  void check(spvc_result result) const {
    if (result == SPVC_SUCCESS) return;
    const char* text = context_ ? spvc_context_get_last_error_string(context_.get()) : nullptr;
    throw Error(ExitCode::internal, module_.name,
                std::string("its SPIR-V cannot be read: ") + (text ? text : "out of memory"));
  }

  std::span<const spvc_reflected_resource> list(spvc_resource_type type) const {
    const spvc_reflected_resource* first = nullptr;
    std::size_t count = 0;
    check(spvc_resources_get_resource_list_for_type(resources_, type, &first, &count));
    return {first, count};
  }

  unsigned decoration(SpvId id, SpvDecoration decoration) const {
    return spvc_compiler_get_decoration(compiler_, id, decoration);
  }

  Binding common(const spvc_reflected_resource& resource, Kind kind) const {
    Binding binding;
    binding.kind = kind;
    binding.set = decoration(resource.id, SpvDecorationDescriptorSet);
    if (!spvc_compiler_get_binary_offset_for_decoration(
            compiler_, resource.id, SpvDecorationBinding, &binding.binding_word))
      throw Error(ExitCode::internal, module_.name,
                  std::string(resource.name) + " has no layout(binding = ...)");
    binding.binding = decoration(resource.id, SpvDecorationBinding);
    const spvc_type type = spvc_compiler_get_type_handle(compiler_, resource.type_id);
    for (unsigned i = 0; i < spvc_type_get_num_array_dimensions(type); ++i)
      binding.count *= spvc_type_get_array_dimension(type, i);
    return binding;
  }

  Binding block(const spvc_reflected_resource& resource, Kind kind) const {
    Binding binding = common(resource, kind);
    binding.name = spvc_compiler_get_name(compiler_, resource.base_type_id);
    const spvc_type type = spvc_compiler_get_type_handle(compiler_, resource.base_type_id);
    check(spvc_compiler_get_declared_struct_size(compiler_, type, &binding.bytes));
    if (kind == Kind::storage_block) {
      const SpvDecoration* decorations = nullptr;
      std::size_t count = 0;
      check(
          spvc_compiler_get_buffer_block_decorations(compiler_, resource.id, &decorations, &count));
      const std::span all(decorations, count);
      binding.reads = std::ranges::find(all, SpvDecorationNonReadable) == all.end();
      binding.writes = std::ranges::find(all, SpvDecorationNonWritable) == all.end();
    }
    return binding;
  }

  Binding image(const spvc_reflected_resource& resource, Kind kind) const {
    Binding binding = common(resource, kind);
    binding.name = spvc_compiler_get_name(compiler_, resource.id);
    const spvc_type type = spvc_compiler_get_type_handle(compiler_, resource.base_type_id);
    const bool arrayed = spvc_type_get_image_arrayed(type);
    switch (spvc_type_get_image_dimension(type)) {
    case SpvDim2D:
      binding.shape = arrayed ? Shape::d2_array : Shape::d2;
      break;
    case SpvDim3D:
      binding.shape = Shape::d3;
      break;
    case SpvDimCube:
      binding.shape = arrayed ? Shape::cube_array : Shape::cube;
      break;
    default:
      throw Error(ExitCode::internal, module_.name,
                  binding.name + " is of a dimension that textures do not have");
    }
    const spvc_type texel =
        spvc_compiler_get_type_handle(compiler_, spvc_type_get_image_sampled_type(type));
    binding.integer = spvc_type_get_basetype(texel) != SPVC_BASETYPE_FP32;
    if (kind == Kind::image) {
      binding.format = format(spvc_type_get_image_storage_format(type), binding.name);
      binding.reads =
          !spvc_compiler_has_decoration(compiler_, resource.id, SpvDecorationNonReadable);
      binding.writes =
          !spvc_compiler_has_decoration(compiler_, resource.id, SpvDecorationNonWritable);
    }
    return binding;
  }

  Format format(SpvImageFormat format, const std::string& name) const {
    switch (format) {
    case SpvImageFormatUnknown:
      return Format::none; // writeonly without a qualifier
    case SpvImageFormatR8:
      return Format::r8;
    case SpvImageFormatRg8:
      return Format::rg8;
    case SpvImageFormatRgba8:
      return Format::rgba8;
    case SpvImageFormatR16f:
      return Format::r16f;
    case SpvImageFormatRg16f:
      return Format::rg16f;
    case SpvImageFormatRgba16f:
      return Format::rgba16f;
    case SpvImageFormatR32f:
      return Format::r32f;
    case SpvImageFormatRg32f:
      return Format::rg32f;
    case SpvImageFormatRgba32f:
      return Format::rgba32f;
    case SpvImageFormatR32ui:
      return Format::r32ui;
    case SpvImageFormatRg32ui:
      return Format::rg32ui;
    case SpvImageFormatRgba32ui:
      return Format::rgba32ui;
    default:
      throw Error(ExitCode::internal, module_.name,
                  name + " has a layout qualifier that is no Format of gpu/types.h");
    }
  }

  std::vector<Varying> varyings(spvc_resource_type which) const {
    std::vector<Varying> result;
    for (const auto& resource : list(which)) {
      const spvc_type type = spvc_compiler_get_type_handle(compiler_, resource.type_id);
      result.push_back({.name = resource.name,
                        .location = decoration(resource.id, SpvDecorationLocation),
                        .components = spvc_type_get_vector_size(type),
                        .floats = spvc_type_get_basetype(type) == SPVC_BASETYPE_FP32});
    }
    std::ranges::sort(result, {}, &Varying::location);
    return result;
  }

  std::vector<ConstantInfo> constants() const {
    const spvc_specialization_constant* first = nullptr;
    std::size_t count = 0;
    check(spvc_compiler_get_specialization_constants(compiler_, &first, &count));
    std::vector<ConstantInfo> result;
    for (const auto& constant : std::span(first, count)) {
      const spvc_constant value = spvc_compiler_get_constant_handle(compiler_, constant.id);
      result.push_back({.name = spvc_compiler_get_name(compiler_, constant.id),
                        .id = constant.constant_id,
                        .bits = spvc_constant_get_scalar_u32(value, 0, 0)});
    }
    std::ranges::sort(result, {}, &ConstantInfo::id);
    return result;
  }

  const Module& module_;
  Context context_;
  spvc_compiler compiler_ = nullptr;
  spvc_resources resources_ = nullptr;
};

} // namespace

Reflection reflect(const Module& module) {
  return Reader(module).read();
}

} // namespace gg::gpu::shaders
