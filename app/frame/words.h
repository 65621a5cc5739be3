// The frame graph as text and as JSON.
#pragma once

#include "frame/declare.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace gg::frame {

std::string text_of(const needs::Needs& needs, const Graph& graph); // several lines
nlohmann::json json_of(const needs::Needs& needs, const Graph& graph);

} // namespace gg::frame
