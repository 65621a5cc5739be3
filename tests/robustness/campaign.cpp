// Many mutants of every kind of file that the program reads: each is drawn or refused in words, within seconds and within a
// bounded amount of memory. A mutant is told by its seed and its number, whatever was tried before it:
//   GROUNDGLASS_CAMPAIGN_SEED=S GROUNDGLASS_CAMPAIGN_FIRST=N GROUNDGLASS_CAMPAIGN_COUNT=1 test_campaign
#include "core/error.h"
#include "core/files.h"
#include "image/image.h"
#include "robustness/campaign_draw.h"
#include "robustness/counted.h"
#include "robustness/damage.h"
#include "robustness/samples.h"
#include "scene/grid.h"
#include "scene/load.h"
#include "support/scratch.h"

#include <gtest/gtest.h>
#include <sys/time.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <optional>

using namespace gg;
using namespace gg::test;
using nlohmann::json;

extern "C" const char* __asan_default_options() {
  return "allocator_may_return_null=1:detect_leaks=0";
}

namespace {

// What reading a file may take at its peak: 64 MiB and 256 times its size for what it unpacks to (document.cpp), twice
// over while streams are copied; 2 GiB for its pictures, or a panorama of as many pixels as are accepted (image.h); and what
// decoders take beside: at most seven bytes for each of as many pixels (libktx).
constexpr std::size_t memory_allowance = std::size_t{3} << 30;
constexpr std::size_t memory_per_byte = 512;

struct Sample {
  std::string name; // as the mutant's file is called
  Bytes bytes;
  bool is_environment = false;
};

std::vector<Sample> corpus() {
  std::vector<Sample> samples;
  const auto add_scene = [&](const std::string& name, const GltfFile& file) {
    samples.push_back({name, read_file(file.save("whole-" + name)), false});
  };
  add_scene("rich.glb", rich());
  samples.push_back({"rich.gltf", read_file(rich().save_text("whole.gltf")), false});
  // Alone, so that what is damaged is mostly the compressed stream itself.
  const auto add_compressed = [&](const std::string& name, json (*store)(GltfFile&, const Grid&)) {
    GltfFile file;
    file.mesh(store(file, Grid(12)));
    add_scene(name, file);
  };
  add_compressed("draco.glb", with_draco);
  add_compressed("edgebreaker.glb", with_edgebreaker);
  add_compressed("meshopt.glb", with_meshopt);
  add_scene("png.glb", textured(written(".png"), "image/png"));
  add_scene("jpeg.glb", textured(jpeg(false), "image/jpeg"));
  add_scene("progressive.glb", textured(jpeg(true), "image/jpeg"));
  add_scene("webp.glb", textured(webp(false), "image/webp"));
  add_scene("lossless.glb", textured(webp(true), "image/webp"));
  add_scene("ktx2.glb", textured(ktx2(), "image/ktx2"));
  for (const char* extension : {".hdr", ".exr", ".pfm"}) {
    const image::Image picture = sample(32, 16);
    const std::filesystem::path path = scratch_directory() / (std::string("whole") + extension);
    image::write(path, picture);
    samples.push_back({std::string("environment") + extension, read_file(path), true});
  }
  for (const char* name : {"slabs-0.2.glb", "AnisotropyStrengthTest.glb", "TransmissionTest.glb",
                           "layers.glb", "motion.glb"})
    samples.push_back({name, read_file(asset(std::string("scenes/") + name)), false});
  return samples;
}

// The JSON with one to three values changed; nothing if it is none.
std::string changed_json(std::string_view text, std::mt19937& random) {
  json root = json::parse(text, nullptr, false);
  if (root.is_discarded()) return {};
  for (auto changes = 1 + random() % 3; changes > 0; --changes) {
    json& at = pick(root, random);
    at = surprise(random, at);
  }
  return root.dump(-1, ' ', false, json::error_handler_t::replace);
}

// The JSON of a .gltf, or of a .glb whose binary chunk stays, with something else in it.
bool change_json(Bytes& bytes, bool is_glb, std::mt19937& random) {
  std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  Bytes binary;
  if (is_glb) {
    std::uint32_t length = 0;
    if (bytes.size() < 20) return false;
    std::memcpy(&length, bytes.data() + 12, 4);
    if (bytes.size() < 20 + std::size_t{length}) return false;
    text = text.substr(20, length);
    const std::size_t binary_at = std::min(bytes.size(), 20 + std::size_t{length} + 8);
    binary.assign(bytes.begin() + static_cast<std::ptrdiff_t>(binary_at), bytes.end());
  }
  std::string changed = changed_json(text, random);
  if (changed.empty()) return false;
  if (is_glb) changed = glb(changed, binary);
  bytes.resize(changed.size());
  std::memcpy(bytes.data(), changed.data(), changed.size());
  return true;
}

void mutate(Sample& sample, std::mt19937& random) {
  const bool is_glb = sample.name.ends_with(".glb");
  switch (random() % (is_glb || sample.name.ends_with(".gltf") ? 4 : 2)) {
  case 0:
    return damage(sample.bytes, random);
  case 1:
    return flip(sample.bytes, sample.bytes.size() / 3, random); // past the headers
  default:
    if (!change_json(sample.bytes, is_glb, random)) damage(sample.bytes, random);
  }
}

// Which mutant is being tried, for the handlers of signals.
std::atomic<unsigned> current_seed{0}, current_mutant{0};

void on_hang(int) {
  char text[128];
  const int length = std::snprintf(text, sizeof text, "campaign: mutant %u of seed %u hangs\n",
                                   current_mutant.load(), current_seed.load());
  (void)!::write(STDERR_FILENO, text, static_cast<std::size_t>(length));
  std::abort();
}

// Processor seconds until on_hang(): a busy machine makes nothing hang. What waits for ever is ended by ctest.
void limit_seconds(unsigned seconds) {
  const itimerval timer{.it_interval = {}, .it_value = {static_cast<time_t>(seconds), 0}};
  ::setitimer(ITIMER_PROF, &timer, nullptr);
}

unsigned from_environment(const char* name, unsigned otherwise) {
  const char* const text = std::getenv(name);
  return text ? static_cast<unsigned>(std::strtoul(text, nullptr, 10)) : otherwise;
}

} // namespace

