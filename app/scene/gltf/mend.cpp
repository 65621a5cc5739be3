#include "scene/gltf/mend.h"

#include "core/error.h"
#include "scene/gltf/check.h"
#include "scene/gltf/fail.h"

#include <fmt/format.h>

#include <map>
#include <set>
#include <string>
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

// One note for each kind of fault, however many entries of a file have it: the first one's place, and how many more there are.
class Notes {
public:
  explicit Notes(const std::string& file) : file_(file) {}

  // Places that differ by their indices alone are of one kind, and so are those that are alike as far as they are printed: keys
  // may be long.
  void add(const std::string& whole_place, const std::string& what) {
    constexpr std::size_t longest_place = 200;
    const std::string place = whole_place.substr(0, longest_place);
    std::string kind = what + ' ';
    bool in_brackets = false;
    for (const char c : place) {
      if (c == ']') in_brackets = false;
      if (!in_brackets) kind += c;
      if (c == '[') in_brackets = true;
    }
    const auto [at, is_new] = kinds_.try_emplace(kind, faults_.size());
    if (is_new) faults_.push_back({place, what, 0});
    ++faults_[at->second].count;
  }

  void print() const {
    for (const Fault& fault : faults_) {
      const std::string more =
          fault.count > 1 ? fmt::format(" (and {} more like it)", fault.count - 1) : std::string();
      note(fmt::format("{}: {} {}{}", file_, fault.place, fault.what, more));
    }
  }

private:
  struct Fault {
    std::string place, what;
    std::size_t count;
  };
  const std::string& file_;
  std::vector<Fault> faults_;
  std::map<std::string, std::size_t> kinds_; // kind, and which of faults_
};

// A list of things to do instead of recursion, as files may nest.
void drop_nulls(json& root, Notes& notes) {
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
        notes.add(at, "is null, which counts as not being there");
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

void mend_zeros(json& root, Notes& notes) {
  for_each(root, "bufferViews", [&](std::size_t i, json& view) {
    if (!is_zero(member(view, {"byteStride"}))) return;
    notes.add(fmt::format("bufferViews[{}].byteStride", i), "is 0; taken as packed");
    view.erase("byteStride");
  });
  for_each(root, "materials", [&](std::size_t i, json& material) {
    json* const volume = member(material, {"extensions", "KHR_materials_volume"});
    if (volume == nullptr || !is_zero(member(*volume, {"attenuationDistance"}))) return;
    notes.add(fmt::format("materials[{}].extensions.KHR_materials_volume.attenuationDistance", i),
              "is 0; taken as no attenuation");
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
  Notes notes(file);
  drop_nulls(root, notes);
  mend_zeros(root, notes);
  notes.print();
  mend_version(root, file);
  mend_unused_materials(root, file);
  return mend_cameras(root, file);
}

} // namespace gg::scene::gltf
