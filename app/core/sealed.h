// Bytes with a checksum around them: what a cache wrote comes back whole or not at all.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace gg {

// `magic` says what it is and of which version: 8 characters.
std::vector<std::byte> seal(std::span<const std::byte> data, std::string_view magic);
// Nothing for bytes that seal() did not make with the same magic, or that were damaged since.
std::optional<std::vector<std::byte>> unseal(std::span<const std::byte> file,
                                             std::string_view magic);

// FNV-1a, 64 bits: against damage and chance, not against forgers.
std::uint64_t checksum(std::span<const std::byte> data, std::uint64_t hash = 0xcbf29ce484222325ull);

} // namespace gg
