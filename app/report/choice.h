// Which method to use: the Pareto front of time and error, and the choice within a limit.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace gg::report {

struct Point {
  double ms = 0.0;
  double error = 0.0;
};

// The points that no other one beats: none is at most as slow and at most as wrong, and better in
// one of the two. By rising time. Of equal points the first counts; a point that is not finite
// never does.
std::vector<std::size_t> pareto_front(std::span<const Point> points);

// What is asked for: one of the two.
struct Limit {
  std::optional<double> max_error; // relMSE
  std::optional<double> budget;    // ms
  bool asked() const { return max_error || budget; }
};

struct Choice {
  std::size_t index = 0;
  bool met = false; // else nothing meets the limit, and this comes nearest to it
};

// `all` and `best`: the same pictures by relMSE and by 1 %-trimmed relMSE. The fastest whose relMSE is
// within the error; or the most accurate within the budget, which goes by the trimmed one, as else
// one pixel of a hundred decides. If nothing is within the limit: the most accurate,
// or the fastest. Nothing if no point is finite or no limit is asked for.
std::optional<Choice> choose(std::span<const Point> all, std::span<const Point> best,
                             const Limit& limit);

} // namespace gg::report
