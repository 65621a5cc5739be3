#include "environment/stack.h"

#include "environment/equirect_lattice.h"
#include "environment/zonal.h"
#include "glsl/f64.h"

#include <glm/gtc/type_precision.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <future>
#include <map>
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
constexpr double texels_per_sigma =
    1.25; // of even levels at a face's centre, where a texel is 2 / size wide
constexpr double sharp_pixels = 0.6;      // sigma of the sharp level in pixels of the picture
constexpr double equirect_reach = 4.0;    // sigma: environment_equirect.comp
constexpr double cosine_amplified = 25.0; // at most: half floats keep 3 digits of what that leaves
constexpr double cosine_kept = 0.002; // rad²: 0.2 % less contrast at degree 1, 0.6 % at degree 2
// Read without interpolation: of the narrowest kernel, 0.22 rad, a value is then at most 0.04 % of the peak off, and as much too
// large here as too small there.
constexpr int kernel_samples = 4096;
constexpr int balance_rounds = 4;     // of the wide kernels: what is left is below 1e-4
constexpr int blur_balance_steps = 3; // environment_blur.comp

// Texels of a face's edge that one group of a stage makes: local_size, times 2 where an invocation makes a quad.
constexpr int quads_group = 16, zonal_group = 8;
int groups(int texels, int of_one) {
  return (texels + of_one - 1) / of_one;
}

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

// sigma of the sharp level, radians.
double sharp_sigma(const Map& map) {
  return sharp_pixels * std::numbers::pi / map.height;
}

// `kernel` of a step that ends at so many sigma.
vec4 kernel_of(double reach, double variance) {
  const double radius = reach * std::sqrt(variance), half = std::sin(0.5 * radius);
  return {radius, 4.0 * half * half, 0.5 / variance, 0.0};
}

const std::string stages[] = {"environment_equirect.comp", "environment_blur.comp",
                              "environment_zonal.comp"};

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
  struct Image {
    const char* name;
    gpu::View view;
  };
  // A Gaussian step, from the level before it to `to`.
  struct Blur {
    gpu::View to;
    int size;        // of the result
    double variance; // what the result has more than the source
    bool halved;     // the source is twice as large
    EnvironmentStep step;
    gpu::View weights;
  };
  // What the step before the i-th blur hands on to it; with none left, what is bound in its place and not used.
  int next_size(std::size_t i) const { return i < blurs_.size() ? blurs_[i].size : 0; }
  gpu::View next_weights(std::size_t i) {
    return i < blurs_.size() ? blurs_[i].weights : areas(blurs_.back().size);
  }
  gpu::View handed_to(std::size_t i) const { return gpu::whole(weighted_[i % 2]); }
  void add(const std::string& label, const gpu::PipelineRef& pipeline, const EnvironmentStep& step,
           std::vector<Bound> textures, std::vector<Image> images, int groups_per_edge, int layers);
  void sharp(const EquirectLattice& lattice);
  void plan_blurs();
  void blur(std::size_t i);
  void zonal(const gpu::View& from, int from_size, const gpu::View& to, int size, int kernel);
  gpu::TextureRef plane(const std::string& label, int width, int height,
                        gpu::Format format = gpu::Format::r32f);
  gpu::TextureRef filled(const std::string& label, int width, int height, gpu::Format format,
                         const std::vector<float>& values);
  gpu::TextureRef cube(const std::string& label, int size, int level_count,
                       gpu::Format format = gpu::Format::rgba16f);
  gpu::View areas(int size);
  gpu::PipelineRef compute(const std::string& file, std::vector<gpu::Constant> constants = {});

  gpu::Device& device_;
  Map map_;
  Stack stack_;
  gpu::TextureRef weighted_[2]; // in turn: what a blur reads, and what it hands on
  gpu::TextureRef kernels_;
  gpu::SamplerRef point_;
  gpu::BufferRef steps_;
  std::vector<EnvironmentStep> step_values_;
  std::vector<gpu::Pass> passes_;
  std::vector<Blur> blurs_;
  double blurred_variance_ = 0.0;        // of the last of them
  std::map<int, gpu::TextureRef> areas_; // of the texels of a face, by its size
  gpu::PipelineRef equirect_, blur_, blur_balance_, zonal_, zonal_balance_;
  int face_ = 0;
};

int face_for(const Map& map) {
  return std::clamp(static_cast<int>(std::bit_ceil(static_cast<unsigned>(map.width / 2))),
                    least_face, greatest_face);
}

Map fitted(const Map& map) {
  return fitted_between(map, least_face / 2, 2 * greatest_face);
}

