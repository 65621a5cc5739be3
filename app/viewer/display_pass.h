// From the picture's radiance to what the window shows.
#pragma once

#include "frame/display.h"
#include "gpu/device.h"
#include "image/image.h"
#include "scene/scene.h"

#include <glm/glm.hpp>

#include <array>
#include <compare>
#include <map>
#include <optional>

namespace gg::viewer {

// A second picture over the first.
struct Beside {
  gpu::TextureRef texture; // as large as the picture
  float factor = 1.0f;     // on its values
  bool encoded = false;    // for display already: a map of colours
  float from =
      1.0f; // where it begins, as a part of the width: 0 it covers the first, 1 it is not seen
  bool side_by_side = false; // each gets half of the width, cut from its middle
};

class DisplayPass {
public:
  explicit DisplayPass(gpu::Device& device);

  struct Show {
    int width = 0, height = 0; // of the window
    int picture_width = 0,
        picture_height = 0;   // of the part of it, at the top left, that the picture fills
    gpu::TextureRef picture;  // of any size
    bool being_drawn = false; // it is: what was shown last of a picture of its size is shown again
    float factor = 1.0f;      // on its values, the exposure's included
    frame::ToneMap tone_map = frame::ToneMap::neutral;
    std::optional<Beside> beside;
  };
  // RGBA8, as large as the window.
  const gpu::TextureRef& draw(const Show& show);

  // What is outlined from now on: an instance; none clears it.
  void pick(const scene::Scene& scene, scene::Index instance);
  // Draws its outline as the camera sees it, `outline` pixels wide in a picture of this size; in motion at half of that. Nothing is
  // drawn where it would be the same.
  void see(const scene::Camera& camera, int width, int height, float outline, bool moving);

private:
  struct Kind { // of what a pipeline draws
    frame::ToneMap tone_map = frame::ToneMap::none;
    bool beside = false, outlined = false;
    bool encoded = false; // the picture is already
    auto operator<=>(const Kind&) const = default;
  };
  const gpu::PipelineRef& pipeline(const Kind& kind);
  static bool is_small(const Show& show);
  gpu::TextureRef encoded_small(const Show& show);
  void draw_into(const gpu::TextureRef& target, const Show& show, const Kind& kind,
                 const gpu::BufferRef& block);

  gpu::Device& device_;
  gpu::SamplerRef linear_;
  std::map<Kind, gpu::PipelineRef> display_;
  gpu::PipelineRef mask_pipeline_, outline_pipeline_;
  gpu::BufferRef block_, small_block_, picked_block_, outline_block_;
  gpu::TextureRef target_, small_, nothing_;
  struct Outlined {
    gpu::TextureRef mask, outline;
    glm::mat4 clip_from_mesh{0.0f}; // that they were drawn by
  };
  std::array<Outlined, 2> outlined_; // at rest, in motion
  gpu::TextureRef outline_;          // of what was seen last; null: there is none
  struct Part {
    gpu::BufferRef positions, indices;
    std::uint32_t count = 0;
  };
  std::vector<Part> picked_;
  glm::mat4 world_{1.0f};
};

// A picture for the device: RGBA32F of its first three channels.
gpu::TextureRef upload(gpu::Device& device, const image::Image& image, const char* label);

} // namespace gg::viewer
