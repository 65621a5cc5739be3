// The three ways of writing the model, on the device: their values for a file of queries, and what
// each costs.
//   stability_variants opengl|vulkan values textbook|stable|compensated QUERIES.csv VALUES.csv
//   stability_variants opengl|vulkan cost QUERIES.csv
// The queries whose time is taken are the rows of the file, in each lobe and distribution those
// that belong to it.
#include "bsdf/evaluate.h"
#include "bsdf/packed.h"
#include "bsdf/query_file.h"
#include "core/error.h"
#include "core/files.h"
#include "gpu/device.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <string>
#include <vector>

namespace {

using namespace gg;

constexpr std::size_t group_size = 64; // local_size_x of variants.comp
constexpr std::size_t timed_rows = std::size_t{1} << 16;
constexpr std::int32_t timed_repeats = 16; // evaluations per row: the memory's share becomes small
constexpr int timed_runs = 15;             // of which the fastest counts: the others were disturbed

const std::vector<std::string> ways = {"textbook", "stable", "compensated"};

class Runner {
public:
  Runner(gpu::Device& device, std::span<const bsdf::Query> queries) : device_(device) {
    std::vector<bsdf::PackedQuery> packed(queries.size());
    std::transform(queries.begin(), queries.end(), packed.begin(), bsdf::pack);
    rows_ = packed.size();
    queries_ = device.create(gpu::BufferDesc{.label = "queries",
                                             .bytes = rows_ * sizeof(bsdf::PackedQuery),
                                             .use = gpu::Use::storage},
                             std::as_bytes(std::span(packed)));
    answers_ = device.create(gpu::BufferDesc{.label = "answers",
                                             .bytes = rows_ * sizeof(bsdf::PackedValues),
                                             .use = gpu::Use::storage | gpu::Use::read_back});
  }

  gpu::PipelineRef pipeline(const std::vector<gpu::Constant>& constants) {
    return device_.create(
        gpu::ComputeDesc{.label = "variants",
                         .compute = GROUNDGLASS_SOURCE_DIR "/tests/stability/variants.comp",
                         .constants = constants});
  }

  // Milliseconds: on a GPU by its own clock; of a software device the processor time of all its threads, which other
  // work on the machine stretches less.
  double run(const gpu::PipelineRef& pipeline) {
    gpu::Pass pass;
    pass.label = "variants";
    pass.reads_buffers = {queries_};
    pass.writes_buffers = {answers_};
    pass.record = [&](gpu::Encoder& encoder) {
      encoder.use(pipeline);
      encoder.buffer("Queries", queries_);
      encoder.buffer("Answers", answers_);
      encoder.dispatch(static_cast<std::uint32_t>((rows_ + group_size - 1) / group_size), 1, 1);
    };
    std::vector<gpu::PassTime> times;
    const std::clock_t start = std::clock();
    device_.run(std::span(&pass, 1), &times);
    device_.finish();
    const std::clock_t used = std::clock() - start;
    return device_.info().software ? 1e3 * static_cast<double>(used) / CLOCKS_PER_SEC
                                   : times.at(0).ms;
  }

