// The picture on the device: drawn sample by sample, at full size when nothing moves and at a part of it while something does.
#pragma once

#include "environment/stack.h"
#include "frame/renderer.h"
#include "gpu/device.h"
#include "image/image.h"
#include "needs/shapes.h"
#include "scene/coarse.h"
#include "scene/origin.h"
#include "scene/scene.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gg::viewer {

class Picture {
public:
  explicit Picture(gpu::Device& device) : device_(device) {}

  // Of a scene a copy is drawn, whose origin is where the camera is. What takes long for a large one is done here: on any thread,
  // for frames like `desc`, with an environment or without.
  struct Drawn;
  static std::shared_ptr<Drawn> prepare(const scene::Scene& scene, const frame::FrameDesc& desc,
                                        bool is_lit);
  // Replaces what is drawn by what was prepared of this scene. Nothing is drawn before set(). `coarse` is used in motion.
  void open(std::shared_ptr<const scene::Scene> scene, std::shared_ptr<Drawn> drawn,
            std::shared_ptr<const scene::CoarseLists> coarse);
  void open_as(const Picture& other); // the same copy: both have one camera
  // The same scene at another time of its animation.
  void pose(std::shared_ptr<const scene::Scene> scene);
  void light(std::shared_ptr<const environment::Stack> stack); // another environment; null: none
  void light_as(const Picture& other);             // the same cubes, and its rotation and intensity
  void set_light(float rotation, float intensity); // radians; of the environment
  // Starts again with this camera, size, method and number of samples, and the scene's materials as they are by now; `desc`'s
  // environment is the picture's own. `exact`: as capture draws it, to the bit; otherwise the origin stays where it was, and what
  // is worked out for the whole scene with it, and meshes have the triangles that the size shows.
  void set(frame::FrameDesc desc, bool exact);

  // Shaders have changed: the next set() compiles what it draws with.
  void forget_pipelines() {
    pass_ = 0; // what is being drawn is given up
    if (renderer_) renderer_->forget_pipelines();
  }

  bool is_open() const { return renderer_ != nullptr; }
  int drawn() const { return drawn_; }
  bool done() const { return renderer_ && drawn_ >= desc_.samples; }
  void draw_sample(std::map<std::string, double>* times = nullptr); // the rest of it
  void draw_pass(std::map<std::string, double>* times = nullptr);   // the next one of a sample
  bool amid_sample() const { return pass_ > 0; }
  // What texture() holds is being drawn over.
  bool hides_texture() const {
    return amid_sample() && texture_ && texture_ == renderer_->picture();
  }

  // Frames that nobody sees, so that one like them finds made what it is drawn with. While one is set nothing else is drawn or read;
  // then the picture is set again, with what has been drawn of it. `materials`: in place of the scene's.
  using Materials = std::vector<scene::Material>;
  std::vector<gpu::PipelineDesc> missing(frame::FrameDesc desc, const Materials* materials);
  void make(const gpu::PipelineDesc& pipeline) { renderer_->make(pipeline); }
  void set_unseen(frame::FrameDesc desc, const Materials* materials);
  std::size_t unseen_passes() const { return renderer_->pass_count(0); }
  void draw_unseen(std::size_t pass) { renderer_->draw_pass(0, pass); }
  void set_seen();

  const frame::FrameDesc& desc() const { return desc_; }
  // What is to be shown: of the last finished sample, which may be of a set() before; null: there is none yet.
  const gpu::TextureRef& texture() const { return texture_; } // some part of the radiance:
  float factor() const { return factor_; }                    // this makes it radiance
  image::Image read();                                        // finished, as capture writes it
  const frame::Renderer& renderer() const { return *renderer_; }

private:
  void place(frame::FrameDesc& desc) const; // as seen from the drawn scene's origin
  void put(const Materials& materials);     // where renderers know them

  gpu::Device& device_;
  std::shared_ptr<const scene::Scene> scene_;
  std::shared_ptr<Drawn> drawn_scene_;
  std::shared_ptr<const scene::CoarseLists> coarse_;
  bool exact_ = true;                                             // of the last set()
  std::shared_ptr<const environment::Stack> stack_, drawn_stack_; // of the last set()
  float rotation_ = 0.0f, intensity_ = 1.0f;
  frame::FrameDesc desc_;
  std::unique_ptr<frame::Renderer> renderer_;
  int drawn_ = 0;
  std::size_t pass_ = 0; // of the sample that is being drawn
  gpu::TextureRef texture_;
  float factor_ = 1.0f;
};

struct Picture::Drawn {
  explicit Drawn(const scene::Scene& of) : scene(of) { origin.emplace(scene); }
  scene::Scene scene;
  std::optional<scene::Origin> origin;
  glm::vec3 at{0.0f}; // where its origin is
  std::optional<needs::Shapes>
      shapes; // of the scene with this origin and the file's materials, until the renderer has them
};

} // namespace gg::viewer
