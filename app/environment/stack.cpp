#include "environment/stack.h"

#include "environment/corner_balance.h"
#include "environment/zonal.h"

#include <glm/gtc/type_precision.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <numbers>

namespace gg::environment {
namespace {

using glm::ivec4;
using glm::vec4;
#include "../../shaders/interface/environment_step.glsl"
static_assert(sizeof(EnvironmentStep) == 32);

// Sizes, in texels along a face's edge. A face of the sharp level spans a quarter of the picture's width, and has twice the
// texels of that, so that its Gaussian of half a pixel is 0.8 of a texel at the face's centre: enough to be without alias.
constexpr int least_face = 64, greatest_face = 1024, smallest_level = 4, irradiance_face = 16;
// Up to this size of result the kernel is convolved over all pairs, from the odd level of twice the size.
constexpr int zonal_face = 8;
constexpr int irradiance_source = 32;
// From this size on a kernel spans less than 7 degrees, over which sin² is theta² to 0.5 % and texels have one area to 10 %.
constexpr int narrow_face = 128;
constexpr double texels_per_sigma =
    1.25; // of even levels at a face's centre, where a texel is 2 / size wide
constexpr double sharp_pixels = 0.6;      // sigma of the sharp level in pixels of the picture
constexpr double equirect_reach = 4.0;    // sigma: environment_equirect.comp
constexpr double cosine_amplified = 25.0; // at most: half floats keep 3 digits of what that leaves
constexpr double cosine_kept = 0.002; // rad²: 0.2 % less contrast at degree 1, 0.6 % at degree 2
constexpr int kernel_samples = 1024;
constexpr int balance_rounds = 4; // of the wide kernels: what is left is below 1e-4

double even_sigma(int size) {
  return 2.0 * texels_per_sigma / size;
}
double odd_sigma(int size) {
  return std::numbers::sqrt2 * even_sigma(size);
}

// Bilinear lookups add a sixth of a texel's area to the variance per axis, on average.
double lookup_variance(int size) {
  return 4.0 * std::numbers::pi / (6.0 * size * size) / 6.0;
}

gpu::View faces(const gpu::TextureRef& cube, int level) {
  return {.texture = cube, .level = level, .level_count = 1, .layer = 0, .layer_count = 6};
}

// Collects the passes of the build; they run together at the end.
class Builder {
public:
  Builder(gpu::Device& device, const Map& map);
  Stack build(std::vector<gpu::PassTime>* times);

private:
  struct Bound {
    const char* name;
    gpu::View view;
    gpu::SamplerRef sampler;
  };
  void add(const std::string& label, const gpu::PipelineRef& pipeline, const EnvironmentStep& step,
           std::vector<Bound> textures, const char* image_name, const gpu::View& image, int size,
           int layers);
  void sharp();
  void blur(const gpu::View& from, const gpu::View& to, int size, double variance, bool halved);
  void zonal(const gpu::View& from, int from_size, const gpu::View& to, int size, int kernel);
  gpu::TextureRef plane(const std::string& label, int width, int height,
                        gpu::Format format = gpu::Format::r32f);
  gpu::TextureRef filled(const std::string& label, int width, int height, gpu::Format format,
                         const std::vector<float>& values);
  gpu::TextureRef cube(const std::string& label, int size, int level_count,
                       gpu::Format format = gpu::Format::rgba16f);
  gpu::PipelineRef blur_pipeline(int stage, bool narrow);
  gpu::PipelineRef compute(const std::string& file, std::vector<gpu::Constant> constants = {});

