// Rough glass in OpenGL 4.5, offscreen: README.md beside this file says what each pass is.
//   rough_glass [SCENE.glb [ENVIRONMENT.hdr [OUT [WIDTH HEIGHT [SAMPLES [TIER]]]]]]
#define GL_GLEXT_PROTOTYPES
#include "scene.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/glcorearb.h>

namespace {

void open_device() { // no window: EGL without a surface
  const auto display_of = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
      eglGetProcAddress("eglGetPlatformDisplayEXT"));
  const EGLDisplay display =
      display_of ? display_of(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)
                 : eglGetDisplay(EGL_DEFAULT_DISPLAY);
  if (!eglInitialize(display, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API))
    fail("EGL cannot be started");
  const EGLint wanted[] = {EGL_CONTEXT_MAJOR_VERSION,
                           4,
                           EGL_CONTEXT_MINOR_VERSION,
                           5,
                           EGL_CONTEXT_OPENGL_PROFILE_MASK,
                           EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                           EGL_NONE};
  const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted);
  if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context))
    fail("no OpenGL 4.5 without a surface");
}

GLuint program_of(const std::string& vertex, const std::string& fragment) {
  const GLuint program = glCreateProgram();
  for (const auto& [kind, file] :
       {std::pair{GL_VERTEX_SHADER, vertex}, std::pair{GL_FRAGMENT_SHADER, fragment}}) {
    const GLuint shader = glCreateShader(kind);
    const std::string text = bytes_of("shaders/" + file);
    const char* begin = text.c_str();
    glShaderSource(shader, 1, &begin, nullptr);
    glCompileShader(shader);
    glAttachShader(program, shader);
  }
  glLinkProgram(program);
  GLint good = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &good);
  char log[4096] = "";
  if (!good) glGetProgramInfoLog(program, sizeof log, nullptr, log);
  if (!good) fail(fragment + ": " + log);
  return program;
}

GLuint texture_of(GLenum format, int width, int height, int levels, GLenum filter,
                  GLenum wrap = GL_CLAMP_TO_EDGE) {
  GLuint texture;
  glCreateTextures(GL_TEXTURE_2D, 1, &texture);
  glTextureStorage2D(texture, levels, format, width, height);
  glTextureParameteri(texture, GL_TEXTURE_MAG_FILTER, GLint(filter));
  glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER,
                      levels > 1 ? GL_LINEAR_MIPMAP_LINEAR : GLint(filter));
  glTextureParameteri(texture, GL_TEXTURE_WRAP_S, GLint(wrap));
  glTextureParameteri(texture, GL_TEXTURE_WRAP_T, GLint(wrap));
  return texture;
}

GLuint picture_texture(const Picture& p, GLenum format) {
  const int levels = p.nearest ? 1 : 1 + int(std::log2(std::max(p.width, p.height)));
  const GLuint texture =
      texture_of(format, p.width, p.height, levels, p.nearest ? GL_NEAREST : GL_LINEAR,
                 p.clamped ? GL_CLAMP_TO_EDGE : GL_REPEAT);
  glTextureSubImage2D(texture, 0, 0, 0, p.width, p.height, GL_RGBA, GL_UNSIGNED_BYTE,
                      p.texels.data());
  glGenerateTextureMipmap(texture);
  return texture;
}

