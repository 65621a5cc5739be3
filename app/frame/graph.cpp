#include "frame/graph.h"

#include <algorithm>

namespace gg::frame {
namespace {

// Places in the list of passes, both counted in.
struct Life {
  std::size_t from = std::numeric_limits<std::size_t>::max(), to = 0;
  void include(std::size_t pass) {
    from = std::min(from, pass);
    to = std::max(to, pass);
  }
  bool overlaps(const Life& other) const { return from <= other.to && other.from <= to; }
};

std::vector<Life> lives_of(const Graph& graph) {
  std::vector<Life> lives(graph.targets.size());
  for (std::size_t p = 0; p < graph.passes.size(); ++p) {
    const Pass& pass = graph.passes[p];
    for (const Input& input : pass.reads)
      lives[input.part.target].include(p);
    for (const ColorOutput& color : pass.colors)
      lives[color.part.target].include(p);
    if (pass.depth) lives[pass.depth->target].include(p);
  }
  for (std::size_t t = 0; t < lives.size(); ++t)
    if (graph.targets[t].is_result) lives[t] = {0, graph.passes.size()};
  return lives;
}

bool can_share(const Target& a, const Target& b) {
  return a.format == b.format && a.width == b.width && a.height == b.height && a.layers == b.layers
         && a.levels == b.levels && a.array == b.array && !a.is_result && !b.is_result;
}

} // namespace

std::size_t bytes_of(const Target& t) {
  std::size_t texels = 0;
  for (int level = 0; level < t.levels; ++level)
    texels += static_cast<std::size_t>(std::max(t.width >> level, 1))
              * static_cast<std::size_t>(std::max(t.height >> level, 1));
  return texels * static_cast<std::size_t>(t.layers) * gpu::bytes_per_texel(t.format);
}

std::size_t Graph::target(Target desc) {
  const auto found = std::ranges::find(targets, desc.name, &Target::name);
  if (found != targets.end()) return static_cast<std::size_t>(found - targets.begin());
  if (desc.width == 0) {
    desc.width = width;
    desc.height = height;
  }
  targets.push_back(std::move(desc));
  return targets.size() - 1;
}

const Target* Graph::find(const std::string& name) const {
  const auto found = std::ranges::find(targets, name, &Target::name);
  return found == targets.end() ? nullptr : &*found;
}

bool Graph::is_written(std::size_t target) const {
  return std::ranges::any_of(passes, [&](const Pass& pass) {
    return (pass.depth && pass.depth->target == target)
           || std::ranges::any_of(
               pass.colors, [&](const ColorOutput& color) { return color.part.target == target; });
  });
}

std::string name_of(const Graph& graph, const Part& part) {
  const Target& target = graph.targets[part.target];
  std::string name = target.name;
  if (target.levels > 1 && part.level != Part::all) name += " " + std::to_string(part.level);
  if (target.array && part.layer != Part::all) name += " " + std::to_string(part.layer);
  return name;
}

Allocation allocate(const Graph& graph) {
  const std::vector<Life> lives = lives_of(graph);
  Allocation allocation;
  std::vector<std::vector<std::size_t>> tenants; // by texture
  for (std::size_t t = 0; t < graph.targets.size(); ++t) {
    const auto fits = [&](const std::vector<std::size_t>& others) {
      return std::ranges::all_of(others, [&](std::size_t other) {
        return can_share(graph.targets[t], graph.targets[other])
               && !lives[t].overlaps(lives[other]);
      });
    };
    auto found = std::ranges::find_if(tenants, fits);
    if (found == tenants.end()) {
      found = tenants.insert(found, std::vector<std::size_t>{});
      allocation.first.push_back(t);
      allocation.bytes += bytes_of(graph.targets[t]);
    }
    found->push_back(t);
    allocation.texture_of.push_back(static_cast<std::size_t>(found - tenants.begin()));
  }
  return allocation;
}

} // namespace gg::frame
