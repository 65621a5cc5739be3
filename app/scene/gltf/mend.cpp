#include "scene/gltf/mend.h"

#include "core/error.h"
#include "scene/gltf/check.h"
#include "scene/gltf/fail.h"

#include <fmt/format.h>

#include <set>
#include <vector>

namespace gg::scene::gltf {
namespace {

using nlohmann::json;

// Calls act(i, entry) for each entry of the array of that name, if there is one.
template <class Act>
void for_each(json& root, const char* name, const Act& act) {
  if (!root.is_object()) return;
  const auto found = root.find(name);
  if (found == root.end() || !found->is_array()) return;
  for (std::size_t i = 0; i < found->size(); ++i)
    act(i, (*found)[i]);
}

// The member at the end of a path of keys, or null.
json* member(json& from, std::initializer_list<const char*> path) {
  json* at = &from;
  for (const char* key : path) {
    if (!at->is_object()) return nullptr;
    const auto found = at->find(key);
    if (found == at->end()) return nullptr;
    at = &*found;
  }
  return at;
}

// A list of things to do instead of recursion, as files may nest.
void drop_nulls(json& root, const std::string& file) {
  struct Step {
    json* value;
    std::string place;
  };
  std::vector<Step> waiting{{&root, ""}};
  while (!waiting.empty()) {
    const auto [value, place] = std::move(waiting.back());
    waiting.pop_back();
    if (value->is_array())
      for (std::size_t i = 0; i < value->size(); ++i)
        if ((*value)[i].is_structured())
          waiting.push_back({&(*value)[i], fmt::format("{}[{}]", place, i)});
    if (!value->is_object()) continue;
    for (auto it = value->begin(); it != value->end();) {
      const std::string at = place.empty() ? it.key() : place + "." + it.key();
      if (it->is_null()) {
        note(file + ": " + at.substr(0, 200) + " is null, which counts as not being there");
        it = value->erase(it);
        continue;
      }
      if (it->is_structured() && it.key() != "extras") waiting.push_back({&*it, at});
      ++it;
    }
  }
}

bool is_zero(const json* value) {
  return value != nullptr && value->is_number() && value->get<double>() == 0.0;
}

void mend_version(json& root, const std::string& file) {
  json* const version = member(root, {"asset", "version"});
  if (version == nullptr) return;
  const bool number = version->is_number() && version->get<double>() == 2.0;
  if (!number && !(version->is_string() && *version == "2")) return;
  note(file + ": asset.version is " + version->dump() + "; taken as \"2.0\"");
  *version = "2.0";
}

void mend_zeros(json& root, const std::string& file) {
  for_each(root, "bufferViews", [&](std::size_t i, json& view) {
    if (!is_zero(member(view, {"byteStride"}))) return;
    note(fmt::format("{}: bufferViews[{}].byteStride is 0; taken as packed", file, i));
    view.erase("byteStride");
  });
  for_each(root, "materials", [&](std::size_t i, json& material) {
    json* const volume = member(material, {"extensions", "KHR_materials_volume"});
    if (volume == nullptr || !is_zero(member(*volume, {"attenuationDistance"}))) return;
    note(fmt::format("{}: materials[{}].extensions.KHR_materials_volume.attenuationDistance is 0; "
                     "taken as no attenuation",
                     file, i));
    volume->erase("attenuationDistance");
  });
}

std::set<std::size_t> materials_used(json& root) {
  std::set<std::size_t> used;
  for_each(root, "meshes", [&](std::size_t, json& mesh) {
    for_each(mesh, "primitives", [&](std::size_t, json& primitive) {
      if (const json* const material = member(primitive, {"material"});
          material != nullptr && material->is_number_unsigned())
        used.insert(material->get<std::size_t>());
    });
  });
  return used;
}

void mend_unused_materials(json& root, const std::string& file) {
  const std::set<std::size_t> used = materials_used(root);
  for_each(root, "materials", [&](std::size_t i, json& material) {
    if (used.contains(i)) return;
    if (const auto fault = fault_of(root, "materials", i, file)) {
      note(*fault + " Nothing uses this material, so it is passed over.");
      material = json::object();
    }
  });
}

CameraFaults mend_cameras(json& root, const std::string& file) {
  CameraFaults faults;
  for_each(root, "cameras", [&](std::size_t i, json& camera) {
    if (const auto fault = fault_of(root, "cameras", i, file)) {
      faults[static_cast<int>(i)] = *fault;
      camera = {{"type", "perspective"}, {"perspective", {{"yfov", 0.785}, {"znear", 0.1}}}};
    }
  });
  return faults;
}

} // namespace

CameraFaults mend(json& root, const std::string& file) {
  if (!root.is_object()) return {};
  drop_nulls(root, file);
  mend_version(root, file);
  mend_zeros(root, file);
  mend_unused_materials(root, file);
  return mend_cameras(root, file);
}

} // namespace gg::scene::gltf
