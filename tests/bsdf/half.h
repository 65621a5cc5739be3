// A number of half precision, as a mediump variable is on hardware that takes the word seriously:
// IEEE binary16, every operation rounded to nearest even. Built on float, which holds sums and
// products of halves with digits to spare.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace gg::bsdf_test {

// x rounded to 11 significant bits, with halves' subnormals below 2^-14 and infinity from 65520 on.
inline float round_to_half(float x) {
  const float magnitude = std::abs(x);
  if (!(magnitude > 0) || std::isinf(x)) return x;
  if (magnitude >= 65520.0F) return std::copysign(INFINITY, x);
  // Adding and taking away 2^13 times the number's own power of two leaves 11 bits; below 2^-14 the
  // step stays 2^-24.
  const int exponent = std::max(std::ilogb(magnitude), -14);
  const float step = std::ldexp(1.0F, exponent - 10);
  return std::copysign(std::nearbyint(magnitude / step) * step, x);
}

class Half {
public:
  Half() = default;
  Half(double x) : value_(round_to_half(static_cast<float>(x))) {}
  explicit operator double() const { return static_cast<double>(value_); }
  explicit operator float() const { return value_; }
  explicit operator int() const { return static_cast<int>(value_); }

  friend Half operator+(Half a, Half b) { return of(a.value_ + b.value_); }
  friend Half operator-(Half a, Half b) { return of(a.value_ - b.value_); }
  friend Half operator*(Half a, Half b) { return of(a.value_ * b.value_); }
  friend Half operator/(Half a, Half b) { return of(a.value_ / b.value_); }
  friend Half operator-(Half a) { return of(-a.value_); }
  Half& operator+=(Half b) { return *this = *this + b; }
  Half& operator-=(Half b) { return *this = *this - b; }
  Half& operator*=(Half b) { return *this = *this * b; }
  Half& operator/=(Half b) { return *this = *this / b; }
  friend bool operator==(Half a, Half b) { return a.value_ == b.value_; }
  friend auto operator<=>(Half a, Half b) { return a.value_ <=> b.value_; }

private:
  static Half of(float x) {
    Half h;
    h.value_ = round_to_half(x);
    return h;
  }
  float value_; // not initialised, like the built-in types: GLM's vectors are unions of their
                // components
};

} // namespace gg::bsdf_test
