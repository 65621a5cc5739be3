#include "gpu/opengl/window.h"

#include "core/error.h"
#include "gpu/backends.h"
#include "gpu/opengl/resources.h"

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>

namespace gg::gpu::opengl {

GlWindow::GlWindow(const WindowDesc& desc)
    : DesktopWindow(desc, true),
      context_(std::make_shared<Context>(window_.context(), desc.debug)) {
  device_ = std::make_unique<GlDevice>(context_,
                                       DeviceInfo{.index = -1,
                                                  .backend = "opengl",
                                                  .surface = "window",
                                                  .name = context_->renderer(),
                                                  .driver = context_->version(),
                                                  .software = is_software(context_->renderer())});
  glfwSwapInterval(desc.wait_for_display ? 1 : 0);
  window_.start_panels();
  ImGui_ImplOpenGL3_Init("#version 450 core");
}

GlWindow::~GlWindow() {
  try {
    context_->gl(); // makes it current
    ImGui_ImplOpenGL3_Shutdown();
  } catch (const Error&) {
    // On another thread: the context takes the panels' objects along.
  }
}

void GlWindow::begin_frame() {
  context_->gl();
  ImGui_ImplOpenGL3_NewFrame();
  window_.begin_panels();
}

void GlWindow::present(const TextureRef& picture, std::vector<std::byte>* shown) {
  const GladGLContext& gl = context_->gl();
  ImGui::Render();
  if (width() == 0 || height() == 0) return;
  GlTexture& from = of(picture, "a window");
  context_->make_visible(from.written);
  const GLuint framebuffer = context_->framebuffers.find_or_make(
      *context_, {from.attachment(whole(picture))}, Attachment{}, "picture of the window");
  gl.Disable(GL_FRAMEBUFFER_SRGB); // the picture is encoded
  // Row 0 of a picture is its top, and OpenGL's windows begin at the bottom.
  gl.BlitNamedFramebuffer(framebuffer, 0, 0, 0, picture->desc.width, picture->desc.height, 0,
                          height(), width(), 0, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  if (shown) {
    const std::size_t row = 4 * static_cast<std::size_t>(width());
    shown->resize(row * static_cast<std::size_t>(height()));
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    gl.ReadBuffer(GL_BACK);
    gl.ReadPixels(0, 0, width(), height(), GL_RGBA, GL_UNSIGNED_BYTE, shown->data());
    for (std::size_t low = 0, high = static_cast<std::size_t>(height()) - 1; low < high;
         ++low, --high)
      std::swap_ranges(shown->begin() + static_cast<std::ptrdiff_t>(low * row),
                       shown->begin() + static_cast<std::ptrdiff_t>((low + 1) * row),
                       shown->begin() + static_cast<std::ptrdiff_t>(high * row));
  }
  gl.Enable(GL_FRAMEBUFFER_SRGB);
  context_->check("showing the window");
  glfwSwapBuffers(window_.handle());
}

std::unique_ptr<Window> create_window(const WindowDesc& desc) {
  return std::make_unique<GlWindow>(desc);
}

} // namespace gg::gpu::opengl
