// Random numbers that depend on what they are for and on nothing else: the generator of a sample
// is seeded by (seed, pixel, sample), so a picture is the same whatever the number of threads, and
// a render that is resumed draws what it would have drawn.
#pragma once

#include <glm/vec2.hpp>

#include <bit>
#include <cstdint>

namespace gg::truth {

// xoroshiro128++ [BlackmanVigna21], its state filled by splitmix64 as its authors advise.
class Random {
public:
  Random(std::uint64_t seed, std::uint64_t pixel, std::uint64_t sample) {
    std::uint64_t state = mix(mix(mix(seed) + pixel) + sample);
    a_ = mix(state += golden);
    b_ = mix(state += golden);
    if ((a_ | b_) == 0) a_ = golden; // the one state that xoroshiro cannot leave
  }

  // [0, 1), 53 bits.
  double uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  glm::dvec2 uniform2() {
    const double x = uniform();
    return {x, uniform()};
  }

private:
  static constexpr std::uint64_t golden = 0x9e3779b97f4a7c15u;

  // The finaliser of splitmix64: a bijection in which every bit depends on every bit.
  static std::uint64_t mix(std::uint64_t x) {
    x += golden;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
  }

  std::uint64_t next() {
    const std::uint64_t a = a_;
    std::uint64_t b = b_;
    const std::uint64_t result = std::rotl(a + b, 17) + a;
    b ^= a;
    a_ = std::rotl(a, 49) ^ b ^ (b << 21);
    b_ = std::rotl(b, 28);
    return result;
  }

  std::uint64_t a_, b_;
};

} // namespace gg::truth
