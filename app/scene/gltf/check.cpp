#include "scene/gltf/check.h"

#include "scene/gltf/fail.h"
#include "scene/gltf/rule.h"

#include <fmt/format.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <sstream>
#include <string_view>

namespace gg::scene::gltf {
namespace {

using nlohmann::json;

class Checker {
public:
  Checker(const json& root, const std::string& file) : root_(root), file_(file) {}

  void object(const json& value, std::span<const Rule> rules, const std::string& place) const {
    if (!value.is_object()) wrong_type(value, "an object", place);
    for (const Rule& rule : rules) {
      const auto member = value.find(rule.key);
      const std::string at = place.empty() ? rule.key : place + "." + rule.key;
      if (member == value.end() && rule.required) fail(file_, at, "is missing");
      if (member != value.end()) one(*member, rule, at);
    }
  }

private:
  void one(const json& value, const Rule& rule, const std::string& place) const {
    switch (rule.kind) {
    case Kind::boolean:
      if (!value.is_boolean()) wrong_type(value, "true or false", place);
      break;
    case Kind::string:
      if (!value.is_string()) wrong_type(value, "a string", place);
      break;
    case Kind::choice:
      choice(value, rule, place);
      break;
    case Kind::integer:
      integer(value, rule, place);
      break;
    case Kind::number:
      number(value, rule, place);
      break;
    case Kind::index:
      index(value, rule, place);
      break;
    case Kind::object:
      object(value, rule.members, place);
      break;
    case Kind::map:
      if (!value.is_object()) wrong_type(value, "an object", place);
      for (const auto& [key, entry] : value.items())
        rule.target ? index(entry, rule, place + "." + key)
                    : integer(entry, rule, place + "." + key);
      break;
    case Kind::maps:
    case Kind::numbers:
    case Kind::strings:
    case Kind::indices:
    case Kind::objects:
      array(value, rule, place);
      break;
    }
  }

  void array(const json& value, const Rule& rule, const std::string& place) const {
    if (!value.is_array()) wrong_type(value, "an array", place);
    if (rule.size != 0 && value.size() != rule.size)
      fail(file_, place,
           fmt::format("has {} entries where {} are needed", value.size(), rule.size));
    Rule entry = rule;
    entry.kind = rule.kind == Kind::numbers   ? Kind::number
                 : rule.kind == Kind::strings ? Kind::string
                 : rule.kind == Kind::indices ? Kind::index
                 : rule.kind == Kind::maps    ? Kind::map
                                              : Kind::object;
    for (std::size_t i = 0; i < value.size(); ++i)
      one(value[i], entry, fmt::format("{}[{}]", place, i));
  }

  void choice(const json& value, const Rule& rule, const std::string& place) const {
    if (!value.is_string()) wrong_type(value, "a string", place);
    std::istringstream words(rule.target);
    for (std::string word; words >> word;)
      if (value == word) return;
    fail(file_, place,
         fmt::format("is '{}', not one of {}", value.get_ref<const std::string&>().substr(0, 40),
                     rule.target));
  }

  void integer(const json& value, const Rule& rule, const std::string& place) const {
    if (!value.is_number_integer()) wrong_type(value, "a whole number", place);
    range(value.is_number_unsigned() ? static_cast<double>(value.get<std::uint64_t>())
                                     : static_cast<double>(value.get<std::int64_t>()),
          rule, place);
  }

  void number(const json& value, const Rule& rule, const std::string& place) const {
    if (!value.is_number()) wrong_type(value, "a number", place);
    range(value.get<double>(), rule, place);
  }

  void range(double value, const Rule& rule, const std::string& place) const {
    if (rule.high == factor && std::abs(value) > 1.0 + FLT_EPSILON && std::abs(value) <= factor)
      note(fmt::format("{}: {} is {}; taken as {}", file_, place, value, value < 0.0 ? -1 : 1));
    if (!(value >= rule.low && value <= rule.high))
      fail(file_, place,
           rule.high >= largest_integer
               ? fmt::format("is {}; the smallest allowed is {}", value, rule.low)
               : fmt::format("is {}, outside {} .. {}", value, rule.low, rule.high));
  }

