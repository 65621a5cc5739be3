// groundglass capture as a user meets it: what it writes, and what it says when it cannot.
#include "image/image.h"
#include "support/program.h"
#include "support/scratch.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>

namespace gg::test {
namespace {

namespace fs = std::filesystem;

const std::string suzanne = asset("scenes/Suzanne/Suzanne.gltf");
const std::string sky = asset("environments/studio_small_03_1k.hdr");

std::string bytes(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// Every complaint names what it is about, and leaves nothing behind.
void expect_refusal(const std::vector<std::string>& arguments, int code,
                    const std::string& naming) {
  const fs::path directory = scratch_directory();
  const Finished f = run_program(arguments);
  EXPECT_EQ(f.code, code) << f.err;
  EXPECT_NE(f.err.find(naming), std::string::npos)
      << "says: " << f.err << "\nshould name: " << naming;
  for (const auto& entry : fs::directory_iterator(directory))
    EXPECT_TRUE(entry.path().filename() == "stdout.txt" || entry.path().filename() == "stderr.txt"
                || entry.path().stem() == "input")
        << "left behind: " << entry.path();
}

std::string out(const char* name) {
  return scratch_directory() / name;
}

} // namespace

TEST(capture, draws_a_real_model_under_a_real_sky_and_reports_what_it_took) {
  const Finished f =
      run_program({"capture", suzanne, "-o", out("suzanne.exr"), "--env", sky, "--size", "160x90",
                   "--samples", "2", "--frames", "3", "--json", out("suzanne.json")});
  ASSERT_EQ(f.code, 0) << f.err;
  const image::Image picture = image::read(out("suzanne.exr"));
  EXPECT_EQ(picture.width, 160);
  EXPECT_EQ(picture.height, 90);
  const auto json = nlohmann::json::parse(bytes(out("suzanne.json")));
  EXPECT_EQ(json.at("triangles"), 3936);
  EXPECT_EQ(json.at("width"), 160);
  EXPECT_EQ(json.at("backend"), "opengl");
  EXPECT_GT(json.at("device_memory_bytes"), 0);
  EXPECT_GT(json.at("frame_ms").at("median"), 0.0);
  EXPECT_LE(json.at("frame_ms").at("min"), json.at("frame_ms").at("median"));
  EXPECT_LE(json.at("frame_ms").at("median"), json.at("frame_ms").at("p95"));
  EXPECT_LE(json.at("frame_ms").at("p95"), json.at("frame_ms").at("max"));
  for (const auto& label : json.at("passes"))
    EXPECT_TRUE(json.at("pass_ms").contains(label)) << label;
}

// Two runs draw the same radiance and the same display picture. The other kinds of files are written from a radiance that is there,
// without a device.
TEST(capture, same_command_writes_the_same_bytes) {
  const std::string radiance = out("a.exr");
  for (const char* extension : {".exr", ".png", ".jpg", ".hdr", ".pfm"}) {
    const bool drawn = extension == std::string(".exr") || extension == std::string(".png");
    const std::string a = out("a") + extension, b = out("b") + extension;
    for (const std::string& path : {a, b}) {
      const Finished f = drawn ? run_program({"capture", suzanne, "-o", path, "--env", sky,
                                              "--size", "64x48", "--samples", "2"})
                               : run_program({"convert", radiance, "-o", path});
      ASSERT_EQ(f.code, 0) << f.err;
    }
    EXPECT_TRUE(bytes(a) == bytes(b)) << extension; // not _EQ: it would print them
    EXPECT_FALSE(bytes(a).empty());
  }
}

TEST(capture, exposure_and_tone_map_change_the_png_and_not_the_radiance) {
  const auto shot = [](const char* name, std::vector<std::string> more) {
    std::vector<std::string> words{"capture", suzanne,  "-o",    out(name),   "--env",
                                   sky,       "--size", "64x48", "--samples", "1"};
    words.insert(words.end(), more.begin(), more.end());
    EXPECT_EQ(run_program(words).code, 0);
    return bytes(out(name));
  };
  const std::string plain = shot("plain.exr", {});
  EXPECT_EQ(plain, shot("bright.exr", {"--exposure", "2"}));
  EXPECT_NE(shot("plain.png", {}), shot("bright.png", {"--exposure", "2"}));
  EXPECT_NE(shot("neutral.png", {"--tonemap", "neutral"}), shot("agx.png", {"--tonemap", "agx"}));
}

TEST(capture, names_what_is_wrong_with_its_options) {
  const std::string png = out("picture.png");
  expect_refusal({"capture", suzanne}, 2, "--output");
  expect_refusal({"capture", suzanne, "-o", out("picture.gif")}, 2, "picture.gif");
  expect_refusal({"capture", suzanne, "-o", png, "--size", "12by9"}, 2, "--size");
  expect_refusal({"capture", suzanne, "-o", png, "--size", "0x9"}, 2, "--size");
  expect_refusal({"capture", suzanne, "-o", png, "--size", "99999x9"}, 2, "16384");
  expect_refusal({"capture", suzanne, "-o", png, "--samples", "0"}, 2, "--samples");
  expect_refusal({"capture", suzanne, "-o", png, "--method", "guess"}, 2, "guess");
  expect_refusal({"capture", suzanne, "-o", png, "--tonemap", "film"}, 2, "film");
  expect_refusal({"capture", suzanne, "-o", png, "--smith", "john"}, 2, "john");
  expect_refusal({"capture", suzanne, "-o", png, "--camera", "left"}, 2, "left");
  expect_refusal({"capture", suzanne, "-o", png, "--camera", "7"}, 2, "7");
  expect_refusal({"capture", suzanne, "-o", png, "--eye", "1,2"}, 2, "--eye");
  expect_refusal({"capture", suzanne, "-o", png, "--eye", "1,2,nan"}, 2, "--eye");
  expect_refusal({"capture", suzanne, "-o", png, "--eye", "0,0,0", "--target", "0,0,0"}, 2, "eye");
  expect_refusal({"capture", suzanne, "-o", png, "--fovy", "180"}, 2, "--fovy");
  expect_refusal({"capture", suzanne, "-o", png, "--exposure", "inf"}, 2, "--exposure");
  expect_refusal({"capture", suzanne, "-o", png, "--env-intensity", "-1"}, 2, "--env-intensity");
  expect_refusal({"capture", suzanne, "-o", png, "--material", "*=unobtainium"}, 2, "unobtainium");
  expect_refusal({"capture", suzanne, "-o", png, "--material", "no such=gold"}, 2, "no such");
  expect_refusal({"capture", suzanne, "-o", png, "--backend", "metal"}, 2, "metal");
  expect_refusal({"capture", suzanne, "-o", png, "--surface", "paper"}, 2, "paper");
  expect_refusal({"capture", suzanne, "-o", png, "--device", "99"}, 6, "99");
  expect_refusal({"capture", suzanne, "-o", png, "--frobnicate"}, 2, "frobnicate");
  expect_refusal({"paint"}, 2, "paint");
}

TEST(commands, ask_whether_something_near_was_meant) {
  const auto expect = [](const std::vector<std::string>& words, const std::string& meant,
                         int code = 2) {
    const Finished f = run_program(words);
    EXPECT_EQ(f.code, code) << f.err;
    EXPECT_TRUE(f.err.starts_with("groundglass: ")) << f.err;
    EXPECT_NE(f.err.find("Did you mean " + meant + "?"), std::string::npos) << f.err;
  };
  expect({"captrue", suzanne}, "capture");
  expect({"needs", asset("scenes/ball-gird.glb")}, "ball-grid.glb", 3);
  expect({"captur", suzanne, "-o", "a.png"}, "capture"); // not "-o is not an option"
  expect({"capture", suzanne, "--ouput", "a.png"}, "--output");
  expect({"capture", suzanne, "-o", out("a.png"), "--method", "lobs2"}, "lobes2");
  expect({"report", suzanne, "-o", out("report"), "--methods", "standrad"}, "standard");
  expect({"eval", "--in", "a.csv", "-o", out("a.csv"), "--backend", "vulcan"}, "vulkan");
}

TEST(commands, say_in_our_words_which_option_is_wrong) {
  const auto expect = [](const std::vector<std::string>& words, const std::string& part) {
    const Finished f = run_program(words);
    EXPECT_EQ(f.code, 2) << f.err;
    EXPECT_TRUE(f.err.starts_with("groundglass: ")) << f.err;
    EXPECT_NE(f.err.find(part), std::string::npos) << f.err;
  };
  expect({}, "no command is given");
  expect({"capture", suzanne, "-o", "a.png", "--samples", "many"},
         "--samples: 'many' is not a whole number");
  expect({"capture", suzanne, "-o", "a.png", "--fovy", "1e99"}, "--fovy: '1e99' is too large");
  expect({"capture", suzanne, "-o"}, "--output");
  expect({"report", suzanne, "-o", "a", "--methods", "foo"}, "--methods: 'foo'");
  expect({"truth", suzanne, "-o", "a.exr", "--spp", "4", "--error", ".1"},
         "--spp: is given with --error");
  expect({"capture"}, "SCENE: is missing");
  expect({"capture", suzanne, "-o", "a.png", "--samples", "1", "--samples", "2"},
         "--samples: is given more than once");
  expect({"--size", "8x8", "capture", suzanne, "-o", "a.png"}, "--size: stands before the command");
  expect({"capture", suzanne, sky, "-o", "a.png"}, "one argument too many");
}

TEST(capture, makes_the_folders_that_are_missing_and_leaves_none_behind_if_it_fails) {
  const fs::path inner = scratch_directory() / "new" / "inner";
  EXPECT_EQ(run_program({"capture", suzanne, "-o", inner / "a.exr", "--size", "8x8", "--env",
                         "none", "--device", "99"})
                .code,
            6);
  EXPECT_FALSE(fs::exists(inner.parent_path()));
  EXPECT_EQ(
      run_program({"capture", suzanne, "-o", inner / "a.exr", "--size", "8x8", "--env", "none"})
          .code,
      0);
  EXPECT_TRUE(fs::exists(inner / "a.exr"));
}

TEST(capture, names_the_file_that_it_cannot_read_or_write) {
  const std::string png = out("picture.png");
  expect_refusal({"capture", "/no/such/model.glb", "-o", png}, 3, "/no/such/model.glb");
  expect_refusal({"capture", suzanne, "-o", png, "--env", "/no/such/sky.hdr"}, 3,
                 "/no/such/sky.hdr");
  expect_refusal({"capture", suzanne, "-o", png, "--env", suzanne}, 3, "Suzanne.gltf");
  expect_refusal({"capture", sky, "-o", png}, 3, "studio_small_03_1k.hdr");
  expect_refusal({"capture", suzanne, "-o", "/dev/null/picture.png"}, 5, "/dev/null/picture.png");
  expect_refusal({"capture", suzanne, "-o", png, "--json", "/dev/null/times.json"}, 5,
                 "/dev/null/times.json");
}

TEST(capture, a_missing_driver_is_a_message_that_says_what_to_install) {
  const auto without = [](std::vector<std::string> words, const std::string& variable) {
    words.insert(words.begin(), {"capture", suzanne, "-o", out("picture.png"), "--size", "32x32"});
    const Finished f = run_program(words, {variable + "=/nonexistent"});
    EXPECT_EQ(f.code, 6) << f.err;
    EXPECT_NE(f.err.find("nstall"), std::string::npos) << f.err;
  };
  without({"--surface", "egl"}, "LIBGL_DRIVERS_PATH");
  without({"--backend", "vulkan"}, "VK_ICD_FILENAMES");
}

TEST(capture, says_what_it_wrote_and_prints_the_times_that_were_asked_for) {
  const Finished f =
      run_program({"capture", suzanne, "-o", out("a.jpg"), "--env", "studio_small_03", "--size",
                   "32x24", "--samples", "2", "--frames", "2"});
  ASSERT_EQ(f.code, 0) << f.err;
  for (const char* part :
       {"a.jpg: 32 x 24 pixels, lobes2 on opengl, 2 samples per pixel in",
        "2 frames of one sample per pixel: median", "0 resources created", "opaque"})
    EXPECT_NE(f.out.find(part), std::string::npos) << part << " in " << f.out;
}

TEST(capture, takes_environments_by_name_and_asks_whether_another_was_meant) {
  const auto with = [](const char* name, const std::string& env) {
    return run_program(
        {"capture", suzanne, "-o", out(name), "--env", env, "--size", "16x12", "--samples", "1"});
  };
  EXPECT_EQ(with("name.exr", "studio_small_03").code, 0);
  EXPECT_EQ(with("file.exr", sky).code, 0);
  EXPECT_EQ(bytes(out("name.exr")), bytes(out("file.exr")));
  const Finished wrong = with("wrong.exr", "studio_smal_03");
  EXPECT_EQ(wrong.code, 3);
  EXPECT_NE(wrong.err.find("Did you mean studio_small_03?"), std::string::npos) << wrong.err;
  EXPECT_NE(with("wrong.exr", "1,1").err.find("a colour R,G,B"), std::string::npos);
}

TEST(convert_command, shows_radiance_as_capture_does) {
  const auto draw = [](const char* name) {
    EXPECT_EQ(run_program({"capture", suzanne, "-o", out(name), "--env", sky, "--size", "32x24",
                           "--samples", "1", "--exposure", "1"})
                  .code,
              0);
  };
  draw("radiance.exr");
  draw("shown.png");
  const Finished again =
      run_program({"convert", out("radiance.exr"), "-o", out("again.png"), "--exposure", "1"});
  ASSERT_EQ(again.code, 0);
  EXPECT_NE(again.out.find("again.png: 32 x 24 pixels"), std::string::npos) << again.out;
  EXPECT_EQ(bytes(out("again.png")), bytes(out("shown.png")));
  EXPECT_EQ(run_program({"convert", out("radiance.exr"), "-o", out("again.gif")}).code, 2);
}

TEST(list_command, names_what_the_options_take) {
  const Finished all = run_program({"list"});
  EXPECT_EQ(all.code, 0);
  for (const char* name : {"gold", "bk7", "satin", "royal_esplanade\n", "lobes2", "auto"})
    EXPECT_NE(all.out.find(name), std::string::npos) << name;
  const Finished methods = run_program({"list", "methods"});
  EXPECT_EQ(methods.out.find("gold"), std::string::npos);
  EXPECT_EQ(run_program({"list", "colours"}).code, 2);
}

TEST(devices_command, writes_its_list_as_json) {
  const Finished f = run_program({"devices", "--json", "-"});
  ASSERT_EQ(f.code, 0) << f.err;
  const auto devices = nlohmann::json::parse(f.out);
  EXPECT_GE(devices.at("schema"), 2);
  EXPECT_EQ(devices.at("devices").at(0).at("device"), 0);
}

TEST(commands, help_lists_every_command_and_exits_with_0) {
  const Finished f = run_program({"--help"});
  EXPECT_EQ(f.code, 0);
  for (const char* name : {"capture", "compare", "devices", "eval", "figures", "tables", "truth",
                           "report", "needs", "view", "snippet"})
    EXPECT_NE(f.out.find(name), std::string::npos) << name;
  EXPECT_EQ(run_program({"--version"}).code, 0);
}

} // namespace gg::test
