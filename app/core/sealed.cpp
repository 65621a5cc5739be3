#include "core/sealed.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace gg {
namespace {

struct Seal {
  char magic[8];
  std::uint64_t bytes, checksum; // of what follows
};

} // namespace

std::uint64_t checksum(std::span<const std::byte> data, std::uint64_t hash) {
  for (const std::byte byte : data)
    hash = (hash ^ static_cast<std::uint64_t>(byte)) * 0x100000001b3ull;
  return hash;
}

std::vector<std::byte> seal(std::span<const std::byte> data, std::string_view magic) {
  Seal head{.magic = {}, .bytes = data.size(), .checksum = checksum(data)};
  std::memcpy(head.magic, magic.data(), std::min(magic.size(), sizeof head.magic));
  std::vector<std::byte> file(sizeof head + data.size());
  std::memcpy(file.data(), &head, sizeof head);
  if (!data.empty()) std::memcpy(file.data() + sizeof head, data.data(), data.size());
  return file;
}

std::optional<std::vector<std::byte>> unseal(std::span<const std::byte> file,
                                             std::string_view magic) {
  Seal head;
  if (file.size() < sizeof head) return std::nullopt;
  std::memcpy(&head, file.data(), sizeof head);
  const auto data = file.subspan(sizeof head);
  if (std::string_view(head.magic, sizeof head.magic) != magic || head.bytes != data.size()
      || head.checksum != checksum(data))
    return std::nullopt;
  return std::vector<std::byte>(data.begin(), data.end());
}

} // namespace gg
