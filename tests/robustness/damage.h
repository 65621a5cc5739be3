// Seeded damage.
#pragma once

#include "robustness/samples.h"

#include <random>

namespace gg::test {

// Bits flipped, bytes set to what breaks arithmetic, parts cut out, doubled or moved, mostly near the start, where headers
// are.
void damage(Bytes& bytes, std::mt19937& random);
// Up to eight bits flipped, at `from` or later.
void flip(Bytes& bytes, std::size_t from, std::mt19937& random);

// A random member of a JSON value, at any depth.
nlohmann::json& pick(nlohmann::json& value, std::mt19937& random);
// Something else in its place: of another type, too large, negative, empty, ...
nlohmann::json surprise(std::mt19937& random, const nlohmann::json& old);

} // namespace gg::test
