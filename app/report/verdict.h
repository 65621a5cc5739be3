// From a picture and its truth to how wrong it is, and where.
#pragma once

#include "report/classes.h"
#include "report/results.h"

namespace gg::report {

struct Judged {
  Verdict verdict;
  image::Image flip_map; // one channel, 0..1
};

// `kinds` by instance: object id - 1 of the truth's ids.
Judged judge(const image::Picture& picture, const image::Picture& truth,
             const std::vector<ObjectKind>& kinds);

} // namespace gg::report
