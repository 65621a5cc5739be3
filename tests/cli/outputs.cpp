// Where results go: links are followed, pipes and devices written to and never replaced, "-" is standard input and output.
#include "core/error.h"
#include "core/files.h"
#include "support/errors.h"
#include "support/program.h"
#include "support/scratch.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

#include <cstdio>
#include <fstream>
#include <thread>

using namespace gg;
using namespace gg::test;
namespace fs = std::filesystem;

namespace {

void write(const fs::path& path, const std::string& text) {
  OutputFile file(path);
  file.write(text);
  file.commit();
}

// Through a shell, for what a shell does: pipes and redirections. The program is "$0".
std::string shell(const std::string& line) {
  const std::string command = "set -e; set -- ; G=" GROUNDGLASS_PROGRAM "; " + line;
  std::string out;
  std::FILE* const pipe = ::popen(("exec 2>&1; " + command).c_str(), "r");
  for (int ch; (ch = std::fgetc(pipe)) != EOF;)
    out += static_cast<char>(ch);
  out += ::pclose(pipe) == 0 ? "" : " (failed)";
  return out;
}

const std::string scene = "'" + asset("scenes/slabs-0.2.glb").string() + "'";

TEST(output, goes_through_links_and_leaves_them) {
  const fs::path here = scratch_directory();
  fs::create_directory(here / "data");
  scratch_file("old", "old");
  fs::rename(here / "old", here / "data/there");
  fs::create_symlink("data/there", here / "link");
  fs::create_symlink("link", here / "link-to-link");
  fs::create_symlink("data/new", here / "dangling");
  write(here / "link-to-link", "one");
  write(here / "dangling", "two");
  EXPECT_TRUE(fs::is_symlink(here / "link") && fs::is_symlink(here / "link-to-link"));
  EXPECT_TRUE(fs::is_symlink(here / "dangling"));
  EXPECT_EQ(read_text(here / "data/there"), "one");
  EXPECT_EQ(read_text(here / "data/new"), "two");
  EXPECT_EQ(std::distance(fs::directory_iterator(here / "data"), {}), 2); // no temporaries
}

TEST(output, to_a_pipe_is_written_and_the_pipe_stays) {
  const fs::path pipe = scratch_directory() / "pipe", link = scratch_directory() / "link";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  fs::create_symlink("pipe", link);
  for (const fs::path& path : {pipe, link}) {
    std::string got;
    std::thread reader([&] {
      std::ifstream in(pipe, std::ios::binary);
      got.assign(std::istreambuf_iterator<char>(in), {});
    });
    write(path, "text");
    reader.join();
    EXPECT_EQ(got, "text");
    EXPECT_TRUE(fs::is_fifo(pipe));
    EXPECT_TRUE(fs::is_symlink(link));
  }
}

TEST(output, that_a_device_refuses_is_an_error) {
  OutputFile file("/dev/full");
  file.write("text");
  EXPECT_TRUE(
      fails_with(ExitCode::output, {"/dev/full", "cannot be written"}, [&] { file.commit(); }));
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST(output, two_results_in_one_place_are_refused) {
  const fs::path here = scratch_directory();
  fs::create_symlink("a.png", here / "b.png");
  for (const auto& [a, b] :
       {std::pair(here / "a.png", here / "a.png"), std::pair(here / "a.png", here / "b.png"),
        std::pair(here / "a.png", here / "." / "a.png"),
        std::pair(fs::path("-"), fs::path("/dev/stdout"))})
    EXPECT_TRUE(fails_with(ExitCode::usage, {a.filename().string()},
                           [&] {
                             refuse_same_output({a, b});
                           }))
        << a << ' ' << b;
  EXPECT_NO_THROW(refuse_same_output({here / "a.png", here / "c.png", "", ""}));
  EXPECT_NO_THROW(refuse_same_output({"/dev/null", "/dev/null"}));
  const Finished both = run_program(
      {"capture", asset("scenes/slabs-0.2.glb"), "-o", here / "a.png", "--json", here / "b.png"});
  EXPECT_EQ(both.code, 2) << both.err;
}

TEST(standard_output, holds_json_alone_where_it_is_asked_for) {
  const std::string out = shell("$G needs " + scene + " --json - 2>/dev/null");
  EXPECT_TRUE(nlohmann::json::accept(out)) << out;
  EXPECT_EQ(shell("$G needs " + scene + " --json /dev/stdout 2>/dev/null"), out);
  // Redirected to a file, /dev/stdout is that file, which is not replaced while it is written to.
  const fs::path file = scratch_directory() / "out.json";
  EXPECT_EQ(shell("$G needs " + scene + " --json /dev/stdout 2>/dev/null >" + file.string()), "");
  EXPECT_EQ(read_text(file), out);
}

TEST(standard_output, holds_a_picture) {
  const std::string out =
      shell("$G capture " + scene + " --size 8x8 --samples 1 -o - 2>/dev/null | head -c 4");
  EXPECT_EQ(out, "\x89PNG");
}

TEST(standard_input, holds_a_scene_or_queries) {
  const std::string piped = shell("cat " + scene + " | $G needs - --json - 2>/dev/null");
  nlohmann::json a = nlohmann::json::parse(piped),
                 b = nlohmann::json::parse(shell("$G needs " + scene + " --json - 2>/dev/null"));
  a.erase("scene");
  b.erase("scene");
  EXPECT_EQ(a, b);
  const std::string row = "id,lobe,dist,alpha,eta,cn,ck,ix,iy,iz,ox,oy,oz,nx,ny,nz\n"
                          "one,R,ggx,0.3,1.5,0,0,0,0,1,0.6,0,0.8,0,0,1\n";
  const std::string values = shell("printf '%s' '" + row + "' | $G eval --in - -o - 2>/dev/null");
  EXPECT_TRUE(values.starts_with("id,D,G,")) << values;
  EXPECT_NE(values.find("\none,"), std::string::npos) << values;
}

} // namespace