Builder::Builder(gpu::Device& device, const Map& map) : device_(device), map_(fitted(map)) {
  face_ = face_for(map_);
  // The next power of two above the brightest pixel becomes 32,768, half of what a half float can hold.
  const float peak = *std::ranges::max_element(map_.rgb);
  stack_.unit =
      peak > 0.0f ? std::ldexp(1.0f, std::clamp(std::ilogb(peak) + 1 - 15, -120, 120)) : 1.0f;
}

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

int even_level_count(int face) {
  return std::countr_zero(static_cast<unsigned>(face / smallest_level)) + 1;
}

gpu::TextureRef Builder::cube(const std::string& label, int size, int level_count,
                              gpu::Format format) {
  return device_.create(cube_desc(map_.name + ": " + label, size, level_count, format));
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
                  const EnvironmentStep& step, std::vector<Bound> textures,
                  std::vector<Image> images, int groups_per_edge, int layers) {
  gpu::Pass pass;
  pass.label = label;
  for (const Bound& b : textures)
    pass.reads.push_back(b.view);
  for (const Image& i : images)
    pass.storage.push_back(i.view);
  const std::size_t offset = step_values_.size() * gpu::block_alignment;
  step_values_.push_back(step);
  const auto edge = static_cast<std::uint32_t>(groups_per_edge);
  pass.record = [=, this, textures = std::move(textures),
                 images = std::move(images)](gpu::Encoder& encoder) {
    encoder.use(pipeline);
    encoder.buffer("Step", steps_, offset, sizeof(EnvironmentStep));
    for (const Bound& b : textures)
      encoder.texture(b.name, b.view, b.sampler);
    for (const Image& i : images)
      encoder.image(i.name, i.view);
    encoder.dispatch(edge, edge, static_cast<std::uint32_t>(layers));
  };
  passes_.push_back(std::move(pass));
}

gpu::View Builder::areas(int size) {
  gpu::TextureRef& texture = areas_[size];
  if (!texture) {
    std::vector<float> values;
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x)
        values.push_back(static_cast<float>(glsl::f64::cubeTexelSolidAngle(x, y, size)));
    texture = filled("areas", size, size, gpu::Format::r32f, values);
  }
  return gpu::whole(texture);
}

void Builder::sharp(const EquirectLattice& lattice) {
  const auto picture =
      filled(map_.name, map_.width, map_.height, gpu::Format::rgba32f, lattice.texels);
  const auto rows = filled("rows", map_.width, 3, gpu::Format::rgba32f, lattice.rows);
  EnvironmentStep step{};
  step.sizes = {face_, next_size(0), map_.width, map_.height};
  step.kernel = kernel_of(equirect_reach, sharp_sigma(map_) * sharp_sigma(map_));
  add("environment: cube", equirect_, step,
      {{"equirect", gpu::whole(picture), point_},
       {"rows", gpu::whole(rows), point_},
       {"nextWeights", next_weights(0), point_}},
      {{"result", faces(stack_.even, 0)}, {"weightedResult", handed_to(0)}},
      groups(face_, quads_group), 6);
}

// The blurs from level to level, and the balance of their weights, which depends on sizes and widths alone.
void Builder::plan_blurs() {
  const double sharpest = sharp_sigma(map_);
  blurred_variance_ = sharpest * sharpest;
  for (int level = 1; face_ >> level > zonal_face; ++level) {
    const int size = face_ >> level;
    const double even = even_sigma(size) * even_sigma(size), odd = 2.0 * even;
    blurs_.push_back({faces(stack_.even, level), size, even - blurred_variance_, true, {}, {}});
    blurs_.push_back({faces(stack_.odd, level - 1), size, odd - even, false, {}, {}});
    blurred_variance_ = odd;
  }
  for (std::size_t i = 0; i < blurs_.size(); ++i) {
    Blur& b = blurs_[i];
    b.step.sizes = {b.size, next_size(i + 1), 0, 0};
    b.step.kernel =
        kernel_of(glsl::f64::HEAT_KERNEL_REACH, b.variance / glsl::f64::HEAT_KERNEL_KEPT);
    // The four points that a halved texel is the mean of lie half a source texel off: a 16th of its area per axis, at a face's
    // centre of 4 / size², and half of it for each end.
    if (b.halved)
      b.step.kernel.w = static_cast<float>(0.5 / 16.0 * 4.0 / (b.size * b.size) / b.variance);
    b.weights = areas(b.size);
    for (int round = 0; round < blur_balance_steps; ++round) {
      const gpu::View next = gpu::whole(plane("weights", b.size, b.size));
      add("environment: balance", blur_balance_, b.step, {{"weights", b.weights, point_}},
          {{"weightsResult", next}}, groups(b.size / 2, quads_group), 1);
      b.weights = next;
    }
  }
}

