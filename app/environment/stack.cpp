#include "environment/stack.h"

#include "environment/equirect_lattice.h"
#include "environment/face_balance.h"
#include "environment/stack_plan.h"
#include "environment/steps.h"
#include "environment/zonal.h"

#include <algorithm>
#include <cmath>
#include <future>

namespace gg::environment {
namespace {

constexpr double cosine_amplified = 25.0; // at most: half floats keep 3 digits of what that leaves
constexpr double cosine_kept = 0.002; // rad²: 0.2 % less contrast at degree 1, 0.6 % at degree 2
// Read without interpolation: of the narrowest kernel, 0.22 rad, a value is then at most 0.04 % of the peak off, and as much too
// large here as too small there.
constexpr int kernel_samples = 4096;

// Texels of a face's edge that one group of a stage makes: local_size, times 2 as an invocation makes a quad.
constexpr int quads_group = 16, zonal_group = 8;
int groups(int texels, int of_one) {
  return (texels + of_one - 1) / of_one;
}

const std::string stages[] = {"environment_equirect.comp", "environment_blur.comp",
                              "environment_zonal.comp"};

gpu::TextureDesc cube_desc(const std::string& label, int size, int level_count,
                           gpu::Format format = gpu::Format::rgba16f) {
  return {.label = label,
          .shape = gpu::Shape::cube,
          .format = format,
          .width = size,
          .height = size,
          .levels = level_count,
          .use = gpu::Use::sampled | gpu::Use::storage | gpu::Use::read_back};
}

// What the host works out while shaders are compiled.
struct Prepared {
  EquirectLattice lattice;
  std::vector<std::vector<float>> blur_weights; // of each step, one face (face_balance.h)
  // Of the steps over all pairs, the irradiance's last: the kernels, row by row, and the source's weights.
  std::vector<float> kernels;
  std::vector<std::vector<float>> pair_weights;
};

Prepared prepare(const Map& map, const StackPlan& plan, float unit) {
  Prepared p;
  p.lattice = equirect_lattice(map, face_of(map), unit, sharp_sigma(map), equirect_reach);
  for (const Blur& b : plan.blurs)
    p.blur_weights.push_back(blur_weights(b.to.size, b.step.kernel));
  const auto pairs = [&](int size, int source_size, const std::vector<float>& kernel) {
    p.kernels.insert(p.kernels.end(), kernel.begin(), kernel.end());
    p.pair_weights.push_back(zonal_weights(size, source_size, kernel));
  };
  for (const Wide& w : plan.wide)
    pairs(w.to.size, plan.blurs.back().to.size, heat_kernel_table(w.variance, kernel_samples));
  const int source = plan.irradiance_source.size;
  const double sigma = odd_sigma(source);
  pairs(irradiance_face, source,
        cosine_kernel_table(sigma * sigma, cosine_kept, cosine_amplified, kernel_samples));
  return p;
}

class Builder {
public:
  Builder(gpu::Device& device, const Map& map);
  Stack build(std::vector<gpu::PassTime>* times);

private:
  void create_cubes();
  void blur(const Prepared& prepared);
  void convolve(const Prepared& prepared);
  gpu::View faces(const Place& place) const {
    return {.texture = place.odd ? stack_.odd : stack_.even,
            .level = place.level,
            .level_count = 1,
            .layer = 0,
            .layer_count = 6};
  }
  gpu::TextureRef cube(const std::string& label, int size, int level_count,
                       gpu::Format format = gpu::Format::rgba16f);
  gpu::View filled(const std::string& label, int width, int height, gpu::Format format,
                   std::span<const float> values);

