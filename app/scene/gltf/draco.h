// KHR_draco_mesh_compression.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace gg::scene::gltf {

// Is told what decoding is about to take, before it does, and throws if that is too much.
using Afford = std::function<void(std::size_t bytes)>;

// The triangles and attributes of one compressed primitive.
class DracoMesh {
public:
  // Throws Error(input) naming `file` and `place` if the data are damaged.
  DracoMesh(std::span<const std::byte> bytes, const std::string& file, const std::string& place,
            const Afford& afford);
  ~DracoMesh();
  DracoMesh(const DracoMesh&) = delete;
  DracoMesh& operator=(const DracoMesh&) = delete;

  std::size_t point_count() const;
  std::vector<std::uint32_t> triangles() const;
  // `components` floats per point of the attribute that the file calls `id`; integers are
  // normalised as `component_type` says if `normalise`. Throws Error(input) if there is no such
  // attribute or it has another number of components.
  std::vector<float> floats(int id, int components, bool normalise, int component_type) const;

private:
  struct Decoded;
  std::unique_ptr<Decoded> decoded_;
  std::string file_, place_;
};

} // namespace gg::scene::gltf
