// KTX2: what is checked before libktx sees a file, and what is taken of what it gives back.
#include "core/error.h"
#include "core/files.h"
#include "image/image.h"
#include "support/errors.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>

using namespace gg;
using namespace gg::test;

namespace {

std::vector<std::byte> sample(const std::string& name) {
  return read_file(std::string(GROUNDGLASS_SOURCE_DIR "/tests/image/ktx2/") + name);
}

image::Image8 decoded(const std::vector<std::byte>& bytes) {
  return image::decode(bytes.data(), bytes.size(), "a.ktx2");
}

void use_libktx(const char* path) {
  ::setenv("GROUNDGLASS_LIBKTX", path, 1);
}

TEST(ktx2, without_libktx_it_says_what_to_install) {
  use_libktx("/nowhere/libktx.so");
  EXPECT_FALSE(image::can_decode_ktx2());
  EXPECT_TRUE(fails_with(ExitCode::unsupported, {"a.ktx2", "libktx", "app/setup --ktx2", "PNG"},
                         [] { decoded(sample("uastc_zstd.ktx2")); }));
}

TEST(ktx2, the_largest_level_is_taken) {
  use_libktx(GROUNDGLASS_LIBKTX_STAND_IN);
  ASSERT_TRUE(image::can_decode_ktx2());
  const image::Image8 image = decoded(sample("uastc_zstd.ktx2"));
  ASSERT_EQ(image.width, 20);
  ASSERT_EQ(image.height, 12);
  ASSERT_EQ(image.rgba.size(), 4u * 20 * 12);
  for (std::size_t y = 0; y < 12; ++y)
    for (std::size_t x = 0; x < 20; ++x) {
      EXPECT_EQ(image.rgba[4 * (20 * y + x)], x);
      EXPECT_EQ(image.rgba[4 * (20 * y + x) + 1], y);
    }
}

// Every field of the head that says what there is to come, wrong in turn: (place, value, what the message names).
TEST(ktx2, a_head_that_asks_for_what_the_file_does_not_hold_is_refused_before_libktx_sees_it) {
  use_libktx(GROUNDGLASS_LIBKTX_STAND_IN);
  struct Fault {
    std::size_t at;
    std::uint32_t value;
    const char* named;
  };
  constexpr std::size_t first_level = 80;
  const Fault faults[] = {{12, 43, "VkFormat 43"},
                          {20, 0, "0 x 12"},
                          {24, 1u << 20, "20 x 1048576"},
                          {28, 4, "volume"},
                          {32, 2, "array"},
                          {36, 6, "cube"},
                          {40, 99, "99 levels"},
                          {44, 3, "scheme 3"},
                          {first_level, 1u << 30, "level 0"},
                          {first_level + 8, 1u << 30, "level 0"},
                          {first_level + 12, 1, "level 0"},
                          {first_level + 16, 1u << 30, "1073741824 bytes"},
                          {first_level + 24 + 20, 1, "level 1"}};
  for (const Fault& fault : faults) {
    std::vector<std::byte> bytes = sample("uastc_zstd.ktx2");
    std::memcpy(bytes.data() + fault.at, &fault.value, sizeof fault.value);
    EXPECT_TRUE(fails_with(ExitCode::input, {"a.ktx2", fault.named}, [&] { decoded(bytes); }))
        << fault.at;
  }
  const std::vector<std::byte> whole = sample("uastc_zstd.ktx2");
  for (const std::size_t size : {12u, 79u, 80u, 199u, 300u})
    EXPECT_TRUE(fails_with(ExitCode::input, {"a.ktx2"}, [&] {
      decoded({whole.begin(), whole.begin() + size});
    })) << size;
}

} // namespace
