// Fields for numbers that are dragged or typed (Ctrl+click). Whatever is typed, the value stays finite and in its range.
#pragma once

namespace gg::viewer {

// Both say whether the value has changed.
bool slider(const char* label, float& value, float least, float most, const char* format,
            int flags = 0);                                           // ImGuiSliderFlags
bool colour_field(const char* label, float (&linear)[3], float most); // each from 0 to `most`

} // namespace gg::viewer
