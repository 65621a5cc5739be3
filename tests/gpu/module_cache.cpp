// Specialised shaders kept on disk: used where they are sound and of the same text, made again where they are not.
#include "gpu/shaders/module_cache.h"

#include "core/files.h"
#include "core/sealed.h"
#include "gpu/fixture.h"
#include "gpu/shaders/compile.h"
#include "support/cache_in.h"

#include <chrono>
#include <fstream>

namespace gg::gpu::shaders {
namespace {
namespace fs = std::filesystem;

constexpr const char* magic = "ggtests1";

std::vector<std::byte> some_bytes(std::size_t count) {
  std::vector<std::byte> bytes(count);
  for (std::size_t i = 0; i < count; ++i)
    bytes[i] = static_cast<std::byte>(i * 37 + 11);
  return bytes;
}

TEST(sealed, what_is_sealed_comes_back) {
  for (const std::size_t count : {0, 1, 1000})
    EXPECT_EQ(unseal(seal(some_bytes(count), magic), magic), some_bytes(count));
}

TEST(sealed, any_damage_is_noticed) {
  const auto sealed = seal(some_bytes(100), magic);
  for (std::size_t i = 0; i < sealed.size(); ++i) {
    auto damaged = sealed;
    damaged[i] ^= std::byte{1};
    EXPECT_FALSE(unseal(damaged, magic)) << "byte " << i;
  }
  for (std::size_t size = 0; size < sealed.size(); ++size)
    EXPECT_FALSE(unseal(std::span(sealed).first(size), magic)) << size << " bytes";
  auto longer = sealed;
  longer.push_back(std::byte{0});
  EXPECT_FALSE(unseal(longer, magic));
}

TEST(sealed, bytes_of_another_kind_are_not_taken) {
  EXPECT_FALSE(unseal(seal(some_bytes(10), magic), "ggtests2"));
}

std::vector<fs::path> files_in(const fs::path& directory) {
  return test::kept_files(directory, "shaders");
}

void write(const fs::path& path, const std::string& text) {
  std::ofstream(path) << text;
}

TEST(module_cache, a_linked_stage_is_kept_and_read_back_the_same) {
  const fs::path directory = test::empty_directory("module-cache");
  const test::CacheIn moved(directory);
  const std::vector<std::string> stages = {stage("square.comp")};
  const Program first = link("square", stages, {}, Backend::vulkan);
  ASSERT_EQ(files_in(directory).size(), 1u);
  const auto key = module_key(stages[0], {}, Backend::vulkan);
  ASSERT_TRUE(key);
  const auto kept = load_module(*key, stages[0]);
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->words, first.modules[0].words);
  EXPECT_EQ(kept->name, first.modules[0].name);
  EXPECT_EQ(kept->stage, Stage::compute);
  EXPECT_EQ(link("square", stages, {}, Backend::vulkan).bindings.size(), first.bindings.size());
}

TEST(module_cache, a_damaged_file_is_made_again) {
  const fs::path directory = test::empty_directory("module-cache-damaged");
  const test::CacheIn moved(directory);
  const std::vector<std::string> stages = {stage("square.comp")};
  const std::vector<std::uint32_t> words =
      link("square", stages, {}, Backend::opengl).modules[0].words;
  const fs::path file = files_in(directory).at(0);
  const auto sound = read_file(file);
  for (const std::string& damaged :
       {std::string(), std::string("not SPIR-V"), std::string(4000, 'x')}) {
    write(file, damaged);
    EXPECT_EQ(link("square", stages, {}, Backend::opengl).modules[0].words, words);
    EXPECT_EQ(read_file(file), sound);
  }
}

// Of texts that the process has not read before: each is read once.
TEST(module_cache, a_key_is_of_the_text_of_all_included_files_the_constants_and_the_api) {
  const fs::path directory = test::empty_directory("module-cache-keys");
  const test::CacheIn moved(directory);
  int count = 0;
  const auto key = [&](const std::string& inner, const std::vector<Constant>& constants,
                       Backend backend) {
    const fs::path folder = directory / std::to_string(count++);
    fs::create_directories(folder);
    write(folder / "inner.glsl", inner);
    write(folder / "outer.glsl", "  #include \"inner.glsl\"\n");
    write(folder / "x.frag", "#version 450\n#include \"outer.glsl\"\nvoid main() {}\n");
    return module_key((folder / "x.frag").string(), constants, backend).value();
  };
  const std::string plain = key("float a;", {}, Backend::opengl);
  EXPECT_EQ(key("float a;", {}, Backend::opengl), plain);
  EXPECT_NE(key("float b;", {}, Backend::opengl), plain);
  EXPECT_NE(key("float a;", {constant(3, true)}, Backend::opengl), plain);
  EXPECT_NE(key("float a;", {constant(3, true)}, Backend::opengl),
            key("float a;", {constant(3, false)}, Backend::opengl));
  EXPECT_NE(key("float a;", {}, Backend::vulkan), plain);
}

TEST(module_cache, past_its_most_files_the_oldest_go_at_the_first_that_is_stored) {
  const fs::path directory = test::empty_directory("module-cache-full");
  const test::CacheIn moved(directory);
  const fs::path kept = directory / "groundglass" / "shaders";
  fs::create_directories(kept);
  for (int i = 0; i < 1000; ++i) {
    const fs::path file = kept / (std::to_string(i) + ".spv");
    write(file, "");
    fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(1 + i));
  }
  link("square", std::vector<std::string>{stage("square.comp")}, {}, Backend::vulkan);
  EXPECT_EQ(files_in(directory).size(), 500u);
  EXPECT_TRUE(fs::exists(kept / "0.spv"));
  EXPECT_FALSE(fs::exists(kept / "999.spv"));
  EXPECT_TRUE(fs::exists(kept / (*module_key(stage("square.comp"), {}, Backend::vulkan) + ".spv")));
}

} // namespace
} // namespace gg::gpu::shaders
