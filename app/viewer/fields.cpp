#include "viewer/fields.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace gg::viewer {

// Clamping alone lets NaN pass, which Dear ImGui computes where "*1e39" is typed over 0.
bool slider(const char* label, float& value, float least, float most, const char* format,
            int flags) {
  float set = value;
  if (!ImGui::SliderFloat(label, &set, least, most, format, flags | ImGuiSliderFlags_AlwaysClamp)
      || !std::isfinite(set))
    return false;
  value = set;
  return true;
}

bool colour_field(const char* label, float (&linear)[3], float most) {
  float set[3] = {linear[0], linear[1], linear[2]};
  if (!ImGui::ColorEdit3(label, set, ImGuiColorEditFlags_Float)
      || !std::all_of(set, set + 3, [](float c) { return std::isfinite(c); }))
    return false;
  for (int i = 0; i < 3; ++i)
    linear[i] = std::clamp(set[i], 0.0f, most);
  return true;
}

} // namespace gg::viewer
