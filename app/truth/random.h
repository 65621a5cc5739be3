// Random numbers that depend on what they are for and on nothing else: the generator of a sample
// is seeded by (seed, pixel, sample), so a picture is the same whatever the number of threads, and
// a render that is resumed draws what it would have drawn.
//
// The first numbers of a pixel's samples (where in the pixel, which light, which facet) are stratified:
// the samples come in batches, and those of one batch are points of a (0,2)-sequence, scrambled for each
// batch and each pair of numbers. Each number of each sample is uniform, so that nothing is biased;
// batches are independent, so that their scatter says how wrong their mean is.
#pragma once

#include <glm/vec2.hpp>

#include <algorithm>
#include <bit>
#include <cstdint>

namespace gg::truth {

// The batch of sample k of a pixel: small at first, so that there are several from the beginning; about twice the
// root of the samples.
struct Batch {
  long first = 0, size = 1; // size: a power of two
};

constexpr Batch batch_of(long k) {
  if (k < 4) return {k, 1};
  if (k < 64) return {k & ~3L, 4};
  if (k < 1024) return {k & ~15L, 16};
  return {k & ~63L, 64};
}

// How many batches n samples are, the last one maybe not complete.
constexpr long batches_of(long n) {
  const auto parts = [](long samples, long size) { return (samples + size - 1) / size; };
  if (n <= 4) return n;
  if (n <= 64) return 4 + parts(n - 4, 4);
  if (n <= 1024) return 19 + parts(n - 64, 16);
  return 79 + parts(n - 1024, 64);
}

// xoroshiro128++ [BlackmanVigna21], its state filled by splitmix64 as its authors advise.
class Random {
public:
  Random(std::uint64_t seed, std::uint64_t pixel, std::uint64_t sample) {
    std::uint64_t state = mix(mix(mix(seed) + pixel) + sample);
    a_ = mix(state += golden);
    b_ = mix(state += golden);
    if ((a_ | b_) == 0) a_ = golden; // the one state that xoroshiro cannot leave
  }

  // Of a pixel's sample: its first numbers are stratified with those of its batch.
  static Random stratified(std::uint64_t seed, std::uint64_t pixel, long sample) {
    Random random(seed, pixel, static_cast<std::uint64_t>(sample));
    const Batch batch = batch_of(sample);
    random.batch_ = mix(mix(mix(~seed) + pixel) + static_cast<std::uint64_t>(batch.first));
    random.point_ = static_cast<std::uint32_t>(sample - batch.first);
    random.left_ = stratified_numbers;
    return random;
  }

  // [0, 1), 53 bits.
  double uniform() {
    const double independent = static_cast<double>(next() >> 11) * 0x1p-53;
    return left_ == 0 ? independent : stratum(independent);
  }
  glm::dvec2 uniform2() {
    const double x = uniform();
    return {x, uniform()};
  }

private:
  static constexpr std::uint64_t golden = 0x9e3779b97f4a7c15u;
  // A position, two lights, a facet and two decisions: what the first surface asks for.
  static constexpr int stratified_numbers = 16;

  // The finaliser of splitmix64: a bijection in which every bit depends on every bit.
  static std::uint64_t mix(std::uint64_t x) {
    x += golden;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
  }

  static std::uint32_t reversed(std::uint32_t x) {
    x = (x >> 16) | (x << 16);
    x = ((x & 0x00ff00ffu) << 8) | ((x & 0xff00ff00u) >> 8);
    x = ((x & 0x0f0f0f0fu) << 4) | ((x & 0xf0f0f0f0u) >> 4);
    x = ((x & 0x33333333u) << 2) | ((x & 0xccccccccu) >> 2);
    return ((x & 0x55555555u) << 1) | ((x & 0xaaaaaaaau) >> 1);
  }

  // Owen's nested scrambling of bits, by the hash of [LaineKarras11] in the form of [Burley20].
  static std::uint32_t scrambled(std::uint32_t x, std::uint32_t seed) {
    x = reversed(x) + seed;
    x ^= x * 0x6c50b47cu;
    x ^= x * 0xb82f1e52u;
    x ^= x * 0xc7afe638u;
    x ^= x * 0x8d22f6e6u;
    return reversed(x);
  }

  // The next coordinate: the two of a pair are the first two of Sobol's at one point, in an order of
  // the points that each pair has for itself. What 32 bits leave open is filled by `within`, in [0, 1).
  double stratum(double within) {
    const int number = stratified_numbers - left_--;
    const std::uint64_t pair = mix(batch_ + static_cast<std::uint64_t>(number / 2));
    const std::uint32_t index = scrambled(point_, static_cast<std::uint32_t>(pair));
    std::uint32_t x = 0;
    if (number % 2 == 0) {
      x = reversed(index);
    } else {
      std::uint32_t column = 0x80000000u;
      for (std::uint32_t bits = index; bits != 0; bits >>= 1, column ^= column >> 1)
        if (bits & 1u) x ^= column;
    }
    const std::uint64_t own = mix(pair + static_cast<std::uint64_t>(number % 2 + 1));
    const double value =
        (static_cast<double>(scrambled(x, static_cast<std::uint32_t>(own))) + within) * 0x1p-32;
    return std::min(value, 1.0 - 0x1p-53);
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

  std::uint64_t a_, b_, batch_ = 0;
  std::uint32_t point_ = 0;
  int left_ = 0; // of the stratified numbers
};

} // namespace gg::truth
