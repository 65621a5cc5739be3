#include "scene/gltf/extras.h"

#include "scene/gltf/fail.h"

#include <fmt/format.h>

namespace gg::scene::gltf {
namespace {

// As it would be written on the command line; empty if it cannot be.
std::optional<std::string> text_of(const tinygltf::Value& value) {
  if (value.IsString()) return value.Get<std::string>();
  if (value.IsNumber()) return fmt::format("{}", value.GetNumberAsDouble());
  if (!value.IsArray()) return std::nullopt;
  std::string text;
  for (std::size_t i = 0; i < value.ArrayLen(); ++i) {
    const tinygltf::Value& entry = value.Get(static_cast<int>(i));
    if (!entry.IsNumber()) return std::nullopt;
    text += fmt::format("{}{}", i ? "/" : "", entry.GetNumberAsDouble());
  }
  return text;
}

} // namespace

std::optional<Setting> setting_in_extras(const Document& document, int index) {
  const auto& extras = document.model().materials[static_cast<std::size_t>(index)].extras;
  if (!extras.IsObject() || !extras.Has("groundglass")) return std::nullopt;
  const tinygltf::Value& object = extras.Get("groundglass");
  const std::string place = element("materials", index) + ".extras.groundglass";
  if (!object.IsObject()) fail(document.name(), place, "is not an object");
  Setting setting;
  setting.code = ExitCode::input;
  setting.where = document.name() + ": " + place;
  for (const std::string& key : object.Keys()) {
    const auto value = text_of(object.Get(key));
    if (!value)
      fail(document.name(), place + "." + key.substr(0, 40),
           "is neither a string nor a number nor an array of numbers");
    if (key == "preset")
      setting.preset = *value;
    else
      setting.options.emplace_back(key, *value);
  }
  return setting;
}

} // namespace gg::scene::gltf
