// Deferred shading of solids of glass. One pass finds where light comes to a face from inside, the next follow it from there and look
// it up (shaders/stages/glass_arrival.glsl, glass_lobes.glsl): one shader for all would need so many registers that few threads run at
// once, and pixels in lockstep would pay for each other's branches.
// All passes run first for one pixel in 4 x 4. Where adjacent fragments agree their values are interpolated and looked up at every
// pixel (glass_resolve.frag); the other pixels are shaded one by one.
#include "frame/passes/alike.h"
#include "frame/passes/passes.h"
#include "frame/regions.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace gg::frame {
namespace {

constexpr std::uint32_t apart = 55; // constant of stages/glass_cells.glsl

// Regions of the layer that take these passes.
struct Solid {
  const needs::Region* region;
  std::size_t index; // among the layer's
};

bool is_split(const needs::Draw& draw) {
  const auto method = static_cast<needs::Method>(value_of(draw.key, needs::Feature::method));
  return needs::lobes_of(method) > 0 && value_of(draw.key, needs::Feature::dispersion) == 0
         && draw.material->alpha_mode == scene::AlphaMode::opaque
         && draw.material->transmission == 1.0f && draw.material->metallic <= 0.0f;
}

std::vector<Solid> solids_of(const needs::Needs& needs, std::size_t l) {
  std::vector<Solid> solids;
  const std::vector<needs::Region>& regions = needs.layers[l].regions;
  for (std::size_t r = 0; r < regions.size(); ++r)
    if (is_split(*regions[r].draws.front())) solids.push_back({&regions[r], r});
  return solids;
}

// Their front faces into the depth, where they hide what is behind them.
void declare_front_faces(Graph& graph, const needs::Needs& needs, std::size_t l) {
  Pass pass{.label = "glass depth",
            .shades = true,
            .colors = {{.part = {scene_color(graph)}}},
            .depth = DepthOutput{scene_depth(graph)}};
  for (const Solid& solid : solids_of(needs, l))
    pass.draws += solid.region->draws.size();
  pass.prepare = [l](Context& context) -> Record {
    const DrawPass hides = hiding_pass("hides");
    Records records;
    for (const Solid& solid : solids_of(context.needs, l))
      for (const needs::Draw* part : solid.region->draws)
        records.push_back(context.draws.recorded(hides, {part, needs::Faces::front}));
    return [&context, records](gpu::Encoder& encoder) { context.draws.record(encoder, records); };
  };
  graph.passes.push_back(std::move(pass));
}

// A pass over the regions that reads no material.
void declare_regions(Graph& graph, std::size_t l, int step, gpu::PipelineDesc desc, Pass pass) {
  pass.label = desc.label;
  desc.vertex = "region.vert";
  for (const ColorOutput& color : pass.colors)
    desc.colors.push_back(graph.targets[color.part.target].format);
  desc.depth = depth_format;
  pass.prepare = [l, step, desc](Context& context) -> Record {
    gpu::PipelineRef pipeline = context.draws.pipeline(desc);
    std::vector<std::size_t> blocks;
    for (const Solid& solid : solids_of(context.needs, l))
      blocks.push_back(layer_region(context.needs, l, solid.index, step > 1));
    return [&context, pipeline, blocks](gpu::Encoder& encoder) {
      encoder.use(pipeline);
      for (const std::size_t block : blocks) {
        bind_region(encoder, context.regions, block);
        encoder.draw(6);
      }
    };
  };
  graph.passes.push_back(std::move(pass));
}

// One rate at which the passes over the solids of a layer run.
struct Rate {
  int step;          // pixels per side for each fragment
  const char* name;  // of its targets
  DepthOutput depth; // passes run where this is nearer than the far end of the solid
};

class Stages {
public:
  Stages(Graph& graph, std::size_t layer, std::size_t draws, const Rate& rate,
         const SceneCopy& scene_copy, const Input& interior, bool holds_opaque)
      : graph_(graph), layer_(layer), draws_(draws), rate_(rate), looks_(scene_copy.inputs()) {
    looks_.push_back(interior);
    if (holds_opaque) within_ = target("endWithin");
  }