  void index(const json& value, const Rule& rule, const std::string& place) const {
    const json::json_pointer pointer(rule.target);
    const std::size_t size =
        root_.contains(pointer) && root_[pointer].is_array() ? root_[pointer].size() : 0;
    if (!value.is_number_integer()) wrong_type(value, "an index", place);
    if (!value.is_number_unsigned() || value.get<std::uint64_t>() >= size)
      fail(file_, place,
           fmt::format("refers to {} number {}, and there are {}", rule.target + 1, value.dump(),
                       size));
  }

  [[noreturn]] void wrong_type(const json& value, const char* wanted,
                               const std::string& place) const {
    fail(file_, place, fmt::format("is {} where {} is needed", value.type_name(), wanted));
  }

  const json& root_;
  const std::string& file_;
};

// Objects that say which of their members counts must have it.
void check_kind(const json& object, const std::string& place, const std::string& file) {
  const std::string& type = object["type"].get_ref<const std::string&>();
  const bool has_member = type == "perspective" || type == "orthographic" || type == "spot";
  if (has_member && !object.contains(type)) fail(file, place + "." + type, "is missing");
}

void check_camera(const json& camera, const std::string& place, const std::string& file) {
  check_kind(camera, place, file);
  const json& lens = camera[camera["type"].get_ref<const std::string&>()];
  const double near = lens["znear"].get<double>();
  const double far = lens.value("zfar", double{FLT_MAX}); // without one there is no end
  if (lens.contains("xmag") && (lens["xmag"] == 0.0 || lens["ymag"] == 0.0))
    fail(file, place + ".orthographic", "has a magnification of 0");
  if (far <= near)
    fail(file, place, fmt::format("ends at {} m, before it begins at {} m", far, near));
}

void check_material(const json& material, const std::string& place, const std::string& file) {
  const json::json_pointer pointer("/extensions/KHR_materials_ior/ior");
  if (!material.contains(pointer)) return;
  const double ior = material[pointer].get<double>();
  if (ior != 0.0 && ior < 1.0)
    fail(file, place + ".extensions.KHR_materials_ior.ior",
         fmt::format("is {}; it is at least 1, or 0 for 'always reflects'", ior));
}

using CheckOne = void (*)(const json&, const std::string&, const std::string&);

void check_each(const json& root, const json::json_pointer& array, const std::string& name,
                CheckOne check_one, const std::string& file) {
  if (!root.contains(array)) return;
  const json& entries = root[array];
  for (std::size_t i = 0; i < entries.size(); ++i)
    check_one(entries[i], fmt::format("{}[{}]", name, i), file);
}

} // namespace

void check(const nlohmann::json& json, const std::string& file) {
  Checker(json, file).object(json, schema(), "");
  const auto each = [&](const char* pointer, const char* name, CheckOne check_one) {
    check_each(json, nlohmann::json::json_pointer(pointer), name, check_one, file);
  };
  each("/cameras", "cameras", check_camera);
  each("/materials", "materials", check_material);
  each("/extensions/KHR_lights_punctual/lights", "extensions.KHR_lights_punctual.lights",
       check_kind);
}

void check_animation(const nlohmann::json& root, std::size_t index, const std::string& file) {
  const nlohmann::json& animation = root["animations"][index];
  const std::string place = fmt::format("animations[{}]", index);
  const Checker checker(root, file);
  checker.object(animation, animation_rules(), place);
  const std::size_t samplers = animation["samplers"].size();
  for (std::size_t i = 0; i < animation["channels"].size(); ++i) {
    const auto sampler = animation["channels"][i]["sampler"].get<std::size_t>();
    if (sampler >= samplers)
      fail(file, fmt::format("{}.channels[{}].sampler", place, i),
           fmt::format("is {}, and there are {} samplers", sampler, samplers));
  }
}

std::optional<std::string> fault_of(const nlohmann::json& root, const char* array,
                                    std::size_t index, const std::string& file) {
  const std::string place = fmt::format("{}[{}]", array, index);
  const auto rule = std::ranges::find_if(
      schema(), [&](const Rule& r) { return std::string_view(r.key) == array; });
  const nlohmann::json& entry = root[array][index];
  try {
    Checker(root, file).object(entry, rule->members, place);
    std::string_view(array) == "cameras" ? check_camera(entry, place, file)
                                         : check_material(entry, place, file);
    return std::nullopt;
  } catch (const Error& error) {
    return error.what();
  }
}

} // namespace gg::scene::gltf
