#include "gpu/opengl/pipeline.h"

#include "core/error.h"

#include <algorithm>
#include <array>

namespace gg::gpu::opengl {
namespace {

using shaders::Kind;
using shaders::Stage;

GLenum name(Stage stage) {
  switch (stage) {
  case Stage::vertex:
    return GL_VERTEX_SHADER;
  case Stage::fragment:
    return GL_FRAGMENT_SHADER;
  case Stage::compute:
    return GL_COMPUTE_SHADER;
  }
  return GL_NONE;
}

std::string log_of(const GladGLContext& gl, GLuint object, bool program) {
  GLint length = 0;
  program ? gl.GetProgramiv(object, GL_INFO_LOG_LENGTH, &length)
          : gl.GetShaderiv(object, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
  program ? gl.GetProgramInfoLog(object, length, nullptr, log.data())
          : gl.GetShaderInfoLog(object, length, nullptr, log.data());
  log.resize(std::min(log.find('\0'), log.size()));
  return log.empty() ? "the driver refuses it without saying why" : log;
}

GLuint make_shader(Context& context, const shaders::Module& module) {
  const GladGLContext& gl = context.gl();
  const GLuint shader = gl.CreateShader(name(module.stage));
  gl.ShaderBinary(1, &shader, GL_SHADER_BINARY_FORMAT_SPIR_V_ARB, module.words.data(),
                  static_cast<GLsizei>(module.words.size() * sizeof(std::uint32_t)));
  // The constants are fixed in the module already (shaders::specialize).
  gl.SpecializeShaderARB(shader, "main", 0, nullptr, nullptr);
  context.label(GL_SHADER, shader, module.name);
  ++context.counters.compiled;
  GLint done = GL_FALSE;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &done);
  if (!done) {
    const std::string log = log_of(gl, shader, false);
    gl.DeleteShader(shader);
    throw Error(ExitCode::internal, module.name, log);
  }
  return shader;
}

} // namespace

GlPipeline::GlPipeline(ContextRef owner, Names& names, const PipelineDesc& desc)
    : context(std::move(owner)) {
  label = desc.label;
  drawing = desc;
  try {
    build(names, std::array{desc.vertex, desc.fragment}, desc.constants);
  } catch (...) {
    destroy();
    throw;
  }
}

GlPipeline::GlPipeline(ContextRef owner, Names& names, const ComputeDesc& desc)
    : context(std::move(owner)) {
  label = desc.label;
  try {
    build(names, std::array{desc.compute}, desc.constants);
  } catch (...) {
    destroy();
    throw;
  }
}

GlPipeline::~GlPipeline() {
  destroy();
}

void GlPipeline::destroy() noexcept {
  try {
    const GladGLContext& gl = context->gl();
    if (program) gl.DeleteProgram(program);
    if (vertex_array) gl.DeleteVertexArrays(1, &vertex_array);
  } catch (const Error&) {
    // Not reachable from this thread: the context takes them along when it ends.
  }
}

void GlPipeline::build(Names& names, std::span<const std::string> stages,
                       std::span<const Constant> constants) {
  shaders::Program linked = shaders::link(label, stages, constants, Backend::opengl);
  const bool draws = linked.modules.front().stage == Stage::vertex;
  if (draws != drawing.has_value() || (draws && linked.modules[1].stage != Stage::fragment))
    throw Error(ExitCode::internal, "pipeline '" + label + "'",
                "needs a .vert and a .frag stage to draw, or a .comp stage to compute");

  // Binding numbers are unique across kinds, but OpenGL has few units of each kind (8 for images):
  // number each kind on its own.
  std::array<GLuint, 4> used{};
  for (const shaders::Binding& binding : linked.bindings)
    slots.push_back(
        {names.add(binding.name), used[static_cast<std::size_t>(binding.kind)]++, binding});
  for (std::size_t i = 0; i < linked.modules.size(); ++i)
    for (const shaders::Binding& binding : linked.reflections[i].bindings) {
      const auto slot =
          std::ranges::find(slots, binding.name, [](const Slot& s) { return s.binding.name; });
      linked.modules[i].words[binding.binding_word] = slot->unit;
    }

  const GladGLContext& gl = context->gl();
  program = gl.CreateProgram();
  context->label(GL_PROGRAM, program, label);
  for (const shaders::Module& module : linked.modules) {
    const GLuint shader = make_shader(*context, module);
    gl.AttachShader(program, shader);
    gl.DeleteShader(shader); // lives as long as it is attached
  }
  gl.LinkProgram(program);
  ++context->counters.compiled;
  ++context->counters.created;
  GLint done = GL_FALSE;
  gl.GetProgramiv(program, GL_LINK_STATUS, &done);
  if (!done) throw Error(ExitCode::internal, "pipeline '" + label + "'", log_of(gl, program, true));
  if (draws) lay_out_vertices(linked.reflections.front());
  context->check("creating pipeline '" + label + "'");
}

void GlPipeline::lay_out_vertices(const shaders::Reflection& vertex_stage) {
  const GladGLContext& gl = context->gl();
  gl.CreateVertexArrays(1, &vertex_array);
  context->label(GL_VERTEX_ARRAY, vertex_array, label);
  ++context->counters.created;
  for (const Attribute& attribute : drawing->attributes) {
    const auto location = static_cast<GLuint>(attribute.location);
    gl.EnableVertexArrayAttrib(vertex_array, location);
    gl.VertexArrayAttribFormat(vertex_array, location, attribute.components, GL_FLOAT, GL_FALSE,
                               attribute.offset);
    gl.VertexArrayAttribBinding(vertex_array, location, static_cast<GLuint>(attribute.binding));
  }
  for (std::size_t i = 0; i < drawing->bindings.size(); ++i)
    gl.VertexArrayBindingDivisor(vertex_array, static_cast<GLuint>(i),
                                 drawing->bindings[i].step == Step::instance ? 1 : 0);
  for (const shaders::Varying& input : vertex_stage.inputs)
    if (std::ranges::find(drawing->attributes, static_cast<int>(input.location),
                          &Attribute::location)
        == drawing->attributes.end())
      throw Error(ExitCode::internal, "pipeline '" + label + "'",
                  "has no attribute for input " + input.name + " at location "
                      + std::to_string(input.location));
}

} // namespace gg::gpu::opengl
