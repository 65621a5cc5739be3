#include "tables/training_maps.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace gg::tables {
namespace {

using glm::vec3;

// Bits from bits (Steele, Lea and Flood's SplitMix64 finaliser): random numbers that are the same on every machine.
std::uint64_t scramble(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

class Random {
public:
  explicit Random(std::uint64_t seed) : state_(scramble(seed)) {}
  float unit() {
    state_ = scramble(state_);
    return static_cast<float>(static_cast<double>(state_ >> 11) * 0x1p-53);
  }
  float between(float low, float high) { return low + (high - low) * unit(); }
  float log_between(float low, float high) { return low * std::pow(high / low, unit()); }
  vec3 direction() {
    const float z = between(-1.0f, 1.0f), phi = between(0.0f, 6.28318531f),
                r = std::sqrt(1.0f - z * z);
    return {r * std::cos(phi), z, r * std::sin(phi)};
  }

private:
  std::uint64_t state_;
};

// Value noise on the integer lattice, smoothly interpolated, in [-1, 1].
float value_noise(const vec3& p, std::uint64_t seed) {
  const vec3 cell = glm::floor(p);
  const vec3 f = p - cell, s = f * f * (3.0f - 2.0f * f);
  float sum = 0.0f;
  for (int k = 0; k < 8; ++k) {
    const int dx = k & 1, dy = (k >> 1) & 1, dz = k >> 2;
    const auto key = [&](float c, int d) {
      return static_cast<std::uint64_t>(static_cast<std::int64_t>(c) + d + 4096);
    };
    const std::uint64_t bits =
        scramble(seed ^ (key(cell.x, dx) << 42) ^ (key(cell.y, dy) << 21) ^ key(cell.z, dz));
    const float value = static_cast<float>(static_cast<double>(bits >> 11) * 0x1p-52 - 1.0);
    sum += value * (dx ? s.x : 1 - s.x) * (dy ? s.y : 1 - s.y) * (dz ? s.z : 1 - s.z);
  }
  return sum;
}

// 1/f noise: octaves at half the amplitude (times `roughness`) and twice the frequency.
float clouds(const vec3& d, std::uint64_t seed, float frequency = 1.5f, float roughness = 1.2f) {
  float sum = 0.0f, amplitude = 1.0f;
  for (int octave = 0; octave < 7; ++octave) {
    sum += amplitude
           * value_noise(d * frequency + 7.1f * static_cast<float>(octave),
                         seed + static_cast<std::uint64_t>(octave));
    amplitude *= 0.5f * roughness;
    frequency *= 2.0f;
  }
  return sum;
}

struct Patch { // a rectangle of light: |tangent coordinates| below its half sizes
  vec3 axis, right, up;
  float width, height, radiance;
};

std::vector<Patch> patches(Random& random, int count, float small, float large, float dim,
                           float bright) {
  std::vector<Patch> list;
  for (int i = 0; i < count; ++i) {
    Patch p;
    p.axis = random.direction();
    const vec3 side = std::abs(p.axis.y) < 0.9f ? vec3(0, 1, 0) : vec3(1, 0, 0);
    p.right = glm::normalize(glm::cross(side, p.axis));
    p.up = glm::cross(p.axis, p.right);
    p.width = random.log_between(small, large);
    p.height = random.log_between(small, large);
    p.radiance = random.log_between(dim, bright);
    list.push_back(p);
  }
  return list;
}

float light_of(const std::vector<Patch>& list, const vec3& d) {
  float sum = 0.0f;
  for (const Patch& p : list) {
    const float z = glm::dot(d, p.axis);
    if (z > 0.0f && std::abs(glm::dot(d, p.right)) < p.width * z
        && std::abs(glm::dot(d, p.up)) < p.height * z)
      sum += p.radiance;
  }
  return sum;
}

using Radiance = std::function<float(const vec3&)>;

Radiance sky(Random random, std::uint64_t seed) {
  const vec3 sun =
      glm::normalize(random.direction() * vec3(1, 0, 1) + vec3(0, random.between(0.1f, 1.2f), 0));
  const float cos_disc = std::cos(random.between(0.01f, 0.03f)),
              brightness = random.log_between(100.0f, 3000.0f);
  return [=](const vec3& d) {
    const float c = glm::dot(d, sun);
    const float glow = 3.0f * std::exp(-8.0f * (1.0f - c)) + (c > cos_disc ? brightness : 0.0f);
    if (d.y < 0.0f) return 0.25f * std::exp(0.6f * clouds(d, seed, 4.0f));
    return 1.0f + 1.5f * std::exp(-4.0f * d.y) + glow
           + std::max(0.0f, 1.5f * clouds(d, seed, 2.0f));
  };
}

Radiance windows(Random random, std::uint64_t seed) {
  const auto panes = patches(random, 7, 0.08f, 0.35f, 8.0f, 60.0f);
  return [=](const vec3& d) {
    float light = 0.0f;
    for (const Patch& p : panes) {
      const float z = glm::dot(d, p.axis);
      if (z <= 0.0f) continue;
      const float x = glm::dot(d, p.right) / z / p.width, y = glm::dot(d, p.up) / z / p.height;
      const auto bar = [](float t) { return std::abs(t - std::round(t)) < 0.06f; };
      if (std::abs(x) < 1.0f && std::abs(y) < 1.0f && !bar(1.5f * x) && !bar(1.5f * y))
        light += p.radiance;
    }
    return light + 0.4f * std::exp(0.8f * clouds(d, seed, 3.0f));
  };
}

Radiance stripes(Random random, std::uint64_t seed) {
  const vec3 axis = random.direction();
  const float count = random.between(3.0f, 9.0f), contrast = random.log_between(5.0f, 50.0f);
  return [=](const vec3& d) {
    const bool lit = std::sin(count * 3.0f * glm::dot(d, axis) + clouds(d, seed, 1.0f)) > 0.3f;
    return lit ? contrast : 1.0f;
  };
}

Radiance family(int which, std::uint64_t seed) {
  Random random(seed);
  switch (which) {
  case 0:
    return [=](const vec3& d) { return std::exp(1.6f * clouds(d, seed)); };
  case 1:
    return sky(random, seed);
  case 2: {
    const auto boxes = patches(random, 6, 0.1f, 0.6f, 4.0f, 120.0f);
    return [=](const vec3& d) { return 0.15f + 0.25f * std::max(0.0f, -d.y) + light_of(boxes, d); };
  }
  case 3: {
    const auto lamps = patches(random, 80, 0.01f, 0.05f, 1.0f, 100.0f);
    return
        [=](const vec3& d) { return 0.1f * std::exp(clouds(d, seed, 3.0f)) + light_of(lamps, d); };
  }
  case 4:
    return windows(random, seed);
  case 5:
    return stripes(random, seed);
  case 6: { // dark room: a few lamps, and next to nothing else
    const auto lamps = patches(random, 5, 0.05f, 0.4f, 2.0f, 200.0f);
    return
        [=](const vec3& d) { return 0.02f * std::exp(clouds(d, seed, 2.0f)) + light_of(lamps, d); };
  }
  case 7: // canopy: holes of sky between leaves
    return [=](const vec3& d) {
      const float leaves = clouds(d, seed, 4.0f, 1.5f);
      return d.y > -0.2f && leaves > 0.6f ? 12.0f : 0.3f * std::exp(0.7f * leaves);
    };
  default: // horizon: a bright band over a dark sea
    return [=](const vec3& d) {
      const float height = d.y + 0.05f * clouds(d, seed, 3.0f);
      return 0.1f + 20.0f * std::exp(-0.5f * std::pow(height / 0.06f, 2.0f))
             + (d.y > 0.0f ? 1.0f : 0.0f);
    };
  }
}

} // namespace

std::vector<TrainingMap> training_maps(int size, int draw) {
  static const char* const names[] = {"clouds",  "sky",       "studio", "night",  "windows",
                                      "stripes", "dark room", "canopy", "horizon"};
  const int count = draw >= held_out_draws[0] ? 9 : 7;
  std::vector<TrainingMap> maps;
  for (int i = 0; i < count; ++i) {
    const auto seed = static_cast<std::uint64_t>(1000 * draw + i + 1);
    maps.push_back({names[i], sample_sphere(size, family(i, seed))});
  }
  return maps;
}

} // namespace gg::tables
