// Damaged picture files: whatever the bytes, a picture or a gg::Error(input) that names the file;
// and pictures that cannot be written leave nothing behind. Under the sanitizers this is the test
// that the readers stay within their memory.
#include "core/error.h"
#include "core/files.h"
#include "image/image.h"
#include "robustness/damage.h"
#include "robustness/samples.h"
#include "support/errors.h"
#include "support/scratch.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>

using namespace gg;
using namespace gg::test;

namespace {

// Reads `count` damaged copies; all must end well. Returns how many were refused.
int survive(const Bytes& whole, const char* name, int count) {
  std::mt19937 random(20070625u);
  int refused = 0;
  for (int i = 0; i < count; ++i) {
    Bytes bytes = whole;
    damage(bytes, random);
    const std::filesystem::path path = scratch_file(name, bytes);
    try {
      const image::Image image = image::read(path);
      EXPECT_EQ(image.values.size(), image.index(0, image.height)) << i;
      EXPECT_GE(image.width, 1) << i;
    } catch (const Error& error) {
      ++refused;
      EXPECT_EQ(error.code(), ExitCode::input) << i << ": " << error.what();
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos)
          << i << ": " << error.what();
    }
  }
  return refused;
}

constexpr int copies = 400; // of each format: seconds under the sanitizers, on two busy cores

} // namespace

TEST(damaged_picture, hdr) {
  EXPECT_GT(survive(written(".hdr"), "damaged.hdr", copies), copies / 10);
}

TEST(damaged_picture, exr) {
  EXPECT_GT(survive(written(".exr"), "damaged.exr", copies), copies / 10);
}

TEST(damaged_picture, pfm) {
  EXPECT_GT(survive(written(".pfm"), "damaged.pfm", copies), copies / 100);
}

TEST(damaged_picture, png) {
  EXPECT_GT(survive(written(".png"), "damaged.png", copies), copies / 2);
}

TEST(damaged_picture, jpeg) {
  EXPECT_GT(survive(jpeg(false), "damaged.jpg", copies), copies / 10);
  EXPECT_GT(survive(jpeg(true), "damaged-progressive.jpg", copies), copies / 10);
}

TEST(damaged_picture, webp) {
  EXPECT_GT(survive(webp(false), "damaged.webp", copies), copies / 10);
  EXPECT_GT(survive(webp(true), "damaged-lossless.webp", copies), copies / 10);
}

TEST(damaged_picture, exr_with_checked_headers) {
  // Damage past the header only: the compressed blocks themselves.
  const Bytes whole = written(".exr");
  std::mt19937 random(3u);
  for (int i = 0; i < copies; ++i) {
    Bytes bytes = whole;
    bytes[350 + random() % (bytes.size() - 350)] ^= static_cast<std::byte>(1 + random() % 255);
    const std::filesystem::path path = scratch_file("blocks.exr", bytes);
    try {
      EXPECT_EQ(image::read(path).width, 33);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::input);
    }
  }
}

TEST(unwritable_picture, a_full_disk_leaves_neither_file_nor_temporary) {
  const std::filesystem::path here = scratch_directory();
  // A limit on the size of files fails in write(), as a full disk does.
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{.rlim_cur = 1000, .rlim_max = before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  std::vector<::testing::AssertionResult> results;
  for (const char* name : {"a.exr", "a.hdr", "a.pfm", "a.png"})
    results.push_back(fails_with(ExitCode::output, {name, "cannot be written"},
                                 [&] { image::write(here / name, sample(100, 100)); }));
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, old_handler);
  for (const auto& result : results)
    EXPECT_TRUE(result);
  EXPECT_TRUE(std::filesystem::is_empty(here));
}
