// A frame graph on a device: its textures and recorded passes.
#pragma once

#include "frame/context.h"
#include "frame/graph.h"
#include "gpu/device.h"

#include <functional>
#include <vector>

namespace gg::frame {

class Execution {
public:
  explicit Execution(gpu::Device& device);

  // What all passes share: binds it for a sample, and the textures among it that a device has drawn into.
  struct Shared {
    std::function<void(gpu::Encoder&, int sample)> bind;
    std::vector<gpu::View> reads;
  };
  // Textures of earlier graphs are kept where they fit, and for graphs to come: what is seen, and with it what is drawn, changes
  // with every turn of a camera, and a viewer's picture has another size while something moves. Those of sizes that were used
  // longest ago are let go once all sizes together have twice the pixels of the largest. All arguments must outlive the passes.
  void set(const Graph& graph, Context& context, Shared shared);

  // Of the i-th sample of a frame.
  std::vector<gpu::Pass> passes(int sample) const;
  const gpu::TextureRef& texture(const std::string& target) const; // which the graph has

private:
  std::vector<gpu::TextureRef>& spare_of(int width, int height);
  gpu::View view(const Part& part) const;
  gpu::View one(const Part& part) const; // one level and layer
  gpu::Pass pass(std::size_t i, int sample) const;

  gpu::Device& device_;
  gpu::SamplerRef nearest_, linear_;
  const Graph* graph_ = nullptr;
  Shared shared_;
  struct OfSize { // of the picture that they are for
    int width = 0, height = 0;
    std::vector<gpu::TextureRef> textures;
  };
  std::vector<OfSize> spare_; // the size of the last graph first
  std::vector<gpu::TextureRef> textures_;
  std::vector<std::size_t> texture_of_; // by target
  std::vector<Record> records_;         // by pass
};

} // namespace gg::frame
