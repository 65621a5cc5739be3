#include "needs/passes.h"

#include "needs/needs.h"

#include <algorithm>
#include <functional>

namespace gg::needs {
namespace {

class List {
public:
  explicit List(const Needs& needs) : needs_(needs) {}
  std::vector<Pass> passes;

  void add(Pass pass) { passes.push_back(std::move(pass)); }
  // What shaders of materials read besides targets.
  std::vector<std::string> uploads() const {
    std::vector<std::string> names;
    if (needs_.view.environment) names.emplace_back("environment");
    if (!needs_.tables.empty()) names.emplace_back("tables");
    if (!needs_.images.empty()) names.emplace_back("maps");
    return names;
  }
  std::vector<std::string> uploads_and(std::vector<std::string> names) const {
    const std::vector<std::string> uploaded = uploads();
    names.insert(names.end(), uploaded.begin(), uploaded.end());
    return names;
  }

  // The picture so far, and with `blurs` all that lookups in it take. Depth is that of opaque surfaces (rays pass flat glass, and
  // what they meet behind it shows its colour) until a layer has glass in it that makes images, or it is wanted `anew`.
  void add_backdrop(std::size_t layer, bool blurs, std::size_t foreground, bool anew = false) {
    const bool takes_depth =
        needs_.target("backdrop depth") && (!has_depth_ || anew || sees_images(layer));
    has_depth_ = has_depth_ || takes_depth;
    Pass backdrop{.kind = PassKind::backdrop,
                  .label = "backdrop",
                  .layer = layer,
                  .takes_depth = takes_depth,
                  .reads = {"scene color"},
                  .writes = {"screen pyramid 0"}};
    // Taken anew, the one holds the other.
    backdrop.glass_depth = has_glass_depth_ =
        !takes_depth && layer < needs_.layers.size() && needs_.layers[layer].interleaves;
    if (takes_depth || backdrop.glass_depth) {
      backdrop.reads.emplace_back("scene depth");
      backdrop.writes.emplace_back(takes_depth ? "backdrop depth" : "glass depth");
    }
    add(backdrop);
    if (!blurs) return;
    if (foreground > 0)
      add({.kind = PassKind::foreground,
           .label = "foreground",
           .layer = layer,
           .draws = foreground,
           .reads = {"scene depth"},
           .writes = {"screen pyramid 0"}});
    for (int level = 1; level < needs_.target("screen pyramid")->levels; ++level)
      add({.kind = PassKind::pyramid,
           .label = "pyramid",
           .layer = layer,
           .part = level,
           .reads = {"screen pyramid " + std::to_string(level - 1)},
           .writes = {"screen pyramid " + std::to_string(level)}});
  }

  // What is shaded by its pixels leaves its depth first, so that it hides what else there is, and the pixels where that does not
  // hide it are shaded last.
  void add_opaque() {
    const bool by_pixel = !needs_.opaque_regions.empty();
    if (by_pixel) {
      std::size_t draws = 0;
      for (const Region& region : needs_.opaque_regions)
        draws += region.draws.size();
      add({.kind = PassKind::geometry,
           .label = "geometry",
           .draws = draws,
           .writes = {"geometry", "scene depth"}});
    }
    add({.kind = PassKind::opaque,
         .label = "opaque",
         .draws =
             needs_.opaque.size() + (needs_.shades_opaque_late() ? 0 : needs_.over_opaque.size()),
         .reads = uploads(),
         .writes = {"scene color", "scene depth"}});
    if (!by_pixel) return;
    add_material_depth();
    add({.kind = PassKind::deferred,
         .label = "deferred",
         .draws = needs_.opaque_regions.size(),
         .reads = uploads_and({"geometry", "material depth"}),
         .writes = {"scene color"}});
  }

  // Over what is opaque, once all of that is there.
  void add_over_opaque() {
    if (needs_.over_opaque.empty() || !needs_.shades_opaque_late()) return;
    add({.kind = PassKind::over_opaque,
         .label = "blended",
         .draws = needs_.over_opaque.size(),
         .reads = uploads(),
         .writes = {"scene color"}});
  }

  void add_material_depth() {
    add({.kind = PassKind::material_depth,
         .label = "material depth",
         .reads = {"geometry", "scene depth"},
         .writes = {"material depth"}});
  }

