// The picture on the device: drawn sample by sample, at full size when nothing moves and at a part of it while something does.
#pragma once

#include "environment/map.h"
#include "environment/stack.h"
#include "frame/renderer.h"
#include "gpu/device.h"
#include "image/image.h"
#include "scene/scene.h"

#include <map>
#include <memory>
#include <string>

namespace gg::viewer {

class Picture {
public:
  explicit Picture(gpu::Device& device) : device_(device) {}

  // Replaces what is drawn; the map may be null. Nothing is drawn before set(). Throws Error.
  void open(std::shared_ptr<const scene::Scene> scene);
  void light(const environment::Map* map);         // another environment
  void light_as(const Picture& other);             // the same cubes, and its rotation and intensity
  void set_light(float rotation, float intensity); // radians; of the environment
  // Starts again with this camera, size, method and number of samples, and the scene's materials as they are by now; `desc`'s
  // environment is the picture's own.
  void set(frame::FrameDesc desc);

  bool is_open() const { return renderer_ != nullptr; }
  int drawn() const { return drawn_; }
  bool done() const { return renderer_ && drawn_ >= desc_.samples; }
  void draw_sample(std::map<std::string, double>* times = nullptr);

  const frame::FrameDesc& desc() const { return desc_; }
  const gpu::TextureRef& texture() const {
    return renderer_->picture();
  }                     // drawn() / samples of the radiance
  float factor() const; // that makes it radiance
  image::Image read();  // finished, as capture writes it
  const frame::Renderer& renderer() const { return *renderer_; }

private:
  void restart();

  gpu::Device& device_;
  std::shared_ptr<const scene::Scene> scene_;
  std::shared_ptr<const environment::Stack> stack_;
  float rotation_ = 0.0f, intensity_ = 1.0f;
  frame::FrameDesc desc_;
  std::unique_ptr<frame::Renderer> renderer_;
  int drawn_ = 0;
};

} // namespace gg::viewer
