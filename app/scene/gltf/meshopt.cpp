#include "scene/gltf/meshopt.h"

#include "scene/gltf/fail.h"

#include <meshoptimizer.h>

namespace gg::scene::gltf {

Meshopt meshopt_stream(const nlohmann::json& extension, const std::string& file,
                       const std::string& place) {
  using Mode = Meshopt::Mode;
  using Filter = Meshopt::Filter;
  Meshopt s;
  const std::string mode = extension["mode"], filter = extension.value("filter", "NONE");
  s.mode = mode == "ATTRIBUTES"  ? Mode::attributes
           : mode == "TRIANGLES" ? Mode::triangles
                                 : Mode::indices;
  s.filter = filter == "OCTAHEDRAL"    ? Filter::octahedral
             : filter == "QUATERNION"  ? Filter::quaternion
             : filter == "EXPONENTIAL" ? Filter::exponential
                                       : Filter::none;
  s.count = extension["count"];
  s.stride = extension["byteStride"];

  // The library asserts these, so they are refused before it sees them.
  const bool is_attributes = s.mode == Mode::attributes;
  if (is_attributes ? s.stride % 4 != 0 : s.stride != 2 && s.stride != 4)
    fail(file, place + ".byteStride", "does not suit mode " + mode);
  if (s.mode == Mode::triangles && s.count % 3 != 0)
    fail(file, place + ".count", "is not a multiple of 3 in mode TRIANGLES");
  if (s.filter != Filter::none && !is_attributes)
    fail(file, place + ".filter", "is only allowed in mode ATTRIBUTES");
  if ((s.filter == Filter::octahedral && s.stride != 4 && s.stride != 8)
      || (s.filter == Filter::quaternion && s.stride != 8))
    fail(file, place + ".byteStride", "does not suit filter " + filter);
  return s;
}

std::vector<std::byte> decode_meshopt(const Meshopt& s, std::span<const std::byte> source,
                                      const std::string& file, const std::string& place) {
  std::vector<std::byte> bytes(s.count * s.stride);
  const auto* packed = reinterpret_cast<const unsigned char*>(source.data());
  int result = 0;
  switch (s.mode) {
  case Meshopt::Mode::attributes:
    result = meshopt_decodeVertexBuffer(bytes.data(), s.count, s.stride, packed, source.size());
    break;
  case Meshopt::Mode::triangles:
    result = meshopt_decodeIndexBuffer(bytes.data(), s.count, s.stride, packed, source.size());
    break;
  case Meshopt::Mode::indices:
    result = meshopt_decodeIndexSequence(bytes.data(), s.count, s.stride, packed, source.size());
    break;
  }
  if (result != 0) fail(file, place, "the compressed data are damaged");
  switch (s.filter) {
  case Meshopt::Filter::none:
    break;
  case Meshopt::Filter::octahedral:
    meshopt_decodeFilterOct(bytes.data(), s.count, s.stride);
    break;
  case Meshopt::Filter::quaternion:
    meshopt_decodeFilterQuat(bytes.data(), s.count, s.stride);
    break;
  case Meshopt::Filter::exponential:
    meshopt_decodeFilterExp(bytes.data(), s.count, s.stride);
    break;
  }
  return bytes;
}

} // namespace gg::scene::gltf
