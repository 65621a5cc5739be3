// Kernels of the angle alone, as tables that the device convolves with, and the balance of an equirectangular lattice.
#pragma once

#include <vector>

namespace gg::environment {

// Values at half chords i / (count - 1), i = 0 .. count - 1 (half chord = sin(angle / 2)), relative to the kernel's peak.

// The sphere's Gaussian: degree l times exp(-l(l+1) variance / 2). variance >= 0.01 rad².
std::vector<float> heat_kernel_table(double variance, int count);

// The clamped cosine over pi, for a map that was blurred by a Gaussian of that variance before: the series of the cosine
// [RamamoorthiHanrahan01, eq. 8] with the blur divided out, but for `kept_variance`, up to the degree where that
// amplifies `most` times. What is kept takes the ringing of a series that ends: 0.04 % of the light, for 0.002.
std::vector<float> cosine_kernel_table(double blurred_variance, double kept_variance, double most,
                                       int count);

// What a pixel of each row is worth when a Gaussian of `sigma` radians reads an equirectangular picture: its solid angle times
// a factor near 1 that makes the weights which it has in all readings, each normalised to 1, add up to its solid angle.
// Only rows near the poles need it, where pixels are slivers: without, a sun in the first row would lose a fifth.
std::vector<float> balanced_rows(int width, int height, double sigma, double reach);

} // namespace gg::environment