GLuint table_texture(const Table& table) {
  GLuint texture;
  glCreateTextures(GL_TEXTURE_3D, 1, &texture);
  glTextureStorage3D(texture, 1, GL_RGBA16F, table.size[0], table.size[1], table.size[2]);
  glTextureSubImage3D(texture, 0, 0, 0, 0, table.size[0], table.size[1], table.size[2], GL_RGBA,
                      GL_HALF_FLOAT, table.halves.data());
  for (const GLenum name : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTextureParameteri(texture, name, GL_LINEAR);
  for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    glTextureParameteri(texture, axis, GL_CLAMP_TO_EDGE);
  return texture;
}

GLuint target_of(GLuint color, GLuint depth, int level = 0) {
  GLuint target;
  glCreateFramebuffers(1, &target);
  glNamedFramebufferTexture(target, GL_COLOR_ATTACHMENT0, color, level);
  if (depth) glNamedFramebufferTexture(target, GL_DEPTH_ATTACHMENT, depth, 0);
  return target;
}

template <class T>
GLuint buffer_of(const std::vector<T>& data) {
  GLuint buffer;
  glCreateBuffers(1, &buffer);
  glNamedBufferStorage(buffer, GLsizeiptr(data.size() * sizeof(T)), data.data(), 0);
  return buffer;
}

struct Body {
  const Mesh* mesh;
  GLuint array, color, roughness;
};

// One layer of faces of glass.
struct FaceLayer {
  GLuint program, target;
};

class Renderer {
public:
  Renderer(const Scene& scene, const Environment& map, int width, int height, bool pairs)
      : scene_(scene), width_(width), height_(height), last_(last_level_of(width, height)) {
    sky_ = program_of("fullscreen.vert", "sky.frag");
    body_ = program_of("mesh.vert", "body.frag");
    glass_ = program_of("mesh.vert", pairs ? "glass_pairs.frag" : "glass.frag");
    halve_ = program_of("fullscreen.vert", "halve.frag");
    glCreateVertexArrays(1, &nothing_);
    glCreateBuffers(2, blocks_);
    glNamedBufferStorage(blocks_[FRAME], sizeof(FrameBlock), nullptr, GL_DYNAMIC_STORAGE_BIT);
    glNamedBufferStorage(blocks_[DRAW], sizeof(DrawBlock), nullptr, GL_DYNAMIC_STORAGE_BIT);
    for (const GLuint at : {0U, 1U})
      glBindBufferBase(GL_UNIFORM_BUFFER, at, blocks_[at]);
    const auto tables = tables_of(".");
    for (int k = 0; k < 3; ++k)
      glBindTextureUnit(GLuint(ENERGY + k), table_texture(tables[k]));
    for (const Mesh& mesh : scene.meshes)
      bodies_.push_back(body_of(mesh));
    scene_depth_ = texture_of(GL_DEPTH_COMPONENT32F, width, height, 1, GL_NEAREST);
    pyramid_ = texture_of(GL_RGBA16F, width, height, last_ + 1, GL_LINEAR);
    for (int k = 0; k <= last_; ++k)
      levels_.push_back(target_of(pyramid_, k == 0 ? scene_depth_ : 0, k));
    const char* const layers[] = {"back_faces.frag", "second_fronts.frag", "second_backs.frag"};
    const GLuint depth = texture_of(GL_DEPTH_COMPONENT32F, width, height, 1, GL_NEAREST);
    for (GLuint k = 0; k < (pairs ? 3U : 1U); ++k) {
      const GLuint faces = texture_of(GL_RGBA32F, width, height, 1, GL_NEAREST);
      faces_.push_back({program_of("mesh.vert", layers[k]), target_of(faces, depth)});
      glBindTextureUnit(BACKS + k, faces);
    }
    frame_ = target_of(texture_of(GL_RGBA16F, width, height, 1, GL_NEAREST),
                       texture_of(GL_DEPTH_COMPONENT32F, width, height, 1, GL_NEAREST));
    glBindTextureUnit(PYRAMID, pyramid_);
    glBindTextureUnit(DEPTH, scene_depth_);
    blur_environment(map);
  }

  // Linear radiance, RGBA, the lowest row first. offset, samples: see frame_of.
  std::vector<float> draw(glm::vec2 offset, int samples) {
    const FrameBlock frame =
        frame_of(scene_, environment_, width_, height_, offset, samples, last_, true);
    glNamedBufferSubData(blocks_[FRAME], 0, sizeof frame, &frame);
    draw_bodies();                     // 1. what is not glass, with its depth
    for (int k = 1; k <= last_; ++k) { // 2. its pyramid of Gaussians
      glTextureParameteri(pyramid_, GL_TEXTURE_BASE_LEVEL, k - 1);
      glTextureParameteri(pyramid_, GL_TEXTURE_MAX_LEVEL, k - 1);
      const PassBlock pass{
          glm::vec4(std::max(1, width_ >> (k - 1)), std::max(1, height_ >> (k - 1)), 0.0F, 0.0F),
          {}};
      run(halve_, levels_[k], {0, 0, std::max(1, width_ >> k), std::max(1, height_ >> k)}, pyramid_,
          pass);
    }
    glTextureParameteri(pyramid_, GL_TEXTURE_BASE_LEVEL, 0);
    glTextureParameteri(pyramid_, GL_TEXTURE_MAX_LEVEL, last_);
    draw_faces(); // 3. where rays leave the glass
    draw_glass(); // 4. glass, over what is not
    std::vector<float> texels(4U * width_ * height_);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, frame_);
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_FLOAT, texels.data());
    return texels;
  }