  std::vector<bsdf::Values<float>> answers() {
    const auto bytes = device_.read(answers_, 0, rows_ * sizeof(bsdf::PackedValues));
    std::vector<bsdf::PackedValues> packed(rows_);
    std::memcpy(packed.data(), bytes.data(), bytes.size());
    std::vector<bsdf::Values<float>> values(rows_);
    std::transform(packed.begin(), packed.end(), values.begin(), bsdf::unpack);
    return values;
  }

private:
  gpu::Device& device_;
  gpu::BufferRef queries_, answers_;
  std::size_t rows_ = 0;
};

struct Rows {
  std::vector<std::string> ids;
  std::vector<bsdf::Query> queries;
};

Rows read_rows(const std::string& path) {
  Rows rows;
  bsdf::QueryReader reader(path);
  reader.next(~std::size_t{0}, rows.ids, rows.queries);
  reader.expect_no_bad_rows();
  return rows;
}

void write_values(gpu::Device& device, const std::string& way, const Rows& rows,
                  const std::string& path) {
  const auto found = std::find(ways.begin(), ways.end(), way);
  if (found == ways.end()) throw Error(ExitCode::usage, way, "is none of the ways");
  Runner runner(device, rows.queries);
  runner.run(runner.pipeline({gpu::constant(0, static_cast<std::int32_t>(found - ways.begin()))}));
  std::string text = bsdf::value_header();
  bsdf::append_rows<float>(text, rows.ids, runner.answers());
  OutputFile out(path);
  out.write(text);
  out.commit();
}

// The rows of one lobe and distribution that a facet joins, again and again up to timed_rows.
std::vector<bsdf::Query> timed_queries(const Rows& rows, bsdf::Lobe lobe,
                                       bsdf::Distribution distribution) {
  std::vector<bsdf::Values<double>> values(rows.queries.size());
  bsdf::evaluate_cpu(rows.queries, values);
  std::vector<bsdf::Query> kept, all;
  for (std::size_t row = 0; row < rows.queries.size(); ++row) {
    const bsdf::Query& q = rows.queries[row];
    const bool joined = values[row][0] > 0.0; // D
    if (q.lobe == lobe && q.distribution == distribution && q.eta > 0.0f && joined)
      kept.push_back(q);
  }
  if (kept.empty()) throw Error(ExitCode::input, "cost", "the file has no row to time");
  while (all.size() < timed_rows)
    all.push_back(kept[all.size() % kept.size()]);
  return all;
}

// The fastest run of each way, and of the loop without any, in ms.
std::vector<double> fastest(gpu::Device& device, const Rows& rows, bsdf::Lobe lobe,
                            bsdf::Distribution distribution) {
  Runner runner(device, timed_queries(rows, lobe, distribution));
  std::vector<gpu::PipelineRef> pipelines;
  for (std::size_t way = 0; way <= ways.size(); ++way)
    pipelines.push_back(runner.pipeline(
        {gpu::constant(0, static_cast<std::int32_t>(way)), gpu::constant(1, timed_repeats),
         gpu::constant(2, lobe == bsdf::Lobe::transmission),
         gpu::constant(3, static_cast<std::int32_t>(distribution))}));
  std::vector<double> best(pipelines.size(), 1e30);
  // In turn, so that a slow moment of the machine meets all of them. The first run compiles.
  for (int turn = 0; turn <= timed_runs; ++turn)
    for (std::size_t way = 0; way < best.size(); ++way) {
      const double ms = runner.run(pipelines[way]);
      if (turn > 0) best[way] = std::min(best[way], ms);
    }
  return best;
}

void print_cost(gpu::Device& device, const Rows& rows) {
  fmt::print("{} per evaluation of f on {} ({}), the loop around it taken off:\n\n"
             "| lobe | distribution | textbook | stable | compensated | stable / textbook | "
             "compensated / textbook |\n|---|---|---|---|---|---|---|\n",
             device.info().software ? "ns of one core" : "ns", device.info().name,
             device.info().backend);
  const char* distributions[] = {"GGX", "Beckmann", "Phong"};
  for (const auto lobe : {bsdf::Lobe::reflection, bsdf::Lobe::transmission})
    for (const auto distribution :
         {bsdf::Distribution::ggx, bsdf::Distribution::beckmann, bsdf::Distribution::phong}) {
      const auto best = fastest(device, rows, lobe, distribution);
      const auto ns = [&](std::size_t way) {
        return (best[way] - best.back()) * 1e6 / static_cast<double>(timed_rows * timed_repeats);
      };
      fmt::print("| {} | {} | {:.1f} | {:.1f} | {:.1f} | {:.2f} | {:.2f} |\n",
                 lobe == bsdf::Lobe::reflection ? "reflection" : "transmission",
                 distributions[static_cast<int>(distribution)], ns(0), ns(1), ns(2), ns(1) / ns(0),
                 ns(2) / ns(0));
    }
}

} // namespace

int main(int argc, char** argv) try {
  const std::vector<std::string> words(argv + 1, argv + argc);
  const bool values = words.size() == 5 && words[1] == "values";
  const bool cost = words.size() == 3 && words[1] == "cost";
  if (!values && !cost) {
    std::fputs("stability_variants opengl|vulkan values textbook|stable|compensated QUERIES.csv "
               "VALUES.csv\n"
               "stability_variants opengl|vulkan cost QUERIES.csv\n",
               stderr);
    return static_cast<int>(ExitCode::usage);
  }
  const auto device = gpu::create_device(
      {.backend = words[0] == "vulkan" ? gpu::Backend::vulkan : gpu::Backend::opengl});
  if (values)
    write_values(*device, words[2], read_rows(words[3]), words[4]);
  else
    print_cost(*device, read_rows(words[2]));
  return 0;
} catch (const gg::Error& error) {
  std::fprintf(stderr, "stability_variants: %s\n", error.what());
  return static_cast<int>(error.code());
}
