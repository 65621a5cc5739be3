// An environment as a picture: equirectangular radiance, checked and mended. No GPU types.
#pragma once

#include <glm/vec3.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace gg::environment {

// Row 0 is +Y. Direction to texture: u = atan2(z, x) / 2π + 1/2, v = acos(y) / π. Linear Rec.709 radiance, interleaved
// RGB, finite and not negative.
struct Map {
  std::string name; // for messages and labels
  int width = 0, height = 0;
  std::vector<float> rgb; // 3 * width * height

  glm::vec3 at(int x, int y) const {
    const std::size_t i = 3
                          * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width)
                             + static_cast<std::size_t>(x));
    return {rgb[i], rgb[i + 1], rgb[i + 2]};
  }
};

// Reads .hdr, .exr or any other picture that image::read knows. Pixels that are NaN, infinite or negative are mended and
// counted in one note. Throws Error(input) if the file cannot be read, or is not twice as wide as high (a hundredth off is
// taken with a note; a single pixel counts as a constant).
Map load(const std::filesystem::path& path);

// Whether a file of this name is a radiance map: .hdr or .exr.
bool is_map_file(const std::filesystem::path& path);

// The same radiance from everywhere. Components below 0 or not finite count as 0.
Map constant(const glm::vec3& radiance);

// Replaces what is not a radiance: a NaN or infinite channel by the mean of that channel over the pixel's neighbours (wrapped
// around in x) that are finite and not negative, 0 if there are none; a negative one by 0. Returns how many pixels
// were mended. `rgb` holds 3 * width * height values.
std::size_t mend(std::vector<float>& rgb, int width, int height);

// The mean over the sphere, weighted by solid angle.
glm::dvec3 mean_radiance(const Map& map);

// Of a size between the limits, twice as wide as high, with the same mean: small maps have their pixels repeated, large
// ones averaged over the sphere. Any width and height; greatest_width is at least 2 and even.
Map fitted_between(const Map& map, int least_height, int greatest_width);

// Solid angle of one pixel of row y, sr: exact.
double pixel_solid_angle(int width, int height, int y);

} // namespace gg::environment
