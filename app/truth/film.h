// The picture while it is being made: per pixel the sums from which mean and standard error follow.
#pragma once

#include "image/image.h"
#include "truth/sample.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <filesystem>
#include <vector>

namespace gg::truth {

struct Pixel {
  glm::dvec3 sum{0.0};          // of the samples' radiance
  glm::dvec3 squares{0.0};      // of the complete batches' sums, over their samples
  glm::dvec3 batch{0.0};        // sum of the batch that is not complete
  double clamped = 0.0;         // sum of Sample::clamped
  std::int32_t object = unseen; // 1 + instance that every sample met first; 0: none, or several
  static constexpr std::int32_t unseen = -1;

  // Of sample k.
  void add(long k, const Sample& sample);
};

// Every pixel has the same number of samples. Batches of them are independent (random.h), so their
// scatter about the mean says what the variance of the mean is.
class Film {
public:
  Film(int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }
  Pixel& at(int x, int y) { return pixels_[index(x, y)]; }
  const Pixel& at(int x, int y) const { return pixels_[index(x, y)]; }
  long samples() const { return samples_; }
  void add_samples(long count) { samples_ += count; }

  glm::dvec3 mean(const Pixel& pixel) const;
  // Of the mean; 0 with fewer than two batches, which say nothing.
  glm::dvec3 standard_error(const Pixel& pixel) const;
  // Root of the mean, over the pixels that objects cover wholly and over RGB, of
  // (standard error / (|mean| + 0.1))²; over all pixels if objects cover none.
  double relative_error() const;

  // What clamping took: over what there would be without it, of all pixels. The bias of the mean.
  double clamped_share() const;

  // The means, RGB.
  image::Image to_image() const;
  // Channels R G B, stderr.R stderr.G stderr.B, id, and coverage: 1 where an id is, as that is
  // only given to pixels that are covered wholly. Attributes spp, meanStandardError (over pixels
  // and RGB) and relativeError. With these, from_exr() recovers the sums to float32's rounding. Where
  // a batch is not complete, batch.R batch.G batch.B hold its sum; where anything was clamped, `clamped`
  // holds the mean that it took (of RGB).
  image::Exr to_exr() const;
  // Throws Error(input) naming `path` if the channels or the number of samples are not there.
  static Film from_exr(const image::Exr& exr, const std::filesystem::path& path);

private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_)
           + static_cast<std::size_t>(x);
  }
  int width_, height_;
  long samples_ = 0;
  std::vector<Pixel> pixels_;
};

} // namespace gg::truth
