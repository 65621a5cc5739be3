#include "report/verdict.h"

#include <algorithm>
#include <map>
#include <set>

namespace gg::report {
namespace {

// Means over objects are pooled by their pixels.
void add(Group& group, const image::Errors& e) {
  const auto weight = static_cast<double>(e.pixels);
  group.pixels += e.pixels;
  group.relmse += weight * e.relmse;
  group.relmse_trimmed += weight * e.relmse_trimmed;
  group.bias += weight * e.bias;
  group.flip += weight * e.flip;
  if (e.noise) group.noise += weight * e.noise->relmse;
}

std::vector<Group> finished(const std::map<std::string, Group>& sums) {
  std::vector<Group> groups;
  for (const auto& [name, sum] : sums) {
    if (sum.pixels == 0) continue;
    const auto weight = static_cast<double>(sum.pixels);
    groups.push_back({name, sum.pixels, sum.relmse / weight, sum.relmse_trimmed / weight,
                      sum.bias / weight, sum.flip / weight, sum.noise / weight});
  }
  return groups;
}

} // namespace

Judged judge(const image::Picture& picture, const image::Picture& truth,
             const std::vector<ObjectKind>& kinds) {
  std::set<int> shaded;
  for (const float id : truth.id) {
    const auto object = static_cast<std::size_t>(id);
    if (object >= 1 && object <= kinds.size() && kinds[object - 1].shaded)
      shaded.insert(static_cast<int>(object));
  }
  image::Comparison comparison =
      image::compare(picture, truth, std::vector<int>(shaded.begin(), shaded.end()));
  Judged judged{.verdict = {.objects = comparison.frame, .frame = comparison.frame},
                .flip_map = std::move(comparison.flip_map)};
  if (!shaded.empty() && comparison.objects && comparison.objects->pixels > 0)
    judged.verdict.objects = *comparison.objects;
  std::map<std::string, Group> by_class, by_roughness;
  for (const auto& [id, errors] : comparison.by_object) {
    if (!shaded.contains(id) || errors.pixels == 0) continue;
    const ObjectKind& kind = kinds[static_cast<std::size_t>(id) - 1];
    add(by_class[kind.material], errors);
    add(by_roughness[kind.roughness], errors);
  }
  judged.verdict.by_class = finished(by_class);
  judged.verdict.by_roughness = finished(by_roughness);
  std::ranges::sort(judged.verdict.by_roughness, {}, [](const Group& group) {
    return std::ranges::find(roughness_bands, group.name) - roughness_bands.begin();
  });
  return judged;
}

} // namespace gg::report