void Builder::blur(std::size_t i) {
  const Blur& b = blurs_[i];
  add("environment: blur", blur_, b.step,
      {{"weighted", handed_to(i), point_}, {"nextWeights", next_weights(i + 1), point_}},
      {{"result", b.to}, {"weightedResult", handed_to(i + 1)}}, groups(b.size, quads_group), 6);
}

void Builder::zonal(const gpu::View& from, int from_size, const gpu::View& to, int size,
                    int kernel) {
  EnvironmentStep onto_result{}, onto_source{};
  onto_result.sizes = {size, from_size, kernel, 0};
  onto_source.sizes = {from_size, size, kernel, 0};

  const Bound kernels{"kernels", gpu::whole(kernels_), point_};
  const gpu::View rows = gpu::whole(plane("rows", size, size)),
                  columns = gpu::whole(plane("columns", from_size, from_size));
  for (int round = 0; round < balance_rounds; ++round) {
    add("environment: balance", zonal_balance_, onto_result,
        {kernels, {"weights", round ? columns : areas(from_size), point_}},
        {{"weightsResult", rows}}, groups(size / 2, zonal_group), 1);
    add("environment: balance", zonal_balance_, onto_source, {kernels, {"weights", rows, point_}},
        {{"weightsResult", columns}}, groups(from_size / 2, zonal_group), 1);
  }
  add("environment: wide", zonal_, onto_result,
      {kernels, {"source", from, point_}, {"weights", columns, point_}}, {{"result", to}},
      groups(size, zonal_group), 6);
}

Stack Builder::build(std::vector<gpu::PassTime>* times) {
  device_.expect(stages);
  const int even_levels = even_level_count(face_);
  stack_.even = cube("environment, even levels", face_, even_levels);
  stack_.odd = cube("environment, odd levels", face_ / 2, even_levels - 1);
  stack_.irradiance = cube("irradiance", irradiance_face, 1);
  stack_.sampler = device_.create(gpu::SamplerDesc{.between_levels = gpu::Filter::linear});
  for (gpu::TextureRef& texture : weighted_)
    texture = cube("weighted", face_ / 2, 1, gpu::Format::rgba32f);
  point_ = device_.create(
      gpu::SamplerDesc{.magnify = gpu::Filter::nearest, .minify = gpu::Filter::nearest});
  // The host balances the picture's lattice while the shaders are compiled.
  auto lattice = std::async(std::launch::async, [this] {
    return equirect_lattice(map_, face_, stack_.unit, sharp_sigma(map_), equirect_reach);
  });
  equirect_ = compute("environment_equirect.comp");
  blur_ = compute("environment_blur.comp", {gpu::constant(0, false)});
  blur_balance_ = compute("environment_blur.comp", {gpu::constant(0, true)});
  zonal_ = compute("environment_zonal.comp", {gpu::constant(0, false)});
  zonal_balance_ = compute("environment_zonal.comp", {gpu::constant(0, true)});
  plan_blurs();
  sharp(lattice.get());
  for (std::size_t i = 0; i < blurs_.size(); ++i)
    blur(i);
  // Levels that are convolved over all pairs, by growing sigma, and the odd level before them.
  std::vector<std::pair<gpu::View, int>> wide;
  for (int level = even_levels - 1; face_ >> level <= zonal_face; --level) {
    const int size = face_ >> level;
    wide.insert(wide.begin(),
                {{faces(stack_.even, level), size}, {faces(stack_.odd, level - 1), size}});
  }
  const gpu::View last = blurs_.back().to;

  // All kernels of the angle in one table: those of the wide levels, then the cosine.
  std::vector<float> kernels;
  for (std::size_t i = 0; i < wide.size(); ++i) {
    const double sigma = i % 2 ? odd_sigma(wide[i].second) : even_sigma(wide[i].second);
    const auto row = heat_kernel_table(sigma * sigma - blurred_variance_, kernel_samples);
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

  const double sharpest = sharp_sigma(map_), first = even_sigma(face_ / 2);
  stack_.shape = {std::sqrt(sharpest * sharpest + lookup_variance(face_)),
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

std::size_t bytes_of(const Map& map) {
  const int face = face_for(fitted(map)), levels = even_level_count(face);
  return bytes(cube_desc("", face, levels)) + bytes(cube_desc("", face / 2, levels - 1))
         + bytes(cube_desc("", irradiance_face, 1));
}

} // namespace gg::environment
