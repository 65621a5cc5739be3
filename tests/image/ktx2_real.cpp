// KTX2 by the libktx that app/setup --ktx2 installs: pictures encoded by it come back as they were, to the codec's steps.
// The samples: 20 x 12, a grey ramp that rises to the right and falls downwards, red in the first block of 4 x 4; with
// alpha, 255 falling to 127 to the right.
#include "core/files.h"
#include "image/image.h"

#include <gtest/gtest.h>

#include <cstdlib>

using namespace gg;

TEST(libktx, pictures_of_both_codecs_come_back) {
  ::setenv("GROUNDGLASS_LIBKTX", GROUNDGLASS_LIBKTX_INSTALLED, 1);
  ASSERT_TRUE(image::can_decode_ktx2())
      << "app/setup --ktx2 installs " GROUNDGLASS_LIBKTX_INSTALLED;
  constexpr int width = 20, height = 12;
  struct Sample {
    const char* name;
    bool has_alpha;
    int step; // of 255: four levels of brightness a block, and the codec's 16 to 256 a channel
  };
  for (const Sample& sample :
       {Sample{"etc1s.ktx2", false, 16}, Sample{"etc1s_alpha.ktx2", true, 16},
        Sample{"uastc.ktx2", true, 8}, Sample{"uastc_zstd.ktx2", true, 8}}) {
    const auto bytes =
        read_file(std::string(GROUNDGLASS_SOURCE_DIR "/tests/image/ktx2/") + sample.name);
    const image::Image8 image = image::decode(bytes.data(), bytes.size(), sample.name);
    ASSERT_EQ(image.width, width);
    ASSERT_EQ(image.height, height);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const bool red = x < 4 && y < 4;
        const int grey =
            static_cast<int>((60.0 + 180.0 * x / (width - 1)) * (1.0 - 0.4 * y / (height - 1)));
        const int alpha = sample.has_alpha && !red ? 255 - 128 * x / (width - 1) : 255;
        const int wanted[] = {red ? 200 : grey, red ? 30 : grey, red ? 30 : grey, alpha};
        for (int c = 0; c < 4; ++c)
          EXPECT_NEAR(image.rgba[static_cast<std::size_t>(4 * (width * y + x) + c)], wanted[c],
                      sample.step)
              << sample.name << " (" << x << ", " << y << ") channel " << c;
      }
  }
}
