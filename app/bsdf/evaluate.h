// Answers queries: in double on the processor, in float32 on a device. The same text of
// shaders/bsdf either way.
#pragma once

#include "bsdf/query.h"
#include "gpu/device.h"

#include <span>

namespace gg::bsdf {

// With the compensated half-vector: right to some 1e-14 wherever the model itself is continuous.
void evaluate_cpu(std::span<const Query> queries, std::span<Values<double>> values);

// Which half-vector the device uses.
enum class Form {
  stable,      // half_vector.glsl: what a frame draws with
  compensated, // compensated.glsl: the rounding of its sums carried along
};

// Answers batches of up to `limit` queries on a device, which has to outlive this.
class DeviceEvaluator {
public:
  DeviceEvaluator(gpu::Device& device, Form form, std::size_t limit);
  void evaluate(std::span<const Query> queries, std::span<Values<float>> values);

private:
  gpu::Device& device_;
  gpu::PipelineRef pipeline_;
  gpu::BufferRef queries_, answers_;
};

} // namespace gg::bsdf
