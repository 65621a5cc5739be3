// How many of its triangles a mesh is drawn with.
#pragma once

#include "needs/draws.h"
#include "needs/view.h"
#include "scene/coarse.h"

namespace gg::frame {

// Whether the coarse list of its primitive stands for the whole one: its error is under half a pixel where the
// draw is nearest to the eye.
bool is_enough(const scene::CoarseList& coarse, const needs::Draw& draw,
               const scene::Instance& instance, const needs::View& view);

} // namespace gg::frame
