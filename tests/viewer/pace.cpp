#include "viewer/pace.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace gg::viewer {
namespace {

// Frames of a device that takes `ms` for the full size; milliseconds of the last.
double settled(Pace& pace, double ms, int frames = 200) {
  double last = 0.0;
  for (int i = 0; i < frames; ++i) {
    last = ms * pace.scale() * pace.scale();
    pace.took(last);
  }
  return last;
}

TEST(pace, comes_down_to_the_wanted_rate) {
  for (const double full : {10.0, 50.0, 200.0, 1000.0}) {
    Pace pace;
    pace.want(30.0);
    EXPECT_LE(settled(pace, full), 1000.0 / 30.0) << full;
  }
}

TEST(pace, comes_back_to_the_full_size) {
  Pace pace;
  pace.want(30.0);
  settled(pace, 1000.0);
  settled(pace, 1.0);
  EXPECT_EQ(pace.scale(), 1.0);
}

TEST(pace, does_not_swing) {
  Pace pace;
  pace.want(30.0);
  settled(pace, 100.0);
  const double scale = pace.scale();
  for (int i = 0; i < 50; ++i) {
    settled(pace, 100.0, 1);
    EXPECT_EQ(pace.scale(), scale);
  }
}

TEST(pace, answers_at_once_where_it_is_much_too_slow) {
  Pace pace;
  pace.want(30.0);
  settled(pace, 1.0);
  settled(pace, 500.0, 2);
  EXPECT_LE(500.0 * pace.scale() * pace.scale(), 1000.0 / 30.0);
}

TEST(pace, begins_in_time_when_it_knows_the_full_size) {
  for (const double full : {10.0, 50.0, 200.0, 1000.0}) {
    Pace pace;
    pace.want(30.0);
    pace.begin(full);
    EXPECT_LE(full * pace.scale() * pace.scale(), 1000.0 / 30.0) << full;
  }
}

TEST(pace, knows_before_the_first_frame_what_is_far_out_of_reach) {
  for (const double full : {1000.0, 6000.0}) { // 16 and 94 ms at an eighth
    Pace pace;
    pace.want(30.0);
    pace.begin(full);
    EXPECT_EQ(pace.is_out_of_reach(), full == 6000.0);
  }
}

TEST(pace, knows_that_the_rate_is_out_of_reach) {
  Pace pace;
  pace.want(30.0);
  settled(pace, 2000.0); // 31 ms at an eighth
  EXPECT_FALSE(pace.is_out_of_reach());
  settled(pace, 5000.0); // 78 ms
  EXPECT_TRUE(pace.is_out_of_reach());
  pace.want(10.0);
  EXPECT_FALSE(pace.is_out_of_reach());
}

TEST(pace, leaves_the_picture_a_third_of_a_frame) {
  Pace pace;
  pace.want(30.0, 100.0); // what the window takes is beyond the wanted time alone
  EXPECT_GE(settled(pace, 60.0), 0.5 * 1000.0 / 90.0);
}

} // namespace
} // namespace gg::viewer
