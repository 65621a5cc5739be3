#include "robustness/damage.h"

#include <algorithm>

namespace gg::test {

using nlohmann::json;

void damage(Bytes& bytes, std::mt19937& random) {
  const auto below = [&](std::size_t n) { return n == 0 ? 0 : random() % n; };
  const auto place = [&] {
    return random() % 2 == 0 ? below(std::min<std::size_t>(bytes.size(), 400))
                             : below(bytes.size());
  };
  for (auto times = 1 + random() % 4; times > 0 && !bytes.empty(); --times) {
    const std::size_t at = place();
    const std::size_t count = std::min<std::size_t>(1 + below(8), bytes.size() - at);
    const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(at);
    const auto end = begin + static_cast<std::ptrdiff_t>(count);
    switch (random() % 6) {
    case 0:
      *begin ^= static_cast<std::byte>(1u << random() % 8);
      break;
    case 1:
      std::fill(begin, end, random() % 2 ? std::byte{0xff} : std::byte{0});
      break;
    case 2:
      *begin = std::byte{0x7f};
      break;
    case 3:
      bytes.erase(begin, end);
      break;
    case 4:
      bytes.insert(begin, count, *begin);
      break;
    default:
      std::generate(begin, end, [&] { return static_cast<std::byte>(random()); });
    }
  }
}

void flip(Bytes& bytes, std::size_t from, std::mt19937& random) {
  for (auto flips = 1 + random() % 8; flips > 0; --flips)
    bytes[from + random() % (bytes.size() - from)] ^= static_cast<std::byte>(1u << (random() % 8));
}

json& pick(json& value, std::mt19937& random) {
  json* at = &value;
  while (at->is_structured() && !at->empty() && (at == &value || random() % 16 != 0)) {
    auto next = at->begin();
    std::advance(next, random() % at->size());
    at = &*next;
  }
  return *at;
}

json surprise(std::mt19937& random, const json& old) {
  switch (random() % 14) {
  case 0:
    return nullptr;
  case 1:
    return -1;
  case 2:
    return 0;
  case 3:
    return 1;
  case 4:
    return 4294967296;
  case 5:
    return std::uint64_t{18446744073709551615u};
  case 6:
    return 1e38;
  case 7:
    return -0.5;
  case 8:
    return "\xC3\xA9\x01";
  case 9:
    return json::array();
  case 10:
    return json::object();
  case 11:
    return true;
  case 12:
    return static_cast<int>(random() % 8);
  default:
    return old.is_number_integer() ? json(old.get<std::int64_t>() + 1) : json::array({old, old});
  }
}

} // namespace gg::test
