// groundglass eval: the BSDF's values for a file of directions.
#include "bsdf/evaluate.h"
#include "bsdf/query_file.h"
#include "commands/commands.h"
#include "core/error.h"
#include "core/files.h"
#include "core/progress.h"
#include "gpu/device.h"

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gg::commands {
namespace {

// Rows at a time: memory stays at some 30 MB however long the file is.
constexpr std::size_t batch_rows = 65536;

struct EvalOptions {
  std::filesystem::path in, out;
  std::string backend = "cpu", surface = "auto", form = "compensated";
  std::optional<int> device;
};

template <class Real, class Evaluate>
void answer_file(const EvalOptions& options, const Evaluate& evaluate) {
  bsdf::QueryReader reader(options.in);
  OutputFile out(options.out);
  out.write(bsdf::value_header());
  std::vector<std::string> ids;
  std::vector<bsdf::Query> queries;
  std::vector<bsdf::Values<Real>> values;
  std::string text;
  Progress progress("eval", 0);
  for (long done = 0; reader.next(batch_rows, ids, queries); progress.update(done)) {
    values.resize(queries.size());
    evaluate(queries, values);
    text.clear();
    bsdf::append_rows<Real>(text, ids, values);
    out.write(text);
    done += static_cast<long>(queries.size());
  }
  reader.expect_no_bad_rows();
  out.commit();
}

void run(const EvalOptions& options) {
  if (options.backend == "cpu") {
    answer_file<double>(
        options, [](const auto& queries, auto& values) { bsdf::evaluate_cpu(queries, values); });
    return;
  }
  const std::map<std::string, gpu::Surface> surfaces{{"auto", gpu::Surface::automatic},
                                                     {"egl", gpu::Surface::egl},
                                                     {"osmesa", gpu::Surface::osmesa}};
  const auto device = gpu::create_device({
      .backend = options.backend == "vulkan" ? gpu::Backend::vulkan : gpu::Backend::opengl,
      .surface = surfaces.at(options.surface),
      .device = options.device.value_or(-1),
  });
  bsdf::DeviceEvaluator evaluator(
      *device, options.form == "stable" ? bsdf::Form::stable : bsdf::Form::compensated, batch_rows);
  answer_file<float>(
      options, [&](const auto& queries, auto& values) { evaluator.evaluate(queries, values); });
}

} // namespace

void add_eval(Command program) {
  Command command = program.subcommand("eval", "Values of the BSDF for a file of directions (CSV)");
  const auto options = std::make_shared<EvalOptions>();
  command
      .option("--in", &options->in,
              "CSV of queries (app/README.md, \"Commands\"); - for standard input")
      .required();
  command.option("-o,--output", &options->out, "CSV of values; - for standard output").required();
  command.option("--backend", &options->backend, "cpu (double), opengl or vulkan (float32)")
      .one_of({"cpu", "opengl", "vulkan"});
  command
      .option("--form", &options->form,
              "Half-vector on the device: compensated, or stable as frames are drawn")
      .one_of({"compensated", "stable"});
  command.option("--surface", &options->surface, "Where opengl comes from: auto, egl or osmesa")
      .one_of({"auto", "egl", "osmesa"});
  command.option("--device", &options->device, "Index in the list of `groundglass devices`");
  command.action([options] { run(*options); });
}

} // namespace gg::commands
