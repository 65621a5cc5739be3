// Primitives as glTF stores them -> streams and triangle lists as they are drawn.
#pragma once

#include "scene/gltf/document.h"
#include "scene/gltf/draco.h"
#include "scene/scene.h"

#include <optional>
#include <set>
#include <unordered_map>

namespace gg::scene::gltf {

// The texture coordinates that a material's tangents follow: those of its normal map, as the map
// sees them (after KHR_texture_transform). Empty if nothing in the material asks for tangents.
struct TangentFrame {
  int uv_set = 0;
  glm::mat3 transform{1.0f};
};
std::optional<TangentFrame> tangent_frame(const Material& material);

// What moves the vertices of a mesh where it stands: morph weights and, for a skin, one matrix per
// joint (mesh to world). Both may be empty.
struct Pose {
  std::vector<double> weights;
  std::vector<glm::mat4> joints;
  bool empty() const;
};

// Builds primitives into a scene. What is read from the same accessors is decoded once and shared,
// and so is what is generated from them.
class Geometry {
public:
  Geometry(Document& document, Scene& scene) : document_(document), scene_(scene) {}

  // `place` names the primitive in messages. Empty if there is nothing to draw: points, lines, no
  // positions. The material is left to the caller.
  std::optional<Primitive> build(const tinygltf::Primitive& source, const std::string& place,
                                 const std::optional<TangentFrame>& frame, const Pose& pose);

private:
  struct Draft;
  Index stream(const tinygltf::Primitive& source, const std::string& name,
               const std::string& place);
  Index decode(const tinygltf::Primitive& source, const std::string& name, int accessor,
               const std::string& place);
  const DracoMesh* draco(const tinygltf::Primitive& source, const std::string& place);
  std::vector<std::uint32_t> triangles(const tinygltf::Primitive& source, std::size_t vertices,
                                       const std::string& place);
  Index triangle_list(const tinygltf::Primitive& source, std::size_t vertices,
                      const std::string& place);
  void read(const tinygltf::Primitive& source, const std::string& place, bool with_tangents,
            Primitive& result);
  void morph(const tinygltf::Primitive& source, const std::string& place,
             const std::vector<double>& weights, Primitive& result);
  void skin(const tinygltf::Primitive& source, const std::string& place,
            const std::vector<glm::mat4>& joints, Primitive& result);
  void complete_normals(const std::string& place, Primitive& result);
  void complete_tangents(const TangentFrame& frame, const std::string& place, Primitive& result);
  void gather(const std::vector<std::uint32_t>& vertices, const std::string& place,
              Primitive& result);

  Index add(Stream stream);
  Stream& at(Index index) { return scene_.streams[static_cast<std::size_t>(index)]; }

  Document& document_;
  Scene& scene_;
  std::unordered_map<std::string, Index> streams_, indices_;
  std::unordered_map<std::string, std::uint32_t> largest_index_;
  std::unordered_map<std::string, Primitive> primitives_;
  std::unordered_map<int, std::unique_ptr<DracoMesh>> draco_;
  std::set<Index> zero_normals_, zero_tangents_; // streams that hold some
};

} // namespace gg::scene::gltf
