#include <groundglass/snippets.h>

#include <cmath>

int main() { // GGX at its peak is 1 / (pi alpha²), in both precisions
  const groundglass::f64::vec3 n(0.0, 0.0, 1.0);
  const groundglass::f32::vec3 m(0.0f, 0.0f, 1.0f);
  const double peak = groundglass::f64::ggxD(groundglass::f64::tilt(n), 0.5);
  const float single = groundglass::f32::ggxD(groundglass::f32::tilt(m), 0.5f);
  return std::fabs(peak - 4.0 / 3.14159265358979) < 1e-12 && std::fabs(single - peak) < 1e-6 ? 0
                                                                                             : 1;
}
