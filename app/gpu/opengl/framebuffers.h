// Framebuffer objects, one for each set of targets that has been drawn into.
#pragma once

#include "gpu/opengl/gl.h"

#include <cstdint>
#include <string>
#include <vector>

namespace gg::gpu::opengl {

class Context;

struct Attachment {
  std::uint64_t texture_serial = 0;
  GLuint texture = 0;
  int level = 0, layer = 0;
  bool layered = false; // the texture has layers to choose from
  bool operator==(const Attachment&) const = default;
};

class Framebuffers {
public:
  // `depth.texture` 0: none. A new one is labelled `label`.
  GLuint find_or_make(Context& context, const std::vector<Attachment>& colors,
                      const Attachment& depth, const std::string& label);
  void forget(const GladGLContext& gl, std::uint64_t texture_serial); // it is being destroyed
  void clear(const GladGLContext& gl);

private:
  struct Entry {
    std::vector<Attachment> colors;
    Attachment depth;
    GLuint name = 0;
  };
  std::vector<Entry> entries_;
};

} // namespace gg::gpu::opengl
