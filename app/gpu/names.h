// Numbers for the names of resources, so that binding by name costs one look-up and no comparison
// of text afterwards.
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>

namespace gg::gpu {

class Names {
public:
  // The number of a name that some pipeline uses; made if it is new.
  int add(std::string_view name) {
    return numbers_.try_emplace(std::string(name), static_cast<int>(numbers_.size())).first->second;
  }
  // -1 if no pipeline has used it.
  int find(std::string_view name) const {
    const auto found = numbers_.find(name);
    return found == numbers_.end() ? -1 : found->second;
  }
  std::size_t size() const { return numbers_.size(); }

private:
  struct Hash {
    using is_transparent = void;
    std::size_t operator()(std::string_view text) const {
      return std::hash<std::string_view>{}(text);
    }
  };
  std::unordered_map<std::string, int, Hash, std::equal_to<>> numbers_;
};

} // namespace gg::gpu