private:
  static Body body_of(const Mesh& mesh) {
    Body body{&mesh, 0, picture_texture(mesh.color, GL_SRGB8_ALPHA8),
              picture_texture(mesh.roughness, GL_RGBA8)};
    glCreateVertexArrays(1, &body.array);
    glVertexArrayVertexBuffer(body.array, 0, buffer_of(mesh.vertices), 0, sizeof(Vertex));
    glVertexArrayElementBuffer(body.array, buffer_of(mesh.indices));
    const GLuint offsets[] = {offsetof(Vertex, position), offsetof(Vertex, normal),
                              offsetof(Vertex, uv)};
    for (GLuint k = 0; k < 3; ++k) {
      glEnableVertexArrayAttrib(body.array, k);
      glVertexArrayAttribFormat(body.array, k, k == 2 ? 2 : 3, GL_FLOAT, GL_FALSE, offsets[k]);
      glVertexArrayAttribBinding(body.array, k, 0);
    }
    return body;
  }

  void run(GLuint program, GLuint target, std::array<int, 4> place, GLuint source,
           const PassBlock& block) {
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    glViewport(place[0], place[1], place[2], place[3]);
    glDisable(GL_DEPTH_TEST);
    glUseProgram(program);
    glNamedBufferSubData(blocks_[DRAW], 0, sizeof block, &block);
    glBindTextureUnit(COLOR, source);
    glBindVertexArray(nothing_);
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }

  void blur_environment(const Environment& map) {
    const GLuint sharp = program_of("fullscreen.vert", "environment_sharp.frag"),
                 blur = program_of("fullscreen.vert", "environment_blur.frag");
    const GLuint source = texture_of(GL_RGBA16F, map.width, map.height, 1, GL_LINEAR);
    glTextureParameteri(source, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTextureSubImage2D(source, 0, 0, 0, map.width, map.height, GL_RGBA, GL_FLOAT,
                        map.texels.data());
    GLuint atlas[2], target[2];
    for (int k = 0; k < 2; ++k) {
      atlas[k] = texture_of(GL_RGBA16F, environment_.width, environment_.height[k], 1, GL_LINEAR);
      target[k] = target_of(atlas[k], 0);
    }
    for (int k = 0; k < LEVELS; ++k) {
      const Level& one = environment_.level[k];
      run(k == 0 ? sharp : blur, target[k % 2], {0, one.row, one.size + 2, one.size + 2},
          k == 0 ? source : atlas[(k + 1) % 2], environment_.block(k));
    }
    glBindTextureUnit(EVEN, atlas[0]);
    glBindTextureUnit(ODD, atlas[1]);
  }

  void draw_meshes(GLuint program, bool glass) {
    glUseProgram(program);
    for (const Body& body : bodies_) {
      if (body.mesh->glass != glass) continue;
      glNamedBufferSubData(blocks_[DRAW], 0, sizeof(DrawBlock), &body.mesh->block);
      glBindTextureUnit(COLOR, body.color);
      glBindTextureUnit(ROUGHNESS, body.roughness);
      glBindVertexArray(body.array);
      glDrawElements(GL_TRIANGLES, GLsizei(body.mesh->indices.size()), GL_UNSIGNED_INT, nullptr);
    }
  }

  // What is not glass, the sky last: only where nothing stands before it.
  void draw_bodies() {
    glBindFramebuffer(GL_FRAMEBUFFER, levels_[0]);
    glViewport(0, 0, width_, height_);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glClear(GL_DEPTH_BUFFER_BIT);
    draw_meshes(body_, false);
    glUseProgram(sky_);
    glBindVertexArray(nothing_);
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }

  // Glass over what was drawn without it. Bodies are closed: what faces away is seen through their front.
  void draw_glass() {
    glBlitNamedFramebuffer(levels_[0], frame_, 0, 0, width_, height_, 0, 0, width_, height_,
                           GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, frame_);
    glViewport(0, 0, width_, height_);
    glEnable(GL_CULL_FACE);
    draw_meshes(glass_, true);
    glDisable(GL_CULL_FACE);
  }

  // The nearest back faces, the front faces behind those, the back faces behind these.
  void draw_faces() {
    glViewport(0, 0, width_, height_);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    glClearColor(0.0F, 0.0F, 0.0F, 0.0F);
    for (std::size_t k = 0; k < faces_.size(); ++k) {
      glBindFramebuffer(GL_FRAMEBUFFER, faces_[k].target);
      glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
      glCullFace(k == 1 ? GL_BACK : GL_FRONT);
      draw_meshes(faces_[k].program, true);
    }
    glCullFace(GL_BACK);
    glDisable(GL_CULL_FACE);
  }

  const Scene& scene_;
  const Levels environment_;
  const int width_, height_, last_;
  GLuint sky_, body_, glass_, halve_, nothing_, blocks_[2], scene_depth_, pyramid_, frame_;
  std::vector<FaceLayer> faces_;
  std::vector<GLuint> levels_;
  std::vector<Body> bodies_;
};

} // namespace

int main(int argc, char** argv) {
  const Asked asked = asked_of(argc, argv);
  open_device();
  const Scene scene = scene_of(asked.scene);
  Renderer renderer(scene, environment_of(asked.environment), asked.width, asked.height,
                    asked.pairs);
  const Averaged averaged = averaged_of(renderer, asked);
  if (glGetError() != GL_NO_ERROR) fail("OpenGL reports an error");
  stbi_flip_vertically_on_write(1);
  write(averaged, asked, reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
}
