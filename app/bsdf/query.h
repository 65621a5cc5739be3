// One question to the microfacet BSDF and its answer, as `groundglass eval` asks it.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace gg::bsdf {

// The values are those that shaders/stages/eval.comp reads.
enum class Lobe : std::uint32_t { reflection = 0, transmission = 1 };
enum class Distribution : std::uint32_t { ggx = 0, beckmann = 1, phong = 2 };

// i, o, n and eta are Walter's: i is the known direction, eta = n_o / n_i. Directions point away
// from the surface and are unit to float32 precision; the answer is for their normalised selves.
struct Query {
  std::array<float, 3> i{}, o{}, n{};
  float alpha = 0.0f; // slope width; of Phong the exponent
  float eta = 1.0f;   // 0: a conductor of complex index cn + i ck, relative to i's side
  float cn = 0.0f, ck = 0.0f;
  Lobe lobe = Lobe::reflection;
  Distribution distribution = Distribution::ggx;
};

// What is asked for, in the order of the columns. D in 1/sr; f in 1/sr; pdfs in 1/sr of o.
inline constexpr std::array<std::string_view, 10> value_names = {
    "D", "G", "G2", "F", "omF", "f", "f_cos", "f_G2", "pdf_D", "pdf_vndf"};

template <class Real>
using Values = std::array<Real, value_names.size()>;

} // namespace gg::bsdf
