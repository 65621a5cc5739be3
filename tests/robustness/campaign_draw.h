// Drawing a mutant that was read, or not: campaign_draw.cpp draws, campaign_read.cpp is for machines and builds that only read.
#pragma once

#include "scene/scene.h"

#include <filesystem>

namespace gg::test {

// Draws the scene under a constant sky, or if it is null a solid under the file's panorama, 24 x 24 pixels on both backends,
// and expects finite values. Returns whether it was drawn. Throws what loading the panorama throws.
bool draw_small(const std::filesystem::path& file, const scene::Scene* scene);
// Frees what drawing keeps, before the devices end.
void stop_drawing();

} // namespace gg::test
