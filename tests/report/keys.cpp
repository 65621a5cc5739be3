// What a cached result is known by: everything that it depends on, and nothing else.
#include "report/cache.h"
#include "report/key.h"
#include "support/errors.h"
#include "support/scratch.h"

#include <gtest/gtest.h>

#include <fstream>
#include <set>

namespace gg::report {
namespace {

namespace fs = std::filesystem;

// A glTF that refers to a file beside it; what is in both decides the key.
fs::path gltf(const std::string& generator, const std::string& payload) {
  test::scratch_file("a b.bin", payload);
  return test::scratch_file("scene.gltf",
                            R"({"asset":{"version":"2.0","generator":")" + generator
                                + R"("},"buffers":[{"uri":"a%20b.bin","byteLength":4}]})");
}

} // namespace

TEST(key, tells_apart_texts_that_join_to_the_same) {
  EXPECT_NE(Key().add("ab").add("c").text(), Key().add("a").add("bc").text());
  EXPECT_NE(Key().add("").text(), Key().text());
  EXPECT_NE(Key().add(1.0).text(), Key().add(2.0).text());
  EXPECT_EQ(Key().add("a").add(1.0).text(), Key().add("a").add(1.0).text());
}

TEST(key, of_a_scene_changes_with_the_file_and_with_what_it_refers_to) {
  std::set<std::string> keys{key_of_gltf(gltf("one", "1234"))};
  EXPECT_TRUE(keys.insert(key_of_gltf(gltf("two", "1234"))).second);
  EXPECT_TRUE(keys.insert(key_of_gltf(gltf("two", "1235"))).second);
  EXPECT_FALSE(keys.insert(key_of_gltf(gltf("one", "1234"))).second);
}

TEST(key, of_a_scene_that_lacks_a_file_names_it) {
  const fs::path scene = gltf("one", "1234");
  fs::remove(scene.parent_path() / "a b.bin");
  EXPECT_TRUE(test::fails_with(ExitCode::input, {"scene.gltf", "buffers[0].uri", "a b.bin"},
                               [&] { key_of_gltf(scene); }));
}

TEST(key, of_a_tree_changes_with_names_and_contents) {
  const fs::path tree = test::scratch_directory() / "tree";
  const auto write = [&](const char* name, const char* text) {
    fs::create_directories((tree / name).parent_path());
    std::ofstream(tree / name) << text;
  };
  write("a/x.txt", "1");
  const std::string first = key_of_tree(tree);
  EXPECT_EQ(first, key_of_tree(tree));
  write("a/x.txt", "2");
  EXPECT_NE(first, key_of_tree(tree));
  write("a/x.txt", "1");
  fs::rename(tree / "a/x.txt", tree / "a/y.txt");
  EXPECT_NE(first, key_of_tree(tree));
}

TEST(cache, gives_back_what_was_stored_and_nothing_for_what_is_damaged) {
  const Cache cache(test::scratch_directory() / "deep" / "cache");
  EXPECT_FALSE(cache.json("times", "0"));
  cache.store("times", "0", {{"ms", 1.25}});
  EXPECT_EQ(cache.json("times", "0")->at("ms"), 1.25);
  std::ofstream(cache.path("times", "0", "json")) << "{\"ms\": 1.";
  EXPECT_FALSE(cache.json("times", "0"));
  const std::vector<std::byte> bytes{std::byte{1}, std::byte{0}, std::byte{255}};
  cache.store("shown", "0", "webp", bytes);
  EXPECT_EQ(*cache.bytes("shown", "0", "webp"), bytes);
}

TEST(cache, that_cannot_be_made_is_an_error_that_names_it) {
  const fs::path file = test::scratch_file("file", "");
  EXPECT_TRUE(test::fails_with(ExitCode::output, {"cache"}, [&] { Cache cache(file / "cache"); }));
}

} // namespace gg::report
