#include "scene/gltf/animation.h"

#include "scene/gltf/accessors.h"
#include "scene/gltf/fail.h"

#include <fmt/format.h>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace gg::scene::gltf {
namespace {

using nlohmann::json;

std::string name_of(const json& animation) {
  const auto name = animation.is_object() ? animation.find("name") : animation.end();
  return animation.is_object() && name != animation.end() && name->is_string()
             ? name->get<std::string>()
             : std::string();
}

std::string listing(const std::vector<json>& animations) {
  if (animations.empty()) return "Leave --time and --animation out: it is shown as it stands.";
  constexpr std::size_t most = 24;
  std::string text = "The file has:";
  for (std::size_t i = 0; i < std::min(most, animations.size()); ++i) {
    const std::string name = name_of(animations[i]);
    text += fmt::format("{} {} ({})", i ? "," : "", i, name.empty() ? "unnamed" : name);
  }
  return text
         + (animations.size() > most ? fmt::format(" and {} more.", animations.size() - most)
                                     : ".");
}

std::size_t chosen(const Document& document, const std::string& wanted) {
  const std::vector<json> animations = document.animations();
  if (animations.empty())
    throw Error(ExitCode::usage, document.name(), "has no animations", listing(animations));
  if (wanted.empty()) {
    if (animations.size() > 1)
      note(fmt::format("{}: has {} animations; the first is taken. {}", document.name(),
                       animations.size(), listing(animations)));
    return 0;
  }
  for (std::size_t i = 0; i < animations.size(); ++i)
    if (name_of(animations[i]) == wanted) return i;
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), index);
  if (error == std::errc() && end == wanted.data() + wanted.size() && index < animations.size())
    return index;
  throw Error(ExitCode::usage, document.name(), "has no animation '" + wanted.substr(0, 60) + "'",
              listing(animations));
}

// The keys of a sampler.
struct Keys {
  std::vector<float> times; // seconds, not decreasing
  std::vector<float>
      values; // `width` numbers per key; of a cubic spline three times: in-tangent, value, out-tangent
  std::size_t width = 0;
  enum class Interpolation { step, linear, cubic } interpolation = Interpolation::linear;
};

// `width` 0: as many numbers per key as there are.
Keys read_keys(Document& document, const json& sampler, std::size_t width,
               const std::string& place) {
  Keys keys;
  const std::string how = sampler.value("interpolation", "LINEAR");
  keys.interpolation = how == "STEP"     ? Keys::Interpolation::step
                       : how == "LINEAR" ? Keys::Interpolation::linear
                                         : Keys::Interpolation::cubic;
  keys.times = read_floats(document, sampler["input"].get<int>());
  keys.values = read_floats(document, sampler["output"].get<int>());
  if (keys.times.empty()) fail(document.name(), place + ".input", "has no keys");
  if (!std::ranges::is_sorted(keys.times))
    fail(document.name(), place + ".input", "has times that go back");
  const std::size_t runs =
      keys.times.size() * (keys.interpolation == Keys::Interpolation::cubic ? 3 : 1);
  keys.width = keys.values.size() / runs;
  if (keys.width == 0 || keys.width * runs != keys.values.size()
      || (width != 0 && keys.width != width))
    fail(document.name(), place + ".output",
         fmt::format("has {} numbers for {} keys{}", keys.values.size(), keys.times.size(),
                     width ? fmt::format(" of {}", width * runs / keys.times.size()) : ""));
  return keys;
}

// A quaternion x, y, z, w between two others, along the shorter arc (glTF 2.0 appendix C.4).
void interpolate_rotation(const float* a, const float* b, double t, double* result) {
  const glm::dquat from(a[3], a[0], a[1], a[2]), to(b[3], b[0], b[1], b[2]);
  const glm::dquat q = glm::slerp(glm::normalize(from), glm::normalize(to), t);
  result[0] = q.x, result[1] = q.y, result[2] = q.z, result[3] = q.w;
}

