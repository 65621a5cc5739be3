#include "robustness/campaign_draw.h"

namespace gg::test {

bool draw_small(const std::filesystem::path&, const scene::Scene*) {
  return false;
}

} // namespace gg::test
