// How many of its triangles a mesh is drawn with.
#pragma once

#include "needs/draws.h"
#include "needs/view.h"
#include "scene/coarse.h"

namespace gg::frame {

// The coarsest list of its primitive whose error is under half a pixel where the draw is nearest to the eye; null: it is drawn whole.
const scene::CoarseList* coarsest(const scene::CoarseLists& lists, const needs::Draw& draw,
                                  const scene::Instance& instance, const needs::View& view);

} // namespace gg::frame
