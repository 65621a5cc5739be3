// Small pictures that every test of formats uses.
#pragma once

#include "image/image.h"

#include <cmath>
#include <random>

namespace gg::test {

// Random, asymmetric, from 2^-48 to 2^15; the same for the same size.
inline image::Image noise(int width, int height, int channels) {
  image::Image image(width, height, channels);
  std::mt19937 random(1234u);
  for (float& v : image.values) {
    const auto bits = static_cast<unsigned>(random());
    v = std::ldexp(static_cast<float>(bits >> 8), static_cast<int>(bits % 40) - 48);
  }
  return image;
}

// What an 8-bit file holds exactly.
inline image::Image steps(int width, int height, int channels) {
  image::Image image(width, height, channels);
  for (std::size_t i = 0; i < image.values.size(); ++i)
    image.values[i] = static_cast<float>(i * 37 % 256) / 255.0f;
  return image;
}

} // namespace gg::test
