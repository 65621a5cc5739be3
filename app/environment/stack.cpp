#include "environment/stack.h"

#include "environment/equirect_lattice.h"
#include "environment/face_balance.h"
#include "environment/kept_stack.h"
#include "environment/stack_plan.h"
#include "environment/steps.h"
#include "environment/zonal.h"

#include <algorithm>
#include <array>
#include <chrono>
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

gpu::ComputeDesc pipeline_of(const std::string& stage) {
  return {stage, stage, {}};
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

// What the host works out for a step's shader: of the sharp level while that is compiled, of all others while the device is busy
// with the sharp one.
struct Sharp {
  EquirectLattice lattice;
  std::vector<float> next_weights; // of the first blur
};

Sharp prepare_sharp(const Map& map, const StackPlan& plan, float unit) {
  const Blur& next = plan.blurs.front();
  return {equirect_lattice(map, face_of(map), unit, sharp_sigma(map), equirect_reach),
          blur_weights(next.to.size, next.step.kernel)};
}

struct Blurred {
  std::vector<std::vector<float>> weights; // of each blur but the first, one face (face_balance.h)
  // Of the steps over all pairs, the irradiance's last: the kernels, row by row, and the source's weights.
  std::vector<float> kernels;
  std::vector<std::vector<float>> pair_weights;
};

Blurred prepare_blurred(const StackPlan& plan) {
  Blurred p;
  for (std::size_t i = 1; i < plan.blurs.size(); ++i)
    p.weights.push_back(blur_weights(plan.blurs[i].to.size, plan.blurs[i].step.kernel));
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

} // namespace

class Building::Builder {
public:
  Builder(gpu::Device& device, const Map& map, bool kept);
  void build(std::vector<gpu::PassTime>* times);
  bool advance();
  double progress() const;
  const Stack& stack() const { return stack_; }

private:
  void start_sharp(); // and work out what the others take meanwhile
  void start_blurred();
  void create_cubes();
  void sharp(const Sharp& prepared);
  void blur(const Blurred& prepared);
  void convolve(const Blurred& prepared);
  gpu::View faces(const Place& place) const {
    return {.texture = place.odd ? stack_.odd : stack_.even,
            .level = place.level,
            .level_count = 1,
            .layer = 0,
            .layer_count = 6};
  }
  gpu::TextureRef cube(const std::string& label, int size, int level_count,
                       gpu::Format format = gpu::Format::rgba16f);
  // One face of a blur's weights.
  gpu::View face(const Blur& blur, std::span<const float> weights) {
    return filled("weights", blur.to.size, blur.to.size, gpu::Format::r32f, weights);
  }
  gpu::View filled(const std::string& label, int width, int height, gpu::Format format,
                   std::span<const float> values);
  gpu::PipelineRef compute(const std::string& stage) { return device_.create(pipeline_of(stage)); }

  gpu::Device& device_;
  Map map_;
  std::optional<std::string> key_; // of what is kept
  StackPlan plan_;
  int face_;
  Stack stack_;
  Steps steps_;
  // In turn: what a step hands on to the next blur, radiance times weight and the weight.
  gpu::View handed_[2];
  // Last: they read the map and the plan.
  std::future<Sharp> for_sharp_; // until they are taken
  std::future<Blurred> for_blurred_;
  std::size_t left_ = 0; // steps, once all are known
  bool done_ = false;
};

Building::Builder::Builder(gpu::Device& device, const Map& map, bool kept)
    : device_(device), map_(fitted(map)), plan_(plan_stack(map_)), face_(face_of(map_)),
      steps_(device) {
  stack_.sun = sun_of(map_);
  // The next power of two above the brightest pixel becomes 32,768, half of what a half float can hold.
  const float peak = *std::ranges::max_element(map_.rgb);
  stack_.unit =
      peak > 0.0f ? std::ldexp(1.0f, std::clamp(std::ilogb(peak) + 1 - 15, -120, 120)) : 1.0f;
  const double sharpest = sharp_sigma(map_), first = even_sigma(face_ / 2);
  stack_.shape = {std::sqrt(sharpest * sharpest + lookup_variance(face_)),
                  // The mean of an even and an odd level's share, as one number stands for both.
                  std::sqrt(first * first + 0.75 * lookup_variance(face_ / 2)),
                  2 * (even_level_count(face_) - 1) - 1, stack_.unit};
  create_cubes();
  if (kept) key_ = key_of_stack(device_, map_);
  done_ = key_ && load_stack(device_, *key_, stack_);
  if (done_) return;
  device_.expect(std::array{pipeline_of("environment_equirect.comp"),
                            pipeline_of("environment_blur.comp"),
                            pipeline_of("environment_zonal.comp")});
  for_sharp_ =
      std::async(std::launch::async, prepare_sharp, std::cref(map_), std::cref(plan_), stack_.unit);
}

gpu::TextureRef Building::Builder::cube(const std::string& label, int size, int level_count,
                                        gpu::Format format) {
  return device_.create(cube_desc(map_.name + ": " + label, size, level_count, format));
}

gpu::View Building::Builder::filled(const std::string& label, int width, int height,
                                    gpu::Format format, std::span<const float> values) {
  const auto texture = device_.create(gpu::TextureDesc{.label = label,
                                                       .format = format,
                                                       .width = width,
                                                       .height = height,
                                                       .use = gpu::Use::sampled});
  device_.upload(texture, 0, 0, std::as_bytes(values));
  return gpu::whole(texture);
}

void Building::Builder::create_cubes() {
  const int even_levels = even_level_count(face_);
  stack_.even = cube("environment, even levels", face_, even_levels);
  stack_.odd = cube("environment, odd levels", face_ / 2, even_levels - 1);
  stack_.irradiance = cube("irradiance", irradiance_face, 1);
  stack_.sampler = device_.create(gpu::SamplerDesc{.between_levels = gpu::Filter::linear});
}

void Building::Builder::sharp(const Sharp& prepared) {
  const EquirectLattice& lattice = prepared.lattice;
  steps_.add("environment: cube", compute("environment_equirect.comp"), plan_.sharp,
             {{"equirect",
               filled(map_.name, map_.width, map_.height, gpu::Format::rgba32f, lattice.texels)},
              {"rows", filled("rows", map_.width, 3, gpu::Format::rgba32f, lattice.rows)},
              {"nextWeights", face(plan_.blurs.front(), prepared.next_weights)}},
             {{"result", faces({false, 0, face_})}, {"weightedResult", handed_[0]}},
             groups(face_, quads_group));
}

void Building::Builder::blur(const Blurred& prepared) {
  const gpu::PipelineRef pipeline = compute("environment_blur.comp");
  gpu::View next;
  for (std::size_t i = 0; i < plan_.blurs.size(); ++i) {
    // The last step reads no weights, but must have some bound.
    if (i < prepared.weights.size()) next = face(plan_.blurs[i + 1], prepared.weights[i]);
    const Blur& blur = plan_.blurs[i];
    steps_.add("environment: blur", pipeline, blur.step,
               {{"weighted", handed_[i % 2]}, {"nextWeights", next}},
               {{"result", faces(blur.to)}, {"weightedResult", handed_[(i + 1) % 2]}},
               groups(blur.to.size, quads_group));
  }
}

// The widest levels and the irradiance, over all pairs.
void Building::Builder::convolve(const Blurred& prepared) {
  const gpu::PipelineRef pipeline = compute("environment_zonal.comp");
  const gpu::View kernels =
      filled("kernels", kernel_samples, static_cast<int>(prepared.pair_weights.size()),
             gpu::Format::r32f, prepared.kernels);
  int row = 0;
  const auto pairs = [&](const Place& from, const gpu::View& to, int size) {
    EnvironmentStep step{};
    step.sizes = {size, from.size, row, 0};
    steps_.add("environment: wide", pipeline, step,
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

void Building::Builder::start_sharp() {
  for (gpu::View& view : handed_)
    view = gpu::whole(cube("weighted", face_ / 2, 1, gpu::Format::rgba32f));
  sharp(for_sharp_.get());
  for_blurred_ = std::async(std::launch::async, prepare_blurred, std::cref(plan_));
}

void Building::Builder::start_blurred() {
  const Blurred prepared = for_blurred_.get();
  blur(prepared);
  convolve(prepared);
}

void Building::Builder::build(std::vector<gpu::PassTime>* times) {
  if (done_) return;
  start_sharp();
  steps_.run(times);
  start_blurred();
  steps_.run(times);
  if (key_) store_stack(device_, *key_, stack_);
}

bool Building::Builder::advance() {
  const auto ready = [](const auto& future) {
    return future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  };
  if (for_sharp_.valid()) {
    if (!ready(for_sharp_)) return false;
    start_sharp();
    steps_.run_one();
  } else if (for_blurred_.valid()) {
    if (!ready(for_blurred_)) return false;
    start_blurred();
    left_ = plan_.blurs.size() + plan_.wide.size() + 1;
  } else if (!done_) {
    left_ = steps_.run_one();
    done_ = left_ == 0;
    if (done_ && key_) store_stack(device_, *key_, stack_);
  }
  return done_;
}

// Each step counts alike: the sharp level, what the host works out, and the others.
double Building::Builder::progress() const {
  const double all = static_cast<double>(plan_.blurs.size() + plan_.wide.size() + 3);
  if (done_) return 1.0;
  if (for_sharp_.valid()) return 0.0;
  if (for_blurred_.valid()) return 1.0 / all;
  return 1.0 - static_cast<double>(left_) / all;
}

Building::Building(gpu::Device& device, const Map& map)
    : builder_(std::make_unique<Builder>(device, map, true)) {}

Building::~Building() = default;

bool Building::advance() {
  return builder_->advance();
}

double Building::progress() const {
  return builder_->progress();
}

const Stack& Building::stack() const {
  return builder_->stack();
}

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
  Building::Builder builder(device, map, false);
  builder.build(times);
  return builder.stack();
}

Stack build_or_load(gpu::Device& device, const Map& map) {
  Building::Builder builder(device, map, true);
  builder.build(nullptr);
  return builder.stack();
}

std::size_t bytes_of(const Map& map) {
  const int face = face_of(fitted(map)), levels = even_level_count(face);
  return bytes(cube_desc("", face, levels)) + bytes(cube_desc("", face / 2, levels - 1))
         + bytes(cube_desc("", irradiance_face, 1));
}

} // namespace gg::environment
