// Names for pipelines by what they are made of.
#pragma once

#include "gpu/types.h"

#include <string>

namespace gg::gpu {

// All that a pipeline is made of but its label: descriptions with equal keys make equal pipelines.
std::string key_of(const PipelineDesc& desc);
std::string key_of(const ComputeDesc& desc);

} // namespace gg::gpu
