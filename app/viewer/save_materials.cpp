#include "viewer/save_materials.h"

#include "core/error.h"
#include "core/files.h"

#include <nlohmann/json.hpp>

#include <charconv>
#include <cstring>
#include <filesystem>
#include <sstream>

namespace gg::viewer {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

// A later option with a preset starts again; one without adds to what is there.
void add(Edit& to, const std::string& settings) {
  std::istringstream parts(settings);
  std::string preset;
  std::getline(parts, preset, ',');
  if (!preset.empty()) to = {.preset = preset, .settings = {}};
  for (std::string part; std::getline(parts, part, ',');) {
    const std::size_t equals = part.find('=');
    if (equals != std::string::npos) to.set(part.substr(0, equals), part.substr(equals + 1));
  }
}

// What all the options together say of a material.
Edit merged(const View& view, const scene::Scene& scene, std::size_t material) {
  Edit all;
  for (const std::string& spec : view.all_materials())
    for (const std::string& name :
         {std::string("*"), scene.materials[material].name, "#" + std::to_string(material)})
      if (!name.empty() && spec.starts_with(name + "=")) {
        add(all, spec.substr(name.size() + 1));
        break;
      }
  return all;
}

// A number, three numbers, or a word, as the loader reads them.
ordered_json value_of(const std::string& text) {
  std::istringstream parts(text);
  ordered_json numbers = ordered_json::array();
  for (std::string part; std::getline(parts, part, '/');) {
    float value = 0.0f;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
    if (error != std::errc() || end != part.data() + part.size()) return text;
    numbers.push_back(value);
  }
  return numbers.size() == 1 ? numbers.front() : numbers;
}

void put(const View& view, const scene::Scene& scene, ordered_json& document) {
  if (!document.contains("materials")) return;
  for (std::size_t i = 0; i < document["materials"].size() && i < scene.materials.size(); ++i) {
    const Edit edit = merged(view, scene, i);
    if (edit.empty()) continue;
    ordered_json& extras = document["materials"][i]["extras"];
    if (!extras.is_object()) extras = ordered_json::object();
    ordered_json& own = extras["groundglass"];
    if (!edit.preset.empty() || !own.is_object()) own = ordered_json::object();
    if (!edit.preset.empty()) own["preset"] = edit.preset;
    for (const auto& [key, value] : edit.settings)
      own[key] = value_of(value);
  }
}

std::uint32_t word_at(std::span<const std::byte> bytes, std::size_t at) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + at, sizeof word);
  return word;
}

void append(std::string& to, std::uint32_t word) {
  to.append(reinterpret_cast<const char*>(&word), sizeof word);
}

// A .glb: a header of 12 bytes, then chunks of {length, type, data}; the first is the JSON, padded with spaces.
std::string with_json(std::span<const std::byte> glb, const std::string& where, const View& view,
                      const scene::Scene& scene) {
  const std::size_t length = word_at(glb, 12);
  if (20 + length > glb.size())
    throw Error(ExitCode::input, where, "has changed since it was read");
  ordered_json document =
      ordered_json::parse(reinterpret_cast<const char*>(glb.data()) + 20,
                          reinterpret_cast<const char*>(glb.data()) + 20 + length);
  put(view, scene, document);
  std::string json = document.dump();
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::span<const std::byte> rest = glb.subspan(20 + length);
  std::string out("glTF");
  append(out, 2);
  append(out, static_cast<std::uint32_t>(20 + json.size() + rest.size()));
  append(out, static_cast<std::uint32_t>(json.size()));
  append(out, word_at(glb, 16));
  out += json;
  out.append(reinterpret_cast<const char*>(rest.data()), rest.size());
  return out;
}

} // namespace

void save_materials(const View& view, const scene::Scene& scene, const std::string& path) {
  const fs::path from = view.scene;
  fs::path to = path;
  if (!to.has_parent_path()) to = from.parent_path() / to;
  if (to.extension() != from.extension())
    throw Error(ExitCode::usage, path,
                "is not a " + from.extension().string() + " file, as the scene is",
                "Give the copy the same extension.");
  const std::vector<std::byte> bytes = read_file(from);
  std::string out;
  try {
    if (bytes.size() >= 20 && std::memcmp(bytes.data(), "glTF", 4) == 0) {
      out = with_json(bytes, view.scene, view, scene);
    } else {
      const char* text = reinterpret_cast<const char*>(bytes.data());
      ordered_json document = ordered_json::parse(text, text + bytes.size());
      put(view, scene, document);
      out = document.dump(2) + "\n";
    }
  } catch (const ordered_json::exception& error) {
    throw Error(ExitCode::input, view.scene,
                std::string("has changed since it was read: ") + error.what());
  }
  OutputFile file(to);
  file.write(out);
  file.commit();
}

} // namespace gg::viewer
