// What only OpenGL can be asked: labels, messages of the driver.
#include "core/error.h"
#include "gpu/fixture.h"
#include "gpu/opengl/device.h"
#include "gpu/opengl/resources.h"

namespace gg::gpu::opengl {
namespace {

class OpenGl : public testing::TestWithParam<Surface> {
protected:
  ContextRef context = std::make_shared<Context>(
      GetParam() == Surface::egl ? surface::open_egl(surface::egl_choices().at(0), true)
                                 : surface::open_osmesa(),
      true);
  GlDevice device{context, {}};

  std::string label(GLenum kind, GLuint name) {
    std::array<char, 256> text{};
    context->gl().GetObjectLabel(kind, name, static_cast<GLsizei>(text.size()), nullptr,
                                 text.data());
    return text.data();
  }
};

TEST_P(OpenGl, every_object_is_labelled) {
  const BufferRef buffer = device.create(BufferDesc{"a buffer", 16, Use::uniforms}, {});
  const TextureRef texture =
      device.create(TextureDesc{.label = "a texture", .shape = Shape::cube, .levels = 1});
  auto& gl_texture = static_cast<GlTexture&>(*texture);
  const GlTexture::Handle face = gl_texture.handle({.texture = texture, .layer = 2}, Shape::d2);
  const PipelineRef pipeline = device.create(flat_pipeline(Format::rgba8));
  const auto& gl_pipeline = static_cast<const GlPipeline&>(*pipeline);
  const SamplerRef sampler = device.create(SamplerDesc{});
  EXPECT_EQ(label(GL_BUFFER, static_cast<const GlBuffer&>(*buffer).name), "a buffer");
  EXPECT_EQ(label(GL_TEXTURE, gl_texture.name), "a texture");
  EXPECT_EQ(label(GL_TEXTURE, face.name), "a texture (part)");
  EXPECT_EQ(label(GL_PROGRAM, gl_pipeline.program), "flat");
  EXPECT_EQ(label(GL_VERTEX_ARRAY, gl_pipeline.vertex_array), "flat");
  EXPECT_NE(label(GL_SAMPLER, static_cast<const GlSampler&>(*sampler).name), "");
}

TEST_P(OpenGl, a_framebuffer_is_labelled_with_its_first_pass) {
  const TextureRef color = device.create(TextureDesc{.label = "colour", .use = Use::attachment});
  GLint name = 0;
  const Pass pass = {
      .label = "the pass", .colors = {{.view = {color}, .clear = {}}}, .record = [&](Encoder&) {
        context->gl().GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &name);
      }};
  device.run(std::span(&pass, 1), nullptr);
  EXPECT_EQ(label(GL_FRAMEBUFFER, static_cast<GLuint>(name)), "the pass");
}

TEST_P(OpenGl, messages_of_the_driver_are_errors_that_name_the_pass) {
  const TextureRef color = device.create(TextureDesc{.label = "colour", .use = Use::attachment});
  const Pass pass = {.label = "the pass",
                     .colors = {{.view = {color}, .clear = {}}},
                     .record = [&](Encoder&) { context->gl().Enable(GL_TEXTURE_2D_ARRAY); }};
  try {
    device.run(std::span(&pass, 1), nullptr);
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::device);
    EXPECT_TRUE(says(error.what(), {"the pass"}));
    EXPECT_TRUE(says(error.what(), {"glEnable"})); // the driver's own words
  }
  device.finish(); // and that is all
}

TEST_P(OpenGl, an_old_or_missing_choice_is_said) {
  EXPECT_THROW(surface::open_egl({.device = 1000}, false), Error);
}

} // namespace

INSTANTIATE_TEST_SUITE_P(surfaces, OpenGl, testing::Values(Surface::egl, Surface::osmesa),
                         [](const auto& of) {
                           return of.param == Surface::egl ? "egl" : "osmesa";
                         });

} // namespace gg::gpu::opengl