  // Where light comes to a face, and by which lobes it leaves.
  void declare_lobes() {
    add("glass exit", "glass_exit_region.frag", {}, {first_point_, first_face_}, gpu::Blend::none,
        rate_.depth);
    declare_regions(graph_, layer_, rate_.step,
                    {.label = "glass reflection mask",
                     .fragment = "glass_goes_on.frag",
                     .depth_compare = gpu::Compare::always},
                    {.reads = {first_point_}, .depth = DepthOutput{goes_on_, 0.0f}});
    add("glass reflections", "glass_reflections_region.frag", inputs({first_point_, first_face_}),
        {last_point_, last_face_, last_ray_, last_way_}, gpu::Blend::none, DepthOutput{goes_on_});
    if (within_)
      add("glass within", "glass_within_region.frag", {first_point_}, {*within_}, gpu::Blend::none,
          rate_.depth);
    add("glass transmission", "glass_transmission_region.frag", inputs({first_point_, first_face_}),
        {core_origin_, core_shape_, rest_origin_, rest_shape_, weight_}, gpu::Blend::none,
        rate_.depth);
  }
  // Their radiance, over what is in `color`.
  void declare_look(Part color) {
    add("glass look", "glass_look_region.frag", lobes(), {{"", color}}, gpu::Blend::over,
        rate_.depth);
  }
  void declare_footprint(const std::vector<Input>& targets) {
    add("glass footprint", "glass_footprint_region.frag", lobes(), targets, gpu::Blend::none,
        rate_.depth);
  }
  // All other light, added to it.
  void declare_rest(Part color) {
    const auto add_light = [&](const char* label, const char* fragment, std::vector<Input> reads,
                               const DepthOutput& depth) {
      add(label, fragment, inputs(std::move(reads)), {{"", color}}, gpu::Blend::add, depth);
    };
    add_light("glass internal reflection", "glass_reflected_inside_region.frag",
              {last_point_, last_face_, last_ray_, last_way_}, DepthOutput{goes_on_});
    add_light("glass reflection", "glass_reflection_region.frag", {weight_}, rate_.depth);
    add_light("glass residual", "glass_residual_region.frag",
              {first_point_, first_face_, last_point_, last_face_, last_ray_, last_way_, weight_},
              rate_.depth);
  }

  Input target(const char* name) {
    return {name,
            {graph_.target({.name = std::string("glass ") + rate_.name + ' ' + name,
                            .format = gpu::Format::rgba32f,
                            .width = scaled(graph_.width),
                            .height = scaled(graph_.height)})}};
  }

private:
  int scaled(int pixels) const { return (pixels + rate_.step - 1) / rate_.step; }
  std::vector<Input> inputs(std::vector<Input> list) const {
    if (within_) list.push_back(*within_);
    return list;
  }
  std::vector<Input> lobes() const {
    return inputs({core_origin_, core_shape_, rest_origin_, rest_shape_, weight_});
  }

  void add(const char* label, const char* fragment, std::vector<Input> reads,
           const std::vector<Input>& targets, gpu::Blend blend, const DepthOutput& depth) {
    Pass pass{
        .label = label, .draws = draws_, .shades = true, .reads = std::move(reads), .depth = depth};
    pass.reads.insert(pass.reads.end(), looks_.begin(), looks_.end());
    for (const Input& target : targets) {
      ColorOutput output{.part = target.part};
      if (blend == gpu::Blend::none) output.clear = {{0, 0, 0, 0}};
      pass.colors.push_back(output);
    }
    pass.prepare = [l = layer_, step = rate_.step, label, fragment, blend,
                    colors = targets.size()](Context& context) -> Record {
      const DrawPass draw_pass{.label = label,
                               .by_region = true,
                               .fragment = fragment,
                               .colors = std::vector(colors, gpu::Format::rgba32f),
                               .depth_write = false,
                               .depth_compare = gpu::Compare::less,
                               .blend = blend,
                               .constants = glass_constants(context.needs)};
      std::vector<RecordedRegion> regions;
      for (const Solid& solid : solids_of(context.needs, l)) {
        const needs::Draw* draw = solid.region->draws.front();
        regions.push_back({draw, context.draws.pipeline(draw_pass, *draw),
                           layer_region(context.needs, l, solid.index, step > 1)});
      }
      return [&context, regions](gpu::Encoder& encoder) {
        for (const RecordedRegion& region : regions)
          context.draws.shade(encoder, region, context.regions);
      };
    };
    graph_.passes.push_back(std::move(pass));
  }

