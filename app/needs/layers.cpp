#include "needs/layers.h"

#include "needs/outline.h"

#include <algorithm>
#include <optional>

namespace gg::needs {
namespace {

// What must be in one layer.
struct Item {
  std::vector<LayerDraw> draws;
  ScreenBox box;
  bool blended = false;
  std::optional<Outline> outline; // once it is asked for
};

bool same_solid(const Draw& a, const Draw& b) {
  return a.instance_index == b.instance_index && a.body == b.body;
}

std::vector<Item> items_of(const std::vector<Draw>& draws, const glm::dmat4& clip_from_world) {
  std::vector<Item> items;
  for (const Draw& draw : draws) {
    if (draw.role == Role::opaque || draw.bounds.empty()) continue;
    const ScreenBox box = screen_box(draw.bounds, clip_from_world);
    const bool solid = draw.is_solid();
    if (solid) {
      const auto found = std::ranges::find_if(items, [&](const Item& item) {
        return same_solid(*item.draws.front().draw, draw) && !item.blended;
      });
      if (found != items.end()) {
        found->draws.push_back({&draw, Faces::as_material});
        grow(found->box, box);
        continue;
      }
    }
    const bool two_sides =
        draw.role == Role::refractive && !solid && draw.both_sides && !draw.planar;
    Item item{
        {{&draw, two_sides ? Faces::back : Faces::as_material}}, box, draw.role == Role::blended};
    items.push_back(item);
    if (two_sides) {
      item.draws.front().faces = Faces::front;
      items.push_back(item);
    }
  }
  return items;
}

// The blur of what is seen through glass reaches beyond its outline, by as much as its own size at most times.
bool stands_before(const ScreenBox& thing, const ScreenBox& glass) {
  ScreenBox around = glass;
  const glm::dvec2 size = glass.high - glass.low;
  around.low -= size;
  around.high += size;
  return thing.farthest_depth > glass.nearest_depth && thing.overlaps(around);
}

} // namespace

bool ScreenBox::overlaps(const ScreenBox& other) const {
  return low.x < other.high.x && other.low.x < high.x && low.y < other.high.y
         && other.low.y < high.y;
}

ScreenBox screen_box(const scene::Bounds& bounds, const glm::dmat4& clip_from_world) {
  ScreenBox box{glm::dvec2(1.0), glm::dvec2(-1.0), 0.0, 1.0};
  for (unsigned corner = 0; corner < 8; ++corner) {
    const glm::dvec4 clip = clip_from_world
                            * glm::dvec4(corner & 1u ? bounds.high.x : bounds.low.x,
                                         corner & 2u ? bounds.high.y : bounds.low.y,
                                         corner & 4u ? bounds.high.z : bounds.low.z, 1.0);
    if (!(clip.w > 0.0) || clip.z > clip.w) return {}; // nearer than the near plane
    const glm::dvec2 at = glm::dvec2(clip) / clip.w;
    box.low = glm::min(box.low, at);
    box.high = glm::max(box.high, at);
    box.nearest_depth = std::max(box.nearest_depth, clip.z / clip.w);
    box.farthest_depth = std::min(box.farthest_depth, clip.z / clip.w);
  }
  return box;
}

void grow(ScreenBox& box, const ScreenBox& other) {
  box.low = glm::min(box.low, other.low);
  box.high = glm::max(box.high, other.high);
  box.nearest_depth = std::max(box.nearest_depth, other.nearest_depth);
  box.farthest_depth = std::min(box.farthest_depth, other.farthest_depth);
}

std::vector<Layer> layers_of(const scene::Scene& scene, const Draws& all,
                             const glm::dmat4& clip_from_world, std::size_t most) {
  const std::vector<Draw>& draws = all.all;
  std::vector<Item> items = items_of(draws, clip_from_world);
  const auto outline = [&](Item& item) -> const Outline& {
    if (item.outline) return *item.outline;
    item.outline.emplace();
    for (const LayerDraw& part : item.draws)
      item.outline->include(outline_of(scene, *part.draw, *all.instances[part.draw->instance_index],
                                       clip_from_world));
    return *item.outline;
  };
  // By the nearest point: what is inside of something is farther than its hull.
  std::ranges::stable_sort(items, std::less{},
                           [](const Item& item) { return item.box.nearest_depth; });
  std::vector<std::size_t> at(items.size(), 0);
  std::vector<Layer> layers;
  for (std::size_t i = 0; i < items.size(); ++i) {
    bool interleaves = false;
    for (std::size_t j = 0; j < i; ++j) {
      if (!items[i].box.overlaps(items[j].box) || !outline(items[i]).overlaps(outline(items[j])))
        continue;
      // Blended surfaces need no picture of what is behind them: they lie over it in order.
      at[i] = std::max(at[i], at[j] + (items[i].blended ? 0 : 1));
      if (!items[j].blended && items[j].box.nearest_depth > items[i].box.farthest_depth)
        interleaves = true;
    }
    at[i] = std::min(at[i], most - 1);
    layers.resize(std::max(layers.size(), at[i] + 1));
    Layer& layer = layers[at[i]];
    if (std::ranges::all_of(items[i].draws, [](const LayerDraw& d) { return d.draw->by_pixel; })) {
      layer.interleaves = layer.interleaves || interleaves;
      Region& region = layer.regions.emplace_back(Region{{}, items[i].box});
      for (const LayerDraw& part : items[i].draws)
        region.draws.push_back(part.draw);
    } else {
      std::vector<LayerDraw>& list = items[i].blended ? layer.blended : layer.refractive;
      list.insert(list.end(), items[i].draws.begin(), items[i].draws.end());
    }
    if (items[i].blended) continue;
    for (const LayerDraw& part : items[i].draws) {
      const int pairs = value_of(part.draw->key, Feature::interior_pairs);
      if (pairs > 0) layer.solids.push_back(part.draw);
      layer.interior_pairs = std::max(layer.interior_pairs, pairs);
      layer.blurs = layer.blurs || !part.draw->is_straight();
    }
    for (const Draw& draw : draws)
      if (draw.role == Role::opaque
          && stands_before(screen_box(draw.bounds, clip_from_world), items[i].box)
          && std::ranges::find(layer.foreground, &draw) == layer.foreground.end())
        layer.foreground.push_back(&draw);
  }
  return layers;
}

} // namespace gg::needs
