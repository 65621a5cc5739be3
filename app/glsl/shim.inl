// The built-in functions of GLSL that snippets may call, for one precision. Included inside a namespace that has already
// said what Real is; deliberately without include guard, as it is included once per precision.
//
// GLM supplies the vectors and their operators and nothing else: its functions are templates that also take integers and
// swizzles, and `using namespace glm` beside <cmath> is ambiguous. These take Real and vectors of Real, so a double
// that strays into single precision shows as a warning.
using vec2 = glm::vec<2, Real>;
using vec3 = glm::vec<3, Real>;
using vec4 = glm::vec<4, Real>;
using ivec2 = glm::vec<2, int>;
using ivec3 = glm::vec<3, int>;
using mat2 = glm::mat<2, 2, Real>;
using mat3 = glm::mat<3, 3, Real>;
using mat4 = glm::mat<4, 4, Real>;
using uint = unsigned int;
// What <cmath> computes in: Real itself, or float where Real is a class (half precision in the tests).
using Wide = std::conditional_t<std::is_floating_point_v<Real>, Real, float>;

// One argument, component by component. GG_STD takes the function from <cmath>.
#define GG_EACH(name)                                                                              \
  template <glm::length_t N>                                                                       \
  inline glm::vec<N, Real> name(const glm::vec<N, Real>& v) {                                      \
    glm::vec<N, Real> r;                                                                           \
    for (glm::length_t i = 0; i < N; ++i) r[i] = name(v[i]);                                       \
    return r;                                                                                      \
  }
#define GG_STD(name)                                                                               \
  inline Real name(Real x) { return Real(std::name(Wide(x))); }                                    \
  GG_EACH(name)
#define GG_OWN(name, expression)                                                                   \
  inline Real name(Real x) { return Real(expression); }                                            \
  GG_EACH(name)
GG_STD(sin)
GG_STD(cos)
GG_STD(tan)
GG_STD(asin)
GG_STD(acos)
GG_STD(atan)
GG_STD(sinh)
GG_STD(cosh)
GG_STD(tanh)
GG_STD(exp)
GG_STD(exp2)
GG_STD(log)
GG_STD(log2)
GG_STD(sqrt)
GG_STD(floor)
GG_STD(ceil)
GG_STD(trunc)
GG_STD(round)
GG_OWN(inversesqrt, Real(1) / sqrt(x))
GG_OWN(radians, x * Real(0.017453292519943295769))
GG_OWN(degrees, x * Real(57.295779513082320877))
GG_OWN(abs, x < Real(0) ? -x : x)
GG_OWN(sign, x > Real(0) ? Real(1) : (x < Real(0) ? Real(-1) : Real(0)))
GG_OWN(fract, x - floor(x))
#undef GG_OWN
#undef GG_STD
#undef GG_EACH

inline Real real_pow(Real x, Real y) { return Real(std::pow(Wide(x), Wide(y))); }
inline Real real_atan2(Real y, Real x) { return Real(std::atan2(Wide(y), Wide(x))); }

// Two arguments, the second also as one scalar for all components.
#define GG_BINARY(name, expression)                                                                \
  inline Real name(Real x, Real y) { return Real(expression); }                                    \
  template <glm::length_t N>                                                                       \
  inline glm::vec<N, Real> name(const glm::vec<N, Real>& a, const glm::vec<N, Real>& b) {          \
    glm::vec<N, Real> r;                                                                           \
    for (glm::length_t i = 0; i < N; ++i) r[i] = name(a[i], b[i]);                                 \
    return r;                                                                                      \
  }                                                                                                \
  template <glm::length_t N>                                                                       \
  inline glm::vec<N, Real> name(const glm::vec<N, Real>& a, Real b) {                              \
    return name(a, glm::vec<N, Real>(b));                                                          \
  }
GG_BINARY(min, y < x ? y : x)
GG_BINARY(max, x < y ? y : x)
GG_BINARY(mod, x - y * floor(x / y))
GG_BINARY(pow, real_pow(x, y))
GG_BINARY(atan, real_atan2(x, y))
#undef GG_BINARY

inline int abs(int x) { return x < 0 ? -x : x; }
inline int min(int x, int y) { return y < x ? y : x; }
inline int max(int x, int y) { return x < y ? y : x; }
inline int clamp(int x, int low, int high) { return min(max(x, low), high); }

inline Real clamp(Real x, Real low, Real high) { return min(max(x, low), high); }
inline Real mix(Real a, Real b, Real t) { return a * (Real(1) - t) + b * t; }
inline Real step(Real edge, Real x) { return x < edge ? Real(0) : Real(1); }
inline Real smoothstep(Real a, Real b, Real x) {
  const Real t = clamp((x - a) / (b - a), Real(0), Real(1));
  return t * t * (Real(3) - Real(2) * t);
}
template <glm::length_t N>
inline glm::vec<N, Real> clamp(const glm::vec<N, Real>& v, Real low, Real high) {
  return min(max(v, low), high);
}
template <glm::length_t N>
inline glm::vec<N, Real> clamp(const glm::vec<N, Real>& v, const glm::vec<N, Real>& low,
                               const glm::vec<N, Real>& high) {
  return min(max(v, low), high);
}
template <glm::length_t N>
inline glm::vec<N, Real> mix(const glm::vec<N, Real>& a, const glm::vec<N, Real>& b, Real t) {
  return a * (Real(1) - t) + b * t;
}
template <glm::length_t N>
inline glm::vec<N, Real> mix(const glm::vec<N, Real>& a, const glm::vec<N, Real>& b,
                             const glm::vec<N, Real>& t) {
  return a * (glm::vec<N, Real>(Real(1)) - t) + b * t;
}

template <glm::length_t N>
inline Real dot(const glm::vec<N, Real>& a, const glm::vec<N, Real>& b) {
  Real sum = a[0] * b[0];
  for (glm::length_t i = 1; i < N; ++i) sum = sum + a[i] * b[i];
  return sum;
}
inline vec3 cross(const vec3& a, const vec3& b) {
  return vec3(a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y);
}
template <glm::length_t N>
inline Real length(const glm::vec<N, Real>& v) {
  return sqrt(dot(v, v));
}
template <glm::length_t N>
inline Real distance(const glm::vec<N, Real>& a, const glm::vec<N, Real>& b) {
  return length(a - b);
}
template <glm::length_t N>
inline glm::vec<N, Real> normalize(const glm::vec<N, Real>& v) {
  return v * inversesqrt(dot(v, v));
}
template <glm::length_t N>
inline glm::vec<N, Real> reflect(const glm::vec<N, Real>& v, const glm::vec<N, Real>& n) {
  return v - n * (Real(2) * dot(n, v));
}

inline bool isnan(Real x) { return x != x; }
inline bool isinf(Real x) { return !isnan(x) && isnan(x - x); }
