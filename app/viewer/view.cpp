#include "viewer/view.h"

#include <algorithm>

namespace gg::viewer {

const std::string* Edit::find(const std::string& key) const {
  const auto found = std::ranges::find(settings, key, &std::pair<std::string, std::string>::first);
  return found == settings.end() ? nullptr : &found->second;
}

void Edit::set(const std::string& key, const std::string& value) {
  const auto found = std::ranges::find(settings, key, &std::pair<std::string, std::string>::first);
  if (found == settings.end())
    settings.emplace_back(key, value);
  else
    found->second = value;
}

void Edit::erase(const std::string& key) {
  std::erase_if(settings, [&](const auto& setting) { return setting.first == key; });
}

std::string View::left_out() const {
  std::string names;
  for (const std::string& name : without)
    names += (names.empty() ? "" : ",") + name;
  return names;
}

std::vector<std::string> View::all_materials() const {
  std::vector<std::string> all = materials;
  for (std::size_t i = 0; i < edits.size(); ++i) {
    if (edits[i].empty()) continue;
    std::string spec = "#" + std::to_string(i) + "=" + edits[i].preset;
    for (const auto& [key, value] : edits[i].settings)
      spec += "," + key + "=" + value;
    all.push_back(spec);
  }
  return all;
}

} // namespace gg::viewer
