// Debug views that are worked out on the host along lines of sight: where the lobe that passes a surface goes, and how often a
// pixel looks its surroundings up.
#pragma once

#include "needs/needs.h"
#include "scene/scene.h"
#include "viewer/debug_view.h"

#include <memory>

namespace gg::viewer {

class Sight {
public:
  // The scene must not change, nor its materials.
  explicit Sight(std::shared_ptr<const scene::Scene> scene);
  ~Sight();

  struct Seen {
    DebugKind kind; // of the last three
    scene::Camera camera;
    int width = 0, height = 0; // pixels
    bool coarse = false;       // in a tenth of the time
    int samples = 1;           // that are drawn of each pixel
  };
  // `needs` are of a frame of the scene: its method and, for the lookups, its draws. Of glass the lobe is that of the first
  // interface, followed along Snell's ray through at most four internal reflections.
  DebugView::Drawn draw(const Seen& seen, const needs::Needs& needs) const;

private:
  struct Tracer;
  std::unique_ptr<const Tracer> tracer_;
};

} // namespace gg::viewer
