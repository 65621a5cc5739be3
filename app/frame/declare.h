// The frame of a scene: its passes in order.
#pragma once

#include "frame/graph.h"
#include "needs/needs.h"

#include <cstddef>
#include <string>
#include <vector>

namespace gg::frame {

// Pure. `needs` must outlive the result.
Graph graph_of(const needs::Needs& needs);

// Bytes on the device by what they are for.
struct Share {
  std::string of;
  std::size_t bytes = 0;
};
std::vector<Share> memory_of(const needs::Needs& needs, const Graph& graph);
std::size_t bytes_of(const std::vector<Share>& memory); // together

} // namespace gg::frame
