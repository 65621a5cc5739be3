#include "truth/film.h"

#include "core/error.h"
#include "truth/random.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace gg::truth {
namespace {

constexpr const char* color_channels[3] = {"R", "G", "B"};
constexpr const char* error_channels[3] = {"stderr.R", "stderr.G", "stderr.B"};
constexpr const char* batch_channels[3] = {"batch.R", "batch.G", "batch.B"};

// Of the batch that is not complete; 0: all are.
long begun_of(long samples) {
  return samples > 0 ? samples % batch_of(samples).size : 0;
}

} // namespace

void Pixel::add(long k, const Sample& sample) {
  const std::int32_t met = sample.object;
  sum += sample.radiance;
  batch += sample.radiance;
  clamped += sample.clamped;
  if (const Batch whole = batch_of(k); k + 1 == whole.first + whole.size) {
    squares += batch * batch / static_cast<double>(whole.size);
    batch = glm::dvec3(0.0);
  }
  object = object == unseen || object == met ? met : 0;
}

Film::Film(int width, int height)
    : width_(width), height_(height),
      pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

glm::dvec3 Film::mean(const Pixel& pixel) const {
  return samples_ > 0 ? pixel.sum / static_cast<double>(samples_) : glm::dvec3(0.0);
}

glm::dvec3 Film::standard_error(const Pixel& pixel) const {
  const long batches = batches_of(samples_);
  if (batches < 2) return glm::dvec3(0.0);
  const double n = static_cast<double>(samples_);
  glm::dvec3 squares = pixel.squares;
  if (const long begun = begun_of(samples_))
    squares += pixel.batch * pixel.batch / static_cast<double>(begun);
  // Samples that are all alike may differ from their mean by rounding, either way.
  const glm::dvec3 scatter = glm::max(squares - pixel.sum * pixel.sum / n, glm::dvec3(0.0));
  return glm::sqrt(scatter / (n * static_cast<double>(batches - 1)));
}

double Film::relative_error() const {
  const auto over = [&](bool covered_only) {
    double sum = 0.0;
    long count = 0;
    for (const Pixel& pixel : pixels_) {
      if (covered_only && pixel.object <= 0) continue;
      const glm::dvec3 relative = standard_error(pixel) / (glm::abs(mean(pixel)) + 0.1);
      sum += glm::dot(relative, relative);
      count += 3;
    }
    return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : -1.0;
  };
  const double objects = over(true);
  return objects >= 0.0 ? objects : over(false);
}

double Film::clamped_share() const {
  double taken = 0.0, there = 0.0;
  for (const Pixel& pixel : pixels_) {
    taken += pixel.clamped;
    there += (pixel.sum.x + pixel.sum.y + pixel.sum.z) / 3.0;
  }
  return taken > 0.0 ? taken / (taken + there) : 0.0;
}

image::Image Film::to_image() const {
  image::Image picture(width_, height_, 3);
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    const glm::dvec3 value = mean(pixels_[i]);
    for (int c = 0; c < 3; ++c)
      picture.values[3 * i + static_cast<std::size_t>(c)] = static_cast<float>(value[c]);
  }
  return picture;
}

image::Exr Film::to_exr() const {
  image::Exr exr{.width = width_, .height = height_};
  for (const char* name : color_channels)
    exr.channels[name].reserve(pixels_.size());
  for (const char* name : error_channels)
    exr.channels[name].reserve(pixels_.size());
  const bool clamped = clamped_share() > 0.0;
  double errors = 0.0;
  for (const Pixel& pixel : pixels_) {
    if (clamped)
      exr.channels["clamped"].push_back(
          static_cast<float>(pixel.clamped / static_cast<double>(samples_)));
    const glm::dvec3 value = mean(pixel), error = standard_error(pixel);
    for (int c = 0; c < 3; ++c) {
      exr.channels[color_channels[c]].push_back(static_cast<float>(value[c]));
      exr.channels[error_channels[c]].push_back(static_cast<float>(error[c]));
      errors += error[c];
    }
    if (begun_of(samples_))
      for (int c = 0; c < 3; ++c)
        exr.channels[batch_channels[c]].push_back(static_cast<float>(pixel.batch[c]));
    exr.channels["id"].push_back(static_cast<float>(std::max(pixel.object, 0)));
    exr.channels["coverage"].push_back(pixel.object > 0 ? 1.0f : 0.0f);
  }
  exr.attributes["spp"] = std::to_string(samples_);
  exr.attributes["meanStandardError"] =
      fmt::format("{:.6g}", errors / (3.0 * static_cast<double>(pixels_.size())));
  exr.attributes["relativeError"] = fmt::format("{:.6g}", relative_error());
  if (clamped) exr.attributes["clampedShare"] = fmt::format("{:.6g}", clamped_share());
  return exr;
}

Film Film::from_exr(const image::Exr& exr, const std::filesystem::path& path) {
  long spp = 0;
  if (const auto found = exr.attributes.find("spp"); found != exr.attributes.end())
    std::from_chars(found->second.data(), found->second.data() + found->second.size(), spp);
  bool complete = spp >= 2 && exr.channels.contains("id");
  const long begun = begun_of(spp);
  for (int c = 0; c < 3; ++c)
    complete = complete && exr.channels.contains(color_channels[c])
               && exr.channels.contains(error_channels[c])
               && (begun == 0 || exr.channels.contains(batch_channels[c]));
  if (!complete)
    throw Error(ExitCode::input, path, "was not written by groundglass truth",
                "Leave --resume out to start again.");
  Film film(exr.width, exr.height);
  film.samples_ = spp;
  const double n = static_cast<double>(spp);
  const double freedom = static_cast<double>(std::max(batches_of(spp) - 1, 0L));
  for (std::size_t i = 0; i < film.pixels_.size(); ++i) {
    Pixel& pixel = film.pixels_[i];
    for (int c = 0; c < 3; ++c) {
      const double value = static_cast<double>(exr.channels.at(color_channels[c])[i]);
      const double error = static_cast<double>(exr.channels.at(error_channels[c])[i]);
      const double batch =
          begun > 0 ? static_cast<double>(exr.channels.at(batch_channels[c])[i]) : 0.0;
      if (!std::isfinite(value) || !std::isfinite(error) || !std::isfinite(batch))
        throw Error(ExitCode::input, path, "has values that are not finite",
                    "Leave --resume out to start again.");
      pixel.sum[c] = n * value;
      pixel.batch[c] = batch;
      pixel.squares[c] = n * value * value + n * freedom * error * error;
      if (begun > 0) pixel.squares[c] -= batch * batch / static_cast<double>(begun);
    }
    pixel.object = static_cast<std::int32_t>(exr.channels.at("id")[i]);
    if (const auto taken = exr.channels.find("clamped"); taken != exr.channels.end())
      pixel.clamped = n * static_cast<double>(taken->second[i]);
  }
  return film;
}

} // namespace gg::truth
