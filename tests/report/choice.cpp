// Which method to use: closed cases of the Pareto front and of the limits.
#include "report/choice.h"

#include "report/results.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gg::report {

using Indices = std::vector<std::size_t>;

TEST(pareto_front, keeps_what_no_other_point_beats_by_rising_time) {
  const std::vector<Point> points{{5, 0.1}, {1, 0.9}, {3, 0.5}, {4, 0.6}, {9, 0.1}, {2, 0.9}};
  // (4, .6) is beaten by (3, .5); (9, .1) and (2, .9) are slower at the same error.
  EXPECT_EQ(pareto_front(points), (Indices{1, 2, 0}));
}

TEST(pareto_front, has_the_first_of_equal_points_and_none_that_is_not_finite) {
  const std::vector<Point> points{{2, 0.5}, {2, 0.5}, {NAN, 0.1}, {1, NAN}, {1, INFINITY}};
  EXPECT_EQ(pareto_front(points), (Indices{0}));
  EXPECT_TRUE(pareto_front({}).empty());
}

TEST(choice, is_the_fastest_within_the_error) {
  const std::vector<Point> points{{1, 0.9}, {3, 0.05}, {8, 0.01}};
  const auto within = [&](double error) { return choose(points, points, {.max_error = error}); };
  EXPECT_EQ(within(0.05)->index, 1u); // a limit that is reached exactly is met
  EXPECT_TRUE(within(0.05)->met);
  EXPECT_EQ(within(1.0)->index, 0u);
  EXPECT_EQ(within(0.001)->index, 2u); // the nearest
  EXPECT_FALSE(within(0.001)->met);
}

TEST(choice, is_the_most_accurate_within_the_budget) {
  const std::vector<Point> points{{1, 0.9}, {3, 0.05}, {4, 0.2}, {8, 0.01}};
  const auto within = [&](double ms) { return choose(points, points, {.budget = ms}); };
  EXPECT_EQ(within(5)->index, 1u); // what is slower and worse is never chosen
  EXPECT_EQ(within(8)->index, 3u);
  EXPECT_TRUE(within(8)->met);
  EXPECT_EQ(within(0.5)->index, 0u);
  EXPECT_FALSE(within(0.5)->met);
}

TEST(choice, of_the_most_accurate_is_not_by_the_worst_hundredth_of_the_pixels) {
  // By all pixels the fastest looks best, for one that it happens to have right.
  const std::vector<Point> all{{1, 800}, {3, 866}, {8, 865}}, best{{1, 0.9}, {3, 0.05}, {8, 0.01}};
  EXPECT_EQ(choose(all, best, {.budget = 5})->index, 1u); // by all pixels, 0
  const auto nearest = choose(all, best, {.max_error = 0.1});
  EXPECT_EQ(nearest->index, 2u);
  EXPECT_FALSE(nearest->met); // the limit is one of all pixels
  EXPECT_EQ(choose(all, best, {.max_error = 900})->index, 0u);
}

TEST(choice, is_nothing_if_nothing_is_asked_or_there_is_nothing) {
  const std::vector<Point> points{{1, 0.9}};
  EXPECT_FALSE(choose(points, points, {}));
  EXPECT_FALSE(choose({}, {}, {.budget = 1.0}));
}

TEST(spread, has_the_quantiles_of_its_values_in_any_order) {
  const Spread s = spread_of({4, 1, 3, 2, 5});
  EXPECT_EQ(s.median, 3.0);
  EXPECT_EQ(s.low_quartile, 2.0);
  EXPECT_EQ(s.high_quartile, 4.0);
  EXPECT_EQ(s.least, 1.0);
  EXPECT_EQ(s.most, 5.0);
  EXPECT_EQ(spread_of({1, 2}).median, 1.5);
  EXPECT_EQ(spread_of({}).count, 0u);
}

} // namespace gg::report