  gpu::Device& device_;
  Map map_;
  StackPlan plan_;
  int face_;
  Stack stack_;
  gpu::PipelineRef equirect_, blur_, zonal_;
  Steps steps_;
};

Builder::Builder(gpu::Device& device, const Map& map)
    : device_(device), map_(fitted(map)), plan_(plan_stack(map_)), face_(face_of(map_)),
      steps_(device) {
  // The next power of two above the brightest pixel becomes 32,768, half of what a half float can hold.
  const float peak = *std::ranges::max_element(map_.rgb);
  stack_.unit =
      peak > 0.0f ? std::ldexp(1.0f, std::clamp(std::ilogb(peak) + 1 - 15, -120, 120)) : 1.0f;
}

gpu::TextureRef Builder::cube(const std::string& label, int size, int level_count,
                              gpu::Format format) {
  return device_.create(cube_desc(map_.name + ": " + label, size, level_count, format));
}

gpu::View Builder::filled(const std::string& label, int width, int height, gpu::Format format,
                          std::span<const float> values) {
  const auto texture = device_.create(gpu::TextureDesc{.label = label,
                                                       .format = format,
                                                       .width = width,
                                                       .height = height,
                                                       .use = gpu::Use::sampled});
  device_.upload(texture, 0, 0, std::as_bytes(values));
  return gpu::whole(texture);
}

void Builder::create_cubes() {
  const int even_levels = even_level_count(face_);
  stack_.even = cube("environment, even levels", face_, even_levels);
  stack_.odd = cube("environment, odd levels", face_ / 2, even_levels - 1);
  stack_.irradiance = cube("irradiance", irradiance_face, 1);
  stack_.sampler = device_.create(gpu::SamplerDesc{.between_levels = gpu::Filter::linear});
}

// The sharp level, and from level to level by Gaussian steps. Each hands on to the next what that reads: radiance times weight.
void Builder::blur(const Prepared& prepared) {
  const std::vector<Blur>& blurs = plan_.blurs;
  gpu::View handed[2]; // in turn
  for (gpu::View& view : handed)
    view = gpu::whole(cube("weighted", face_ / 2, 1, gpu::Format::rgba32f));
  std::vector<gpu::View> weights;
  for (std::size_t i = 0; i < blurs.size(); ++i)
    weights.push_back(filled("weights", blurs[i].to.size, blurs[i].to.size, gpu::Format::r32f,
                             prepared.blur_weights[i]));
  weights.push_back(weights.back()); // bound in the last step, which does not read it

  const EquirectLattice& lattice = prepared.lattice;
  steps_.add("environment: cube", equirect_, plan_.sharp,
             {{"equirect",
               filled(map_.name, map_.width, map_.height, gpu::Format::rgba32f, lattice.texels)},
              {"rows", filled("rows", map_.width, 3, gpu::Format::rgba32f, lattice.rows)},
              {"nextWeights", weights[0]}},
             {{"result", faces({false, 0, face_})}, {"weightedResult", handed[0]}},
             groups(face_, quads_group));
  for (std::size_t i = 0; i < blurs.size(); ++i)
    steps_.add("environment: blur", blur_, blurs[i].step,
               {{"weighted", handed[i % 2]}, {"nextWeights", weights[i + 1]}},
               {{"result", faces(blurs[i].to)}, {"weightedResult", handed[(i + 1) % 2]}},
               groups(blurs[i].to.size, quads_group));
}

// The widest levels and the irradiance, over all pairs.
void Builder::convolve(const Prepared& prepared) {
  const gpu::View kernels =
      filled("kernels", kernel_samples, static_cast<int>(prepared.pair_weights.size()),
             gpu::Format::r32f, prepared.kernels);
  int row = 0;
  const auto pairs = [&](const Place& from, const gpu::View& to, int size) {
    EnvironmentStep step{};
    step.sizes = {size, from.size, row, 0};
    steps_.add("environment: wide", zonal_, step,
               {{"kernels", kernels},
                {"source", faces(from)},
                {"weights", filled("weights", from.size, from.size, gpu::Format::r32f,
                                   prepared.pair_weights[static_cast<std::size_t>(row)])}},
               {{"result", to}}, groups(size, zonal_group));
    ++row;
  };
  for (const Wide& w : plan_.wide)
    pairs(plan_.blurs.back().to, faces(w.to), w.to.size);
  pairs(plan_.irradiance_source, gpu::whole(stack_.irradiance), irradiance_face);
}

Stack Builder::build(std::vector<gpu::PassTime>* times) {
  device_.expect(stages);
  auto prepared =
      std::async(std::launch::async, prepare, std::cref(map_), std::cref(plan_), stack_.unit);
  create_cubes();
  const auto compute = [this](const std::string& stage) {
    return device_.create(gpu::ComputeDesc{stage, stage, {}});
  };
  equirect_ = compute(stages[0]);
  blur_ = compute(stages[1]);
  zonal_ = compute(stages[2]);
  const Prepared ready = prepared.get();
  blur(ready);
  convolve(ready);
  steps_.run(times);

  const double sharpest = sharp_sigma(map_), first = even_sigma(face_ / 2);
  stack_.shape = {std::sqrt(sharpest * sharpest + lookup_variance(face_)),
                  // The mean of an even and an odd level's share, as one number stands for both.
                  std::sqrt(first * first + 0.75 * lookup_variance(face_ / 2)),
                  2 * (even_level_count(face_) - 1) - 1, stack_.unit};
  return stack_;
}

} // namespace

std::vector<Level> levels(const Stack& stack) {
  const int face = stack.even->desc.width;
  // The sharp level's sigma belongs to the map; its lookup's share is taken off again.
  const double sharp = static_cast<double>(stack.shape.x);
  std::vector<Level> list{
      {stack.even.get(), 0, std::sqrt(std::max(sharp * sharp - lookup_variance(face), 0.0))}};
  for (int k = 1; k < stack.even->desc.levels; ++k) {
    list.push_back({stack.even.get(), k, even_sigma(face >> k)});
    list.push_back({stack.odd.get(), k - 1, odd_sigma(face >> k)});
  }
  return list;
}

Stack build(gpu::Device& device, const Map& map, std::vector<gpu::PassTime>* times) {
  return Builder(device, map).build(times);
}

std::size_t bytes_of(const Map& map) {
  const int face = face_of(fitted(map)), levels = even_level_count(face);
  return bytes(cube_desc("", face, levels)) + bytes(cube_desc("", face / 2, levels - 1))
         + bytes(cube_desc("", irradiance_face, 1));
}

} // namespace gg::environment
