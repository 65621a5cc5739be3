#include "image/compare.h"

#include "core/error.h"
#include "image/flip.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <utility>

namespace gg::image {
namespace {

// In relMSE: keeps dark pixels from counting without limit (Rousselle et al. 2011 use the same).
constexpr double dark = 0.01;

using Mask = std::vector<bool>; // per pixel

double square(double v) {
  return v * v;
}

double value(const Image& image, std::size_t pixel, std::size_t channel) {
  return image.values[pixel * static_cast<std::size_t>(image.channels) + channel];
}

double displayed(double linear) {
  return srgb_from_linear(linear);
}

// Of a pixel: the mean over R, G and B of (x - r)^2 / (r^2 + 0.01).
double relative_square(const Image& test, const Image& reference, std::size_t pixel) {
  double sum = 0.0;
  for (std::size_t c = 0; c < 3; ++c) {
    const double r = value(reference, pixel, c);
    sum += square(value(test, pixel, c) - r) / (square(r) + dark);
  }
  return sum / 3.0;
}

double percentile(std::vector<float>& values, double fraction) {
  if (values.empty()) return 0.0;
  const double rank = std::ceil(fraction * static_cast<double>(values.size()));
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(std::max(rank, 1.0)) - 1;
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// The variance of x - r: of each picture whose standard error is known.
double variance(const Picture& test, const Picture& reference, std::size_t pixel, std::size_t c) {
  double v = 0.0;
  if (reference.standard_error) v += square(value(*reference.standard_error, pixel, c));
  if (test.standard_error) v += square(value(*test.standard_error, pixel, c));
  return v;
}

std::optional<Noise> noise_of(const Picture& test, const Picture& reference, const Mask& mask) {
  if (!test.standard_error && !reference.standard_error) return {};
  Noise noise{.of_reference = reference.standard_error.has_value(),
              .of_test = test.standard_error.has_value()};
  std::size_t pixels = 0, within = 0;
  double relative = 0.0, absolute = 0.0;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (!mask[i]) continue;
    ++pixels;
    double difference = 0.0, chance = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double r = value(reference.colour, i, c);
      const double v = variance(test, reference, i, c);
      relative += v / (square(r) + dark);
      chance += v;
      difference += square(value(test.colour, i, c) - r);
    }
    absolute += chance;
    within += difference <= chance;
  }
  const double values = 3.0 * static_cast<double>(pixels);
  noise.relmse = relative / values;
  noise.rmse = std::sqrt(absolute / values);
  noise.bias = std::sqrt(absolute) / values; // pixels are independent
  noise.pixels_within = static_cast<double>(within) / static_cast<double>(pixels);
  return noise;
}

// What pixels are wrong by, each, and all but the 1 % where it is largest.
struct Ranking {
  double all = 0.0, best = 0.0; // means of relative_square
  Mask kept;
};

Ranking ranking(const Picture& test, const Picture& reference, const Mask& mask) {
  Ranking result{.kept = mask};
  std::vector<std::pair<double, std::size_t>> pixels; // how wrong, and which
  for (std::size_t i = 0; i < mask.size(); ++i)
    if (mask[i]) pixels.emplace_back(relative_square(test.colour, reference.colour, i), i);
  const auto cut = pixels.begin() + static_cast<std::ptrdiff_t>(pixels.size() / 100);
  std::nth_element(pixels.begin(), cut, pixels.end(), std::greater{});
  for (auto worst = pixels.begin(); worst != cut; ++worst) {
    result.all += worst->first;
    result.kept[worst->second] = false;
  }
  for (auto pixel = cut; pixel != pixels.end(); ++pixel)
    result.best += pixel->first;
  result.all = (result.all + result.best) / static_cast<double>(pixels.size());
  result.best /= static_cast<double>(pixels.end() - cut);
  return result;
}

Errors errors_over(const Picture& test, const Picture& reference, const Image& flip_map,
                   const Mask& mask) {
  Errors errors;
  double absolute = 0.0, difference = 0.0, mean = 0.0, shown = 0.0, flips = 0.0;
  std::vector<float> distances;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (!mask[i]) continue;
    ++errors.pixels;
    flips += flip_map.values[i];
    for (std::size_t c = 0; c < 3; ++c) {
      const double x = value(test.colour, i, c), r = value(reference.colour, i, c);
      absolute += square(x - r);
      difference += x - r;
      mean += r;
      shown += square(displayed(x) - displayed(r));
      distances.push_back(static_cast<float>(std::abs(x - r)));
    }
  }
  if (errors.pixels == 0) return errors;
  const double values = 3.0 * static_cast<double>(errors.pixels);
  const Ranking ranked = ranking(test, reference, mask);
  errors.relmse = ranked.all;
  errors.relmse_trimmed = ranked.best;
  errors.rmse = std::sqrt(absolute / values);
  errors.bias = difference / values;
  errors.reference_mean = mean / values;
  errors.p99 = percentile(distances, 0.99);
  errors.psnr =
      shown > 0.0 ? 10.0 * std::log10(values / shown) : std::numeric_limits<double>::infinity();
  errors.flip = flips / static_cast<double>(errors.pixels);
  errors.noise = noise_of(test, reference, mask);
  if (errors.noise) errors.noise->relmse_trimmed = noise_of(test, reference, ranked.kept)->relmse;
  return errors;
}