// The values at a time; appendix C.
std::vector<double> value_at(const Keys& keys, double time, bool is_rotation) {
  const std::size_t count = keys.times.size(), width = keys.width;
  const bool cubic = keys.interpolation == Keys::Interpolation::cubic;
  const auto at = [&](std::size_t key, std::size_t part) {
    return keys.values.data() + (cubic ? 3 * key + part : key) * width;
  };
  const auto after = std::ranges::upper_bound(keys.times, static_cast<float>(time));
  const auto next = static_cast<std::size_t>(after - keys.times.begin());
  const std::size_t before = next == 0 ? 0 : next - 1;
  const float* a = at(before, 1);
  std::vector<double> result(a, a + width);
  if (next == 0 || next == count || keys.interpolation == Keys::Interpolation::step) return result;
  const double step = static_cast<double>(keys.times[next]) - keys.times[before];
  const double t = (time - keys.times[before]) / step;
  const float* b = at(next, 1);
  if (cubic) {
    const float *out = at(before, 2), *in = at(next, 0);
    const double t2 = t * t, t3 = t2 * t;
    for (std::size_t c = 0; c < width; ++c)
      result[c] = (2 * t3 - 3 * t2 + 1) * a[c] + step * (t3 - 2 * t2 + t) * out[c]
                  + (3 * t2 - 2 * t3) * b[c] + step * (t3 - t2) * in[c];
  } else if (is_rotation) {
    interpolate_rotation(a, b, t, result.data());
  } else {
    for (std::size_t c = 0; c < width; ++c)
      result[c] = (1 - t) * a[c] + t * b[c];
  }
  return result;
}

// A rotation of length 0 is none: refused whatever the time, as its neighbours in time are turned towards it.
void check_rotations(const Document& document, const Keys& keys, const std::string& place) {
  const bool cubic = keys.interpolation == Keys::Interpolation::cubic;
  for (std::size_t key = 0; key < keys.times.size(); ++key) {
    const float* const q = keys.values.data() + (cubic ? 3 * key + 1 : key) * keys.width;
    if (std::all_of(q, q + keys.width, [](float x) { return x == 0.0f; }))
      fail(document.name(), place + ".output",
           fmt::format("key {} is a rotation of length 0", key));
  }
}

void set(Document& document, int index, const std::string& path, std::vector<double> value) {
  tinygltf::Node& node = document.node(index);
  if (path == "weights") {
    node.weights = std::move(value);
    return;
  }
  if (!node.matrix.empty())
    fail(document.name(), element("nodes", index) + ".matrix", "is set, and an animation moves it",
         "Export it with translation, rotation and scale.");
  (path == "translation" ? node.translation
   : path == "rotation"  ? node.rotation
                         : node.scale) = std::move(value);
}

} // namespace

std::vector<std::string> animation_names(const Document& document) {
  std::vector<std::string> names;
  for (const json& animation : document.animations()) {
    names.push_back(name_of(animation));
    if (names.back().empty()) names.back() = std::to_string(names.size() - 1);
  }
  return names;
}

Posed pose_at(Document& document, const Instant& instant) {
  const std::size_t index = chosen(document, instant.animation);
  const std::string place = fmt::format("animations[{}]", index);
  const json& animation = document.animation(index);
  Posed posed{.animation = name_of(animation), .time = instant.time, .end = 0.0f};
  if (posed.animation.empty()) posed.animation = std::to_string(index);
  for (std::size_t i = 0; i < animation["channels"].size(); ++i) {
    const json& channel = animation["channels"][i];
    const json& target = channel["target"];
    const std::string path = target["path"].get<std::string>();
    const std::size_t width = path == "rotation"                         ? 4
                              : path == "translation" || path == "scale" ? 3
                                                                         : 0;
    if (width == 0 && path != "weights") {
      note(fmt::format("{}: {}.channels[{}] animates '{}', which is not known; ignored",
                       document.name(), place, i, path.substr(0, 40)));
      continue;
    }
    const auto sampler = channel["sampler"].get<std::size_t>();
    const std::string sampler_place = fmt::format("{}.samplers[{}]", place, sampler);
    const Keys keys = read_keys(document, animation["samplers"][sampler], width, sampler_place);
    if (path == "rotation") check_rotations(document, keys, sampler_place);
    posed.end = std::max(posed.end, keys.times.back());
    if (target.contains("node")) // without one it is for extensions
      set(document, target["node"].get<int>(), path,
          value_at(keys, instant.time, path == "rotation"));
  }
  return posed;
}

} // namespace gg::scene::gltf