  // With `glass` its colour and depth are part of the picture by now, and it hides what is behind it.
  void add_reflective(bool glass) {
    add_backdrop(0, true, 0, glass);
    if (glass && !needs_.reflective_regions.empty()) add_material_depth();
    const auto is_drawn = [glass](const Draw* draw) { return !glass || shows_glass(*draw); };
    const auto count = [&](const auto& list, auto draw_of) {
      return static_cast<std::size_t>(std::ranges::count_if(list, is_drawn, draw_of));
    };
    Pass pass{.kind = PassKind::reflective,
              .label = "reflective",
              .part = glass ? 1 : 0,
              .draws = count(needs_.reflective, std::identity{}),
              .reads = uploads_and({"screen pyramid", "backdrop depth"}),
              .writes = {"scene color"}};
    if (pass.draws > 0) add(pass);
    pass.kind = PassKind::deferred_reflective;
    pass.draws = count(needs_.reflective_regions,
                       [](const Region* region) { return region->draws.front(); });
    pass.reads.insert(pass.reads.begin(), {"geometry", "material depth"});
    if (pass.draws > 0) add(pass);
  }

  void add_interior(std::size_t l) {
    static constexpr const char* faces[] = {"F1", "B1", "F2", "B2"};
    const Layer& layer = needs_.layers[l];
    for (int part = 0; part < 2 * layer.interior_pairs; ++part) {
      Pass pass{.kind = PassKind::interior,
                .label = std::string("interior ") + faces[part],
                .layer = l,
                .part = part,
                .writes = {std::string("interior ") + faces[part], "interior depth"}};
      for (const Draw* solid : layer.solids)
        if (part < 2 * value_of(solid->key, Feature::interior_pairs)) ++pass.draws;
      if (part > 1) pass.reads.emplace_back(std::string("interior ") + faces[part - 2]);
      if (!needs_.images.empty()) pass.reads.emplace_back("maps");
      add(pass);
    }
  }

  void add_layer(std::size_t l) {
    const Layer& layer = needs_.layers[l];
    Pass pass{.kind = PassKind::layer,
              .label = layer.shows_behind() ? "refractive" : "blended",
              .layer = l,
              .draws = layer.refractive.size() + layer.regions.size() + layer.blended.size(),
              .writes = {"scene color", "scene depth"}};
    if (layer.shows_behind()) pass.reads.emplace_back("screen pyramid");
    if (layer.blurs) pass.reads.emplace_back("backdrop depth");
    pass.glass_depth = layer.shows_behind() && has_glass_depth_;
    if (pass.glass_depth) pass.reads.emplace_back("glass depth");
    if (!layer.solids.empty()) pass.reads.emplace_back("interior");
    pass.reads = uploads_and(pass.reads);
    add(pass);
  }

private:
  // Whether glass that makes images is drawn before the layer, and none of it touches what is in the layer: of two bodies in
  // contact the one is no picture that the other sees.
  bool sees_images(std::size_t layer) const {
    bool any = false;
    for (std::size_t before = 0; before < std::min(layer, needs_.layers.size()); ++before)
      for (const Draw* image : needs_.layers[before].solids) {
        if (!image->images) continue;
        any = true;
        for (const Draw* solid : needs_.layers[layer].solids)
          if (touches(image->bounds, solid->bounds)) return false;
      }
    return any;
  }

  // They overlap, and the first does not lie within the second.
  static bool touches(const scene::Bounds& a, const scene::Bounds& b) {
    const bool overlap =
        glm::all(glm::lessThan(a.low, b.high)) && glm::all(glm::lessThan(b.low, a.high));
    const bool within =
        glm::all(glm::greaterThan(a.low, b.low)) && glm::all(glm::lessThan(a.high, b.high));
    return overlap && !within;
  }

  const Needs& needs_;
  bool has_depth_ = false;
  bool has_glass_depth_ = false; // of the last backdrop
};

} // namespace

std::vector<Pass> passes_of(const Needs& needs) {
  List list(needs);
  list.add_opaque();
  if (needs.reflects()) list.add_reflective(false);
  list.add_over_opaque();
  for (std::size_t l = 0; l < needs.layers.size(); ++l) {
    const Layer& layer = needs.layers[l];
    if (layer.shows_behind()) list.add_backdrop(l, layer.blurs, layer.foreground.size());
    list.add_interior(l);
    list.add_layer(l);
  }
  if (needs.reflects_glass()) list.add_reflective(true);
  if (needs.view.samples > 1)
    list.add({.kind = PassKind::accumulate,
              .label = "accumulate",
              .reads = {"scene color"},
              .writes = {"average"}});
  return std::move(list.passes);
}

} // namespace gg::needs
