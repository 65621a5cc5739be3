#include "bsdf/evaluate.h"
#include "bsdf/packed.h"

#include <algorithm>
#include <cstring>
#include <vector>

namespace gg::bsdf {
namespace {

// local_size_x of shaders/stages/eval.comp.
constexpr std::size_t group_size = 64;

} // namespace

DeviceEvaluator::DeviceEvaluator(gpu::Device& device, Form form, std::size_t limit)
    : device_(device), pipeline_(device.create(gpu::ComputeDesc{
                           .label = "eval",
                           .compute = "eval.comp",
                           .constants = {gpu::constant(0, form == Form::compensated)}})),
      queries_(device.create(gpu::BufferDesc{
          .label = "queries", .bytes = limit * sizeof(PackedQuery), .use = gpu::Use::storage})),
      answers_(device.create(gpu::BufferDesc{.label = "answers",
                                             .bytes = limit * sizeof(PackedValues),
                                             .use = gpu::Use::storage | gpu::Use::read_back})) {}

void DeviceEvaluator::evaluate(std::span<const Query> queries, std::span<Values<float>> values) {
  std::vector<PackedQuery> packed(queries.size());
  std::transform(queries.begin(), queries.end(), packed.begin(), pack);
  const std::size_t query_bytes = packed.size() * sizeof(PackedQuery);
  const std::size_t answer_bytes = packed.size() * sizeof(PackedValues);
  device_.upload(queries_, 0, std::as_bytes(std::span(packed)));

  gpu::Pass pass;
  pass.label = "eval";
  pass.reads_buffers = {queries_};
  pass.writes_buffers = {answers_};
  pass.record = [&](gpu::Encoder& encoder) {
    encoder.use(pipeline_);
    // Bound to the rows of this batch, so that the shader knows their number from the buffer's
    // length.
    encoder.buffer("Queries", queries_, 0, query_bytes);
    encoder.buffer("Answers", answers_, 0, answer_bytes);
    encoder.dispatch(static_cast<std::uint32_t>((packed.size() + group_size - 1) / group_size), 1,
                     1);
  };
  device_.run(std::span(&pass, 1));

  const std::vector<std::byte> bytes = device_.read(answers_, 0, answer_bytes);
  std::vector<PackedValues> answers(packed.size());
  std::memcpy(answers.data(), bytes.data(), answer_bytes);
  std::transform(answers.begin(), answers.end(), values.begin(), unpack);
}

} // namespace gg::bsdf
