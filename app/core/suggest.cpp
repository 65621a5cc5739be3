#include "core/suggest.h"

#include <algorithm>
#include <cctype>
#include <utility>
#include <vector>

namespace gg {
namespace {

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::ranges::transform(lower, lower.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

// Optimal string alignment: the restricted form, which never edits what it has swapped.
std::size_t distance(std::string_view a, std::string_view b) {
  const std::size_t width = b.size() + 1;
  std::vector<std::size_t> cost((a.size() + 1) * width);
  const auto at = [&](std::size_t i, std::size_t j) -> std::size_t& { return cost[i * width + j]; };
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        at(i, j) = i + j;
        continue;
      }
      const std::size_t changed = at(i - 1, j - 1) + (a[i - 1] == b[j - 1] ? 0 : 1);
      at(i, j) = std::min({at(i - 1, j) + 1, at(i, j - 1) + 1, changed});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        at(i, j) = std::min(at(i, j), at(i - 2, j - 2) + 1);
    }
  return cost.back();
}

} // namespace

std::string nearest(std::string_view word, std::span<const std::string> names) {
  constexpr std::size_t longest = 64; // names are short; a path typed in their place is not one
  if (word.size() > longest) return {};
  const std::string lower = lower_case(word);
  std::string best;
  // Of names as near the one whose case is as typed.
  std::pair least{std::max<std::size_t>(1, word.size() / 3) + 1, std::size_t{0}};
  for (const std::string& name : names)
    if (const std::pair d{distance(lower, lower_case(name)), distance(word, name)}; d < least) {
      least = d;
      best = name;
    }
  if (!best.empty() || word.size() < 3) return best;
  const auto begun = std::ranges::find_if(
      names, [&](const std::string& name) { return lower_case(name).starts_with(lower); });
  return begun != names.end() ? *begun : std::string();
}

std::string did_you_mean(std::string_view word, std::span<const std::string> names) {
  const std::string name = nearest(word, names);
  return name.empty() ? name : "Did you mean " + name + "? ";
}

} // namespace gg
