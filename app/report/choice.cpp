#include "report/choice.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace gg::report {
namespace {

bool counts(const Point& p) {
  return std::isfinite(p.ms) && std::isfinite(p.error);
}

} // namespace

std::vector<std::size_t> pareto_front(std::span<const Point> points) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (counts(points[i])) order.push_back(i);
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    return std::tie(points[a].ms, points[a].error) < std::tie(points[b].ms, points[b].error);
  });
  std::vector<std::size_t> front;
  for (const std::size_t i : order)
    if (front.empty() || points[i].error < points[front.back()].error) front.push_back(i);
  return front;
}

std::optional<Choice> choose(std::span<const Point> all, std::span<const Point> best,
                             const Limit& limit) {
  // On a front, error falls as time rises: the first that is accurate enough is the fastest that
  // is, and the last that is fast enough the most accurate.
  const std::vector<std::size_t> front = pareto_front(best);
  if (front.empty() || !limit.asked()) return std::nullopt;
  if (limit.max_error) {
    for (const std::size_t i : pareto_front(all))
      if (all[i].error <= *limit.max_error) return Choice{i, true};
    return Choice{front.back(), false};
  }
  std::optional<Choice> chosen;
  for (const std::size_t i : front)
    if (best[i].ms <= *limit.budget) chosen = Choice{i, true};
  return chosen ? chosen : Choice{front.front(), false};
}

} // namespace gg::report