// Whether the object of a pixel fills it; see Comparison.
class Cover {
public:
  Cover(const Picture& with_ids)
      : picture_(with_ids), width_(with_ids.colour.width), height_(with_ids.colour.height) {}

  int object(std::size_t pixel) const { return static_cast<int>(picture_.id[pixel]); }

  // Wholly covered by objects that `belongs` accepts.
  template <class Belongs>
  Mask mask(const Belongs& belongs) const {
    Mask result(picture_.id.size());
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x)
        result[index(x, y)] = covered(x, y, belongs);
    return result;
  }

private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_)
           + static_cast<std::size_t>(x);
  }

  template <class Belongs>
  bool covered(int x, int y, const Belongs& belongs) const {
    if (!belongs(object(index(x, y)))) return false;
    if (!picture_.coverage.empty()) {
      // Written as halves, what is within 1/4096 of 1 reads as 1: as good as whole.
      return picture_.coverage[index(x, y)] >= 1.0f;
    }
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, height_ - 1); ++v)
      for (int u = std::max(x - 1, 0); u <= std::min(x + 1, width_ - 1); ++u)
        if (!belongs(object(index(u, v)))) return false;
    return true;
  }

  const Picture& picture_;
  int width_, height_;
};

void add_objects(const Picture& test, const Picture& reference, const Picture& with_ids,
                 const std::vector<int>& only, Comparison& comparison) {
  const Cover cover(with_ids);
  std::set<int> ids;
  for (std::size_t i = 0; i < with_ids.id.size(); ++i)
    ids.insert(cover.object(i));
  ids.erase(0);
  for (const int id : only)
    if (!ids.contains(id))
      throw Error(ExitCode::usage, with_ids.name, "shows no object " + std::to_string(id),
                  ids.empty() ? "It shows no objects at all."
                              : "Its objects are " + std::to_string(*ids.begin()) + " to "
                                    + std::to_string(*ids.rbegin()) + ".");
  if (!only.empty()) ids = std::set<int>(only.begin(), only.end());
  const auto over = [&](const auto& belongs) {
    return errors_over(test, reference, comparison.flip_map, cover.mask(belongs));
  };
  comparison.objects = over([&](int id) { return ids.contains(id); });
  for (const int wanted : ids)
    comparison.by_object[wanted] = over([&](int id) { return id == wanted; });
}

Image relative_map(const Image& test, const Image& reference) {
  Image map(test.width, test.height, 1);
  for (std::size_t i = 0; i < map.values.size(); ++i)
    map.values[i] = static_cast<float>(std::sqrt(relative_square(test, reference, i)));
  return map;
}

} // namespace

bool noise_dominates(const Errors& errors) {
  return errors.noise && errors.noise->relmse > 0.0 && errors.noise->relmse > 0.5 * errors.relmse;
}

bool outliers_dominate(const Errors& errors) {
  // As a mean over all pixels, the 1 %-trimmed value.
  return 0.99 * errors.relmse_trimmed < 0.5 * errors.relmse;
}

Comparison compare(const Picture& test, const Picture& reference, const std::vector<int>& only) {
  const Image &x = test.colour, &r = reference.colour;
  if (x.width != r.width || x.height != r.height)
    throw Error(ExitCode::input, test.name,
                "is " + std::to_string(x.width) + " x " + std::to_string(x.height)
                    + " pixels, and the reference " + reference.name + " " + std::to_string(r.width)
                    + " x " + std::to_string(r.height),
                "Render both at one --size.");
  Comparison comparison;
  comparison.flip_map = flip(x, r);
  comparison.relative_map = relative_map(x, r);
  const Mask everything(comparison.flip_map.values.size(), true);
  comparison.frame = errors_over(test, reference, comparison.flip_map, everything);
  const Picture* const with_ids = !reference.id.empty() ? &reference
                                  : !test.id.empty()    ? &test
                                                        : nullptr;
  if (with_ids) {
    add_objects(test, reference, *with_ids, only, comparison);
  } else if (!only.empty()) {
    throw Error(ExitCode::usage, reference.name, "says nothing about objects",
                "Compare with an .exr that has a channel id, as truth writes it.");
  }
  return comparison;
}

} // namespace gg::image