  gpu::Device& device_;
  Map map_;
  Stack stack_;
  gpu::TextureRef scratch_, kernels_;
  gpu::SamplerRef point_;
  gpu::BufferRef steps_;
  std::vector<EnvironmentStep> step_values_;
  std::vector<gpu::Pass> passes_;
  gpu::PipelineRef weigh_[2], blur_[6], zonal_[4];
  int face_ = 0;
};

int face_for(const Map& map) {
  return std::clamp(static_cast<int>(std::bit_ceil(static_cast<unsigned>(map.width / 2))),
                    least_face, greatest_face);
}

Builder::Builder(gpu::Device& device, const Map& map)
    : device_(device), map_(fitted_between(map, least_face / 2, 2 * greatest_face)) {
  face_ = face_for(map_);
  // The next power of two above the brightest pixel becomes 32,768, half of what a half float can hold.
  const float peak = *std::ranges::max_element(map_.rgb);
  stack_.unit =
      peak > 0.0f ? std::ldexp(1.0f, std::clamp(std::ilogb(peak) + 1 - 15, -120, 120)) : 1.0f;
}

gpu::TextureRef Builder::cube(const std::string& label, int size, int level_count,
                              gpu::Format format) {
  return device_.create(
      gpu::TextureDesc{.label = map_.name + ": " + label,
                       .shape = gpu::Shape::cube,
                       .format = format,
                       .width = size,
                       .height = size,
                       .levels = level_count,
                       .use = gpu::Use::sampled | gpu::Use::storage | gpu::Use::read_back});
}

gpu::TextureRef Builder::plane(const std::string& label, int width, int height,
                               gpu::Format format) {
  return device_.create(gpu::TextureDesc{.label = label,
                                         .format = format,
                                         .width = width,
                                         .height = height,
                                         .use = gpu::Use::sampled | gpu::Use::storage});
}

gpu::TextureRef Builder::filled(const std::string& label, int width, int height, gpu::Format format,
                                const std::vector<float>& values) {
  const auto texture = device_.create(gpu::TextureDesc{.label = label,
                                                       .format = format,
                                                       .width = width,
                                                       .height = height,
                                                       .use = gpu::Use::sampled});
  device_.upload(texture, 0, 0, std::as_bytes(std::span(values)));
  return texture;
}

gpu::PipelineRef Builder::compute(const std::string& file, std::vector<gpu::Constant> constants) {
  return device_.create(gpu::ComputeDesc{file, file, std::move(constants)});
}

void Builder::add(const std::string& label, const gpu::PipelineRef& pipeline,
                  const EnvironmentStep& step, std::vector<Bound> textures, const char* image_name,
                  const gpu::View& image, int size, int layers) {
  gpu::Pass pass;
  pass.label = label;
  for (const Bound& b : textures)
    pass.reads.push_back(b.view);
  pass.storage = {image};
  const std::size_t offset = step_values_.size() * gpu::block_alignment;
  step_values_.push_back(step);
  const auto groups = static_cast<std::uint32_t>((size + 7) / 8);
  pass.record = [=, this, textures = std::move(textures)](gpu::Encoder& encoder) {
    encoder.use(pipeline);
    encoder.buffer("Step", steps_, offset, sizeof(EnvironmentStep));
    for (const Bound& b : textures)
      encoder.texture(b.name, b.view, b.sampler);
    encoder.image(image_name, image);
    encoder.dispatch(groups, groups, static_cast<std::uint32_t>(layers));
  };
  passes_.push_back(std::move(pass));
}

gpu::PipelineRef Builder::blur_pipeline(int stage, bool narrow) {
  gpu::PipelineRef& pipeline = blur_[2 * stage + narrow];
  if (!pipeline)
    pipeline =
        compute("environment_blur.comp", {gpu::constant(0, stage), gpu::constant(1, narrow)});
  return pipeline;
}

void Builder::sharp() {
  std::vector<float> texels;
  texels.reserve(map_.rgb.size() / 3 * 4);
  const float scale = 1.0f / stack_.unit;
  for (std::size_t i = 0; i < map_.rgb.size(); i += 3)
    texels.insert(texels.end(),
                  {scale * map_.rgb[i], scale * map_.rgb[i + 1], scale * map_.rgb[i + 2], 1.0f});
  const double sigma = sharp_pixels * std::numbers::pi / map_.height;
  const std::vector<float> balanced = balanced_rows(map_.width, map_.height, sigma, equirect_reach);
  // The picture's fourth channel is what a pixel counts for beside its row.
  for (const PixelFactor& f :
       balanced_corners(map_.width, map_.height, face_, sigma, equirect_reach, balanced))
    texels[4 * f.pixel + 3] = f.factor;
  const auto picture = filled(map_.name, map_.width, map_.height, gpu::Format::rgba32f, texels);
  std::vector<float> rings;
  for (int y = 0; y < map_.height; ++y) {
    const double theta = std::numbers::pi * (y + 0.5) / map_.height;
    rings.insert(rings.end(),
                 {static_cast<float>(std::sin(theta)), static_cast<float>(std::cos(theta)),
                  balanced[static_cast<std::size_t>(y)], 0.0f});
  }
  const auto rows = filled("rows", map_.height, 1, gpu::Format::rgba32f, rings);
  EnvironmentStep step{};
  step.sizes = {face_, 0, map_.width, map_.height};
  step.kernel.x = static_cast<float>(sigma);
  add("environment: cube", compute("environment_equirect.comp"), step,
      {{"equirect", gpu::whole(picture), point_}, {"rows", gpu::whole(rows), point_}}, "result",
      faces(stack_.even, 0), face_, 6);
}

// `variance` is what the result has more than the source. `from_level` of the source is as large as the result, or twice
// as large and halved first, which adds a part of the variance.
void Builder::blur(const gpu::View& from, const gpu::View& to, int size, double variance,
                   bool halved) {
  EnvironmentStep step{};
  step.sizes = {size, halved ? 2 * size : size, 0, 0};
  // The four points that a halved texel is the mean of lie half a source texel off: a 16th of its area per axis.
  step.kernel = {variance, halved ? 1.0 / 16.0 : 0.0, 0.0, 0.0};
  const bool narrow = size >= narrow_face;
  const gpu::View first = gpu::whole(plane("weights", size, size)),
                  second = gpu::whole(plane("weights", size, size)),
                  third = gpu::whole(plane("weights", size, size));
  add("environment: balance", blur_pipeline(1, narrow), step, {}, "weightsResult", first, size / 2,
      1);
  add("environment: balance", blur_pipeline(2, narrow), step, {{"weights", first, point_}},
      "weightsResult", second, size / 2, 1);
  add("environment: balance", blur_pipeline(2, narrow), step, {{"weights", second, point_}},
      "weightsResult", third, size / 2, 1);
  const gpu::View weighted =
      faces(scratch_, std::countr_zero(static_cast<unsigned>(face_ / 2 / size)));
  add("environment: weigh", weigh_[halved], step,
      {{"source", from, point_}, {"weights", third, point_}}, "weighted", weighted, size, 6);
  add("environment: blur", blur_pipeline(0, narrow), step, {{"weighted", weighted, point_}},
      "result", to, size, 6);
}

void Builder::zonal(const gpu::View& from, int from_size, const gpu::View& to, int size,
                    int kernel) {
  EnvironmentStep step{};
  step.sizes = {size, from_size, 0, 0};
  step.kernel.z = static_cast<float>(kernel);
  const Bound kernels{"kernels", gpu::whole(kernels_), device_.create(gpu::SamplerDesc{})};
  const gpu::View rows = gpu::whole(plane("rows", size, size)),
                  columns = gpu::whole(plane("columns", from_size, from_size));
  add("environment: balance", zonal_[0], step, {kernels}, "balanceResult", rows, 2 * size, 1);
  for (int round = 0; round < balance_rounds; ++round) {
    add("environment: balance", zonal_[1], step, {kernels, {"rows", rows, point_}}, "balanceResult",
        columns, 2 * from_size, 1);
    if (round + 1 < balance_rounds)
      add("environment: balance", zonal_[2], step, {kernels, {"columns", columns, point_}},
          "balanceResult", rows, 2 * size, 1);
  }
  add("environment: wide", zonal_[3], step,
      {kernels, {"source", from, point_}, {"columns", columns, point_}}, "result", to, 2 * size, 6);
}

Stack Builder::build(std::vector<gpu::PassTime>* times) {
  const int even_levels = std::countr_zero(static_cast<unsigned>(face_ / smallest_level)) + 1;
  stack_.even = cube("environment, even levels", face_, even_levels);
  stack_.odd = cube("environment, odd levels", face_ / 2, even_levels - 1);
  stack_.irradiance = cube("irradiance", irradiance_face, 1);
  stack_.sampler = device_.create(gpu::SamplerDesc{.between_levels = gpu::Filter::linear});
  scratch_ = cube("scratch", face_ / 2, even_levels - 1, gpu::Format::rgba32f);
  point_ = device_.create(
      gpu::SamplerDesc{.magnify = gpu::Filter::nearest, .minify = gpu::Filter::nearest});
  for (const bool halved : {false, true})
    weigh_[halved] = compute("environment_weigh.comp", {gpu::constant(0, halved)});
  for (int stage = 0; stage < 4; ++stage)
    zonal_[stage] = compute("environment_zonal.comp", {gpu::constant(0, stage)});

  const double sharp_sigma = sharp_pixels * std::numbers::pi / map_.height;
  double variance = sharp_sigma * sharp_sigma;
  sharp();
  std::vector<std::pair<gpu::View, int>>
      wide;       // levels that are convolved over all pairs, by growing sigma
  gpu::View last; // the odd level before them
  for (int level = 1; level < even_levels; ++level) {
    const int size = face_ >> level;
    const gpu::View even = faces(stack_.even, level), odd = faces(stack_.odd, level - 1);
    if (size <= zonal_face) {
      wide.push_back({even, size});
      wide.push_back({odd, size});
      continue;
    }
    const double even_variance = even_sigma(size) * even_sigma(size),
                 odd_variance = 2.0 * even_variance;
    blur(level == 1 ? faces(stack_.even, 0) : faces(stack_.odd, level - 2), even, size,
         even_variance - variance, true);
    blur(even, odd, size, odd_variance - even_variance, false);
    variance = odd_variance;
    last = odd;
  }

  // All kernels of the angle in one table: those of the wide levels, then the cosine.
  std::vector<float> kernels;
  for (std::size_t i = 0; i < wide.size(); ++i) {
    const double sigma = i % 2 ? odd_sigma(wide[i].second) : even_sigma(wide[i].second);
    const auto row = heat_kernel_table(sigma * sigma - variance, kernel_samples);
    kernels.insert(kernels.end(), row.begin(), row.end());
  }
  const double source_sigma = odd_sigma(irradiance_source);
  const auto cosine = cosine_kernel_table(source_sigma * source_sigma, cosine_kept,
                                          cosine_amplified, kernel_samples);
  kernels.insert(kernels.end(), cosine.begin(), cosine.end());
  const int rows = static_cast<int>(wide.size()) + 1;
  kernels_ = filled("kernels", kernel_samples, rows, gpu::Format::r32f, kernels);
  for (std::size_t i = 0; i < wide.size(); ++i)
    zonal(last, 2 * zonal_face, wide[i].first, wide[i].second, static_cast<int>(i));
  const int source_level = std::countr_zero(static_cast<unsigned>(face_ / 2 / irradiance_source));
  zonal(faces(stack_.odd, source_level), irradiance_source, faces(stack_.irradiance, 0),
        irradiance_face, rows - 1);

  std::vector<std::byte> blocks(step_values_.size() * gpu::block_alignment);
  for (std::size_t i = 0; i < step_values_.size(); ++i)
    std::memcpy(&blocks[i * gpu::block_alignment], &step_values_[i], sizeof(EnvironmentStep));
  steps_ = device_.create(gpu::BufferDesc{"environment steps", blocks.size(), gpu::Use::uniforms},
                          blocks);
  device_.run(passes_, times);

  const double first = even_sigma(face_ / 2);
  stack_.shape = {std::sqrt(sharp_sigma * sharp_sigma + lookup_variance(face_)),
                  // The mean of an even and an odd level's share, as one number stands for both.
                  std::sqrt(first * first + 0.75 * lookup_variance(face_ / 2)),
                  2 * (even_levels - 1) - 1, stack_.unit};
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

} // namespace gg::environment
