#include "needs/kept_hollows.h"

#include "core/kept.h"
#include "needs/features.h"

#include <cstring>
#include <span>
#include <string>

namespace gg::needs {
namespace {

// The magic changes with the order of what is in the file.
constexpr Kept kept{.folder = "hollows",
                    .extension = ".hollows",
                    .magic = "gghollo1",
                    .most_files = 64,
                    .largest_file = std::size_t{256} << 20};

// All that rays between surfaces of a body depend on.
std::string key_of(const scene::Scene& scene, const Proxies& proxies) {
  KeyHash hash;
  hash.add(program_identity());
  const auto add = [&](const auto& values) { hash.add(std::as_bytes(std::span(values))); };
  for (const auto& [place, body] : proxies.bodies) {
    const scene::Instance& instance = scene.instances[place.first];
    const scene::Primitive& primitive =
        scene.meshes[static_cast<std::size_t>(instance.mesh)].primitives[place.second];
    const scene::Material& material = scene.materials[static_cast<std::size_t>(primitive.material)];
    add(std::array{place.first, place.second, body,
                   static_cast<std::size_t>(is_refractive(material)),
                   static_cast<std::size_t>(material.alpha_mode)});
    add(std::span(&instance.world[0][0], 16));
    for (const scene::Index stream : {primitive.positions, primitive.normals})
      add(scene.streams[static_cast<std::size_t>(stream)].values);
    add(scene.indices[static_cast<std::size_t>(primitive.indices)]);
  }
  return hash.text();
}

// Numbers and values one after another.
class Bytes {
public:
  void add(std::size_t number) { add(std::as_bytes(std::span(&number, 1))); }
  void add(std::span<const std::byte> bytes) {
    data.insert(data.end(), bytes.begin(), bytes.end());
  }
  std::vector<std::byte> data;
};

class Reader {
public:
  explicit Reader(std::span<const std::byte> data) : left_(data) {}
  void into(std::span<std::byte> to) {
    whole_ = whole_ && left_.size() >= to.size();
    if (!whole_) return;
    std::memcpy(to.data(), left_.data(), to.size());
    left_ = left_.subspan(to.size());
  }
  std::size_t number() {
    std::size_t n = 0;
    into(std::as_writable_bytes(std::span(&n, 1)));
    return n;
  }
  bool whole() const { return whole_; }
  std::size_t left() const { return left_.size(); }

private:
  std::span<const std::byte> left_;
  bool whole_ = true;
};

std::vector<std::byte> written(const Hollows& hollows) {
  Bytes bytes;
  bytes.add(hollows.streams.size());
  for (const scene::Stream& stream : hollows.streams) {
    bytes.add(stream.values.size());
    bytes.add(std::as_bytes(std::span(stream.values)));
  }
  for (const auto& [place, stream] : hollows.of)
    for (const std::size_t n : {place.first, place.second, stream})
      bytes.add(n);
  return std::move(bytes.data);
}

std::optional<Hollows> read(const std::string& key) {
  const auto data = kept.load(key);
  if (!data) return std::nullopt;
  Reader reader(*data);
  Hollows hollows;
  for (std::size_t count = reader.number(); reader.whole() && count > 0; --count) {
    const std::size_t size = reader.number();
    if (size > reader.left() / sizeof(float)) return std::nullopt;
    scene::Stream& stream =
        hollows.streams.emplace_back(scene::Stream{1, std::vector<float>(size)});
    reader.into(std::as_writable_bytes(std::span(stream.values)));
  }
  while (reader.whole() && reader.left() > 0) {
    const std::size_t instance = reader.number(), primitive = reader.number();
    const std::size_t stream = reader.number();
    if (stream >= hollows.streams.size()) return std::nullopt;
    hollows.of[{instance, primitive}] = stream;
  }
  return reader.whole() ? std::optional(std::move(hollows)) : std::nullopt;
}

} // namespace

Hollows hollows_kept_or_of(const scene::Scene& scene, const Proxies& proxies) {
  if (!kept.possible()) return hollows_of(scene, proxies);
  const std::string key = key_of(scene, proxies);
  if (auto found = read(key)) return std::move(*found);
  Hollows hollows = hollows_of(scene, proxies);
  kept.store(key, written(hollows));
  return hollows;
}

} // namespace gg::needs