  Graph& graph_;
  std::size_t layer_, draws_;
  Rate rate_;
  std::vector<Input> looks_;
  const Input first_point_ = target("firstPoint"), first_face_ = target("firstFace"),
              last_point_ = target("lastPoint"), last_face_ = target("lastFace"),
              last_ray_ = target("lastRay"), last_way_ = target("lastWay"),
              core_origin_ = target("coreOrigin"), core_shape_ = target("coreShape"),
              rest_origin_ = target("restOrigin"), rest_shape_ = target("restShape"),
              weight_ = target("lobeWeight");
  // Depth 1 where light goes on by total reflection.
  const std::size_t goes_on_ =
      graph_.target({.name = std::string("glass ") + rate_.name + " reflection mask",
                     .format = depth_format,
                     .width = scaled(graph_.width),
                     .height = scaled(graph_.height)});
  std::optional<Input> within_; // where something opaque ends the light inside
};

} // namespace

bool is_split(const needs::Region& region) {
  return is_split(*region.draws.front());
}

void declare_glass(Graph& graph, const needs::Needs& needs, std::size_t l,
                   const SceneCopy& scene_copy, const Input& interior) {
  const std::vector<Solid> solids = solids_of(needs, l);
  const std::size_t draws = solids.size();
  const bool holds = std::ranges::any_of(solids, [](const Solid& solid) {
    return value_of(solid.region->draws.front()->key, needs::Feature::holds_opaque) != 0;
  });
  declare_front_faces(graph, needs, l);
  const std::size_t marks = graph.target({.name = "glass rate", .format = depth_format});
  const std::size_t everywhere =
      graph.target({.name = "glass everywhere",
                    .format = depth_format,
                    .width = (graph.width + glass_step - 1) / glass_step,
                    .height = (graph.height + glass_step - 1) / glass_step});
  Stages low(graph, l, draws, {glass_step, "low", {everywhere, 1.0f}}, scene_copy, interior, holds);
  const std::vector<Input> footprints{low.target("glassOffsets"), low.target("glassSpots"),
                                      low.target("glassLobes"), low.target("glassFar")};
  low.declare_lobes();
  low.declare_footprint(footprints);
  low.declare_rest(footprints.back().part);

  const Input cells{"glassCells",
                    {graph.target({.name = "glass cells",
                                   .format = gpu::Format::rgba32f,
                                   .width = graph.width / glass_step + 1,
                                   .height = graph.height / glass_step + 1})}};
  std::vector<Input> agree = footprints;
  agree.push_back(interior);
  const std::size_t everywhere_cells = graph.target({.name = "glass cells everywhere",
                                                     .format = depth_format,
                                                     .width = graph.width / glass_step + 1,
                                                     .height = graph.height / glass_step + 1});
  declare_regions(graph, l, glass_step,
                  {.label = "glass cells",
                   .fragment = "glass_cells.frag",
                   .constants = {gpu::constant(apart, glass_step)},
                   .depth_write = false,
                   .depth_compare = gpu::Compare::less},
                  {.reads = agree,
                   .colors = {{.part = cells.part, .clear = {{0, 0, 0, 0}}}},
                   .depth = DepthOutput{everywhere_cells, 1.0f}});
  const Input hiding{"hidingDepth", *scene_copy.hiding_depth};
  declare_regions(graph, l, 1,
                  {.label = "glass rate",
                   .fragment = "glass_rate.frag",
                   .constants = {gpu::constant(apart, glass_step)},
                   .depth_compare = gpu::Compare::greater_equal},
                  {.reads = {interior, hiding, cells}, .depth = DepthOutput{marks, 0.0f}});

  Stages full(graph, l, draws, {1, "full", {marks}}, scene_copy, interior, holds);
  full.declare_lobes();
  full.declare_look({scene_color(graph)});
  full.declare_rest({scene_color(graph)});

  std::vector<Input> resolves = footprints;
  for (Input& footprint : resolves)
    footprint.filter = gpu::Filter::linear;
  resolves.insert(
      resolves.end(),
      {interior, hiding, cells, {"screenPyramid", scene_copy.pyramid, gpu::Filter::linear}});
  declare_regions(
      graph, l, 1,
      {.label = "glass resolve",
       .fragment = "glass_resolve.frag",
       .constants = {gpu::constant(apart, glass_step)},
       .depth_write = false,
       .depth_compare = gpu::Compare::equal,
       .blend = gpu::Blend::over},
      {.reads = resolves, .colors = {{.part = {scene_color(graph)}}}, .depth = DepthOutput{marks}});
}

} // namespace gg::frame
