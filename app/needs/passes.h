// The passes of a frame, in the order in which they run.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace gg::needs {

struct Needs;

enum class PassKind {
  geometry, // depth and normal of the fine meshes, whose shading is by their pixels
  opaque,   // what hides what is behind it, the sky, and blended surfaces that lie over these alone
  material_depth, // the pixels that each material's region shades
  deferred,       // shades them
  over_opaque,    // blended surfaces, where they lie over those, or over what is shaded once more
  backdrop,       // the picture so far, for lookups: level 0 of the pyramid
  foreground,     // cuts out of it what stands before the layer
  pyramid,        // one level from the one before
  reflective,     // opaque surfaces once more, now that the picture shows what they reflect
  deferred_reflective, // the same by their pixels
  interior,            // the faces of solids
  layer,               // glass, and blended surfaces among it
  accumulate           // adds the sample to the average
};

struct Pass {
  PassKind kind = PassKind::opaque;
  std::string label;     // of its timer
  std::size_t layer = 0; // of Needs::layers, where it is of one
  int part = 0; // pyramid: level; interior: 0 F1, 1 B1, 2 F2, 3 B2; reflective: 1 what shows glass
  bool takes_depth = false; // backdrop: the depth too, of what lookups meet
  bool glass_depth =
      false;             // backdrop: takes that of the glass so far instead; layer: is hidden by it
  std::size_t draws = 0; // of meshes
  std::vector<std::string> reads, writes; // targets and what was uploaded, by name
};

// Of one sample. All else in `needs` is known.
std::vector<Pass> passes_of(const Needs& needs);

} // namespace gg::needs