TEST(campaign, every_mutant_is_drawn_or_refused_in_words) {
  constexpr unsigned hang_seconds = 10, drawn_each = 10;
  // Compilers of shaders are at work: a minute for glass on Vulkan where two busy cores are shared.
  constexpr unsigned draw_hang_seconds = 300;
  const unsigned seed = from_environment("GROUNDGLASS_CAMPAIGN_SEED", 20070625u);
  const unsigned begin = from_environment("GROUNDGLASS_CAMPAIGN_FIRST", 0u);
  const unsigned count =
      from_environment("GROUNDGLASS_CAMPAIGN_COUNT", GROUNDGLASS_CAMPAIGN_MUTANTS);
  std::signal(SIGPROF, on_hang);
  const std::vector<Sample> samples = corpus();
  unsigned accepted = 0, drawn = 0;
  double slowest = 0.0, most_memory = 0.0;
  current_seed = seed;
  for (unsigned i = begin; i < begin + count; ++i) {
    current_mutant = i;
    std::seed_seq both{seed, i};
    std::mt19937 random(both);
    Sample mutant = samples[random() % samples.size()];
    mutate(mutant, random);
    SCOPED_TRACE(mutant.name + ", mutant " + std::to_string(i) + " of seed "
                 + std::to_string(seed));
    const std::filesystem::path path = scratch_file(mutant.name, mutant.bytes);
    const Memory memory;
    limit_seconds(hang_seconds);
    const auto start = std::chrono::steady_clock::now();
    try {
      std::optional<scene::Scene> scene;
      if (mutant.is_environment)
        image::read(path);
      else
        scene = scene::load(path);
      slowest = std::max(
          slowest, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
      const std::size_t taken = memory.taken();
      most_memory = std::max(most_memory, static_cast<double>(taken) / (1 << 20));
      EXPECT_LE(taken, memory_allowance + memory_per_byte * mutant.bytes.size());
      if (accepted++ % drawn_each == 0) {
        limit_seconds(draw_hang_seconds);
        drawn += draw_small(path, scene ? &*scene : nullptr);
      }
    } catch (const Error& error) {
      EXPECT_LE(memory.taken(), memory_allowance + memory_per_byte * mutant.bytes.size());
      EXPECT_TRUE(error.code() == ExitCode::input || error.code() == ExitCode::unsupported)
          << error.what();
      EXPECT_NE(std::string(error.what()).find(mutant.name), std::string::npos) << error.what();
    } catch (const std::exception& error) {
      ADD_FAILURE() << error.what();
    }
    limit_seconds(0);
  }
  stop_drawing();
  std::printf("campaign: seed %u: %u mutants, %u accepted, %u drawn on both backends, slowest read "
              "%.2f s, most memory %.0f MiB\n",
              seed, count, accepted, drawn, slowest, most_memory);
  EXPECT_GE(accepted, count / 20);
}
