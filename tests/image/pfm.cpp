#include "core/files.h"
#include "image/image.h"
#include "image/samples.h"
#include "support/errors.h"
#include "support/pictures.h"
#include "support/scratch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace gg;
using namespace gg::test;
using image::Image;

TEST(pfm, rows_run_upwards_in_either_byte_order) {
  const std::string one_big("\x3f\x80\0\0", 4), two_big("\x40\0\0\0", 4);
  const std::string one_little("\0\0\x80\x3f", 4), two_little("\0\0\0\x40", 4);
  const Image big = image::read(scratch_file("big.pfm", "Pf\n1 2\n1.0\n" + one_big + two_big));
  const Image little =
      image::read(scratch_file("little.pfm", "Pf 1 2 -1.0\n" + one_little + two_little));
  EXPECT_EQ(big.at(0, 0, 2), 2.0f);
  EXPECT_EQ(big.at(0, 1, 2), 1.0f);
  EXPECT_TRUE(pictures_agree(little, big, {}));
}

TEST(pfm, what_is_written_is_read_back_to_the_bit) {
  Image image = noise(13, 7, 3);
  image.values[5] = -0.0f;
  image.values[6] = std::numeric_limits<float>::denorm_min();
  image.values[7] = -INFINITY;
  const std::filesystem::path path = scratch_directory() / "picture.pfm";
  image::write(path, image);
  EXPECT_EQ(image::read(path).values, image.values);
}

TEST(pfm, grey_is_written_as_one_channel_and_alpha_dropped) {
  const Image grey = noise(4, 3, 1), rgba = noise(4, 3, 4);
  const std::filesystem::path path = scratch_directory() / "picture.pfm";
  image::write(path, grey);
  EXPECT_EQ(read_file(path).size(), std::string("Pf\n4 3\n-1.0\n").size() + 4 * 3 * 4);
  EXPECT_EQ(image::read(path).at(3, 1, 2), grey.at(3, 1));
  image::write(path, rgba);
  EXPECT_EQ(image::read(path).at(3, 1, 2), rgba.at(3, 1, 2));
}

TEST(pfm, malformed_and_truncated_files_are_refused_by_name) {
  const std::string pixels(12, 'x');
  for (const auto& [text, what] : {std::pair{"PF\n", "header"},
                                   {"PF\n1", "header"},
                                   {"PF\n1 1", "header"},
                                   {"PF\n1 1\n-1", "header"},
                                   {"PF\nx 1\n-1\n", "not \"x\""},
                                   {"PF\n1 1.5\n-1\n", "1.5"},
                                   {"PF\n1 1\n0\n", "byte order"},
                                   {"PF\n1 1\nnan\n", "byte order"},
                                   {"PF\n1 1\ninf\n", "byte order"},
                                   {"PF\n0 1\n-1\n", "0 x 1"},
                                   {"PF\n-1 1\n-1\n", "-1 x 1"},
                                   {"PF\n100000 1\n-1\n", "more than are accepted"},
                                   {"PF\n60000 60000\n-1\n", "more than are accepted"},
                                   {"PF\n2 1\n-1\n", "ends too soon"},
                                   {"PF\n10000 10000\n-1\n", "need 1200000"}})
    EXPECT_TRUE(fails_with(ExitCode::input, {"bad.pfm", what}, [&] {
      image::read(
          scratch_file("bad.pfm", text + (std::string_view(what) == "header" ? "" : pixels)));
    })) << text;
  const std::string whole = "PF\n1 1\n-1\n" + pixels;
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_TRUE(fails_with(ExitCode::input, {"cut.pfm"}, [&] {
      image::read(scratch_file("cut.pfm", whole.substr(0, size)));
    })) << size;
}
