// Pictures for a page: without loss, in memory.
#pragma once

#include "image/image.h"

#include <cstddef>
#include <string>
#include <vector>

namespace gg::report {

// `display` holds display-encoded RGB (or RGBA, the fourth dropped), as frame::for_display gives.
std::vector<std::byte> webp_of(const image::Image& display);

// A map of 0..1 in the colours of image::heat_colour, without a legend.
image::Image coloured(const image::Image& map);

std::string data_uri(const std::vector<std::byte>& webp);

} // namespace gg::report
