// How wrong a picture is, measured against a reference, and how much of that is the reference's own
// noise.
#pragma once

#include "image/image.h"

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace gg::image {

// A picture with what a truth file says beside it.
struct Picture {
  std::string name;
  Image colour; // linear, three channels or more, finite
  // Three channels: the standard error of each value (channels stderr.R, .G, .B).
  std::optional<Image> standard_error;
  // Per pixel, empty if the file has none: the object seen there, 1 and up, 0 for none (channel
  // "id"); and the fraction of the pixel that it covers (channel "coverage").
  std::vector<float> id, coverage;
  std::map<int, std::string> object_names; // from attributes "object.1" and so on
  bool display_referred = false;           // decoded from 8 bits: clipped at 1 and in steps
};

// Reads any format that image::read knows. Throws Error(input), also if a value is not finite.
Picture load_picture(const std::filesystem::path& path);

// What the noise of the pictures adds to the errors, from their standard errors: to first order, as
// the noise of r in relMSE's denominator is left out.
struct Noise {
  double relmse = 0.0, relmse_trimmed = 0.0, rmse = 0.0; // the part of them that noise explains
  double bias = 0.0;                                     // its standard error
  double pixels_within = 0.0; // fraction of pixels whose difference is no larger than their noise
  bool of_reference = false, of_test = false; // whose standard errors are counted
};

// Over a set of pixels and R, G, B; x is the test, r the reference.
struct Errors {
  std::size_t pixels = 0;
  // Linear light.
  double relmse = 0.0;         // mean of (x - r)^2 / (r^2 + 0.01)
  double relmse_trimmed = 0.0; // the same without the 1 % of pixels (rounded down) where it is most
  double rmse = 0.0;           // square root of the mean of (x - r)^2
  double bias = 0.0;           // mean of x - r
  double reference_mean = 0.0; // mean of r
  double p99 = 0.0;            // 99 % of all |x - r| are no larger
  // As displayed: clamped to 0..1 and sRGB-encoded.
  double psnr = 0.0; // dB against a peak of 1; infinite for equal pictures
  double flip = 0.0; // mean LDR-FLIP at 67 pixels per degree
  std::optional<Noise> noise;
};

// True if more than half of the squared relative error is noise: then the pictures do not tell how
// good the test is, only that it is not worse than this.
bool noise_dominates(const Errors& errors);

// True if the worst 1 % of the pixels carry more than half of relMSE: then it tells of them (a lamp
// where the reference has none), and relmse_trimmed of the picture.
bool outliers_dominate(const Errors& errors);

struct Comparison {
  Errors frame;
  // Pixels wholly covered by objects, all and each. Wholly covered is: coverage 1; without that
  // channel, the pixel and its eight neighbours show objects (the same one, for each).
  std::optional<Errors> objects;
  std::map<int, Errors> by_object;
  Image flip_map;     // one channel, 0..1
  Image relative_map; // one channel: square root of the pixel's mean of (x - r)^2 / (r^2 + 0.01)
};

// Objects come from the reference, else from the test. `only`: if not empty, `objects` and
// `by_object` are about these ids alone. Throws Error(input) if the sizes differ, Error(usage) if
// an id of `only` covers no pixel.
Comparison compare(const Picture& test, const Picture& reference,
                   const std::vector<int>& only = {});

} // namespace gg::image
