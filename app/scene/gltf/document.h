// A glTF file, checked: its structure (as tinygltf's Model) and its bytes.
#pragma once

#include "scene/gltf/container.h"
#include "scene/gltf/mend.h"
#include "scene/gltf/tiny.h"

#include <map>
#include <span>

namespace gg::scene::gltf {

class Document {
public:
  // Opens, checks and parses. Throws Error(input), or Error(unsupported) for a required extension
  // that this program does not know. Says once which of the extensions in use are ignored.
  explicit Document(const std::filesystem::path& path);

  const tinygltf::Model& model() const { return model_; }
  // To be posed by an animation.
  tinygltf::Node& node(int index) { return model_.nodes[static_cast<std::size_t>(index)]; }
  // The animations as the file has them, none of them checked yet.
  std::vector<nlohmann::json> animations() const;
  // One of them, checked. Throws Error(input) if it is not what glTF says.
  const nlohmann::json& animation(std::size_t index) const;
  const std::string& name() const { return container_.name; }

  // What is wrong with a camera; empty if nothing. The model has a plain one in its place then.
  std::string camera_fault(int camera) const;

  // The bytes of a buffer view, decompressed where EXT_meshopt_compression says so. Read (and
  // decompressed) when first asked for. Throws Error(input) if they are not there.
  std::span<const std::byte> view(int buffer_view);
  // The encoded bytes of an image. Valid until the Document dies.
  std::span<const std::byte> image(int image);

  // Takes `bytes` from what this file may unpack to. A file can declare far more than it holds
  // (accessors without data, one run of bytes read by thousands of accessors); what a file of this
  // size can sensibly become is bounded, and a message is better than an exhausted machine. Throws
  // Error(input) naming `place`.
  void spend(std::size_t bytes, const std::string& place);
  // The same for a decoded picture, which is kept. Those of a file may together take more, whatever its size.
  void spend_on_picture(std::size_t bytes, const std::string& place);
  // Throws as spend(bytes, place) would, and takes nothing.
  void afford(std::size_t bytes, const std::string& place) const;
  // Another scene is made of the file: what the one before unpacked is paid back, but for what is kept here.
  void restart_budget() { spent_ = kept_; }

private:
  void afford_elements() const;
  std::span<const std::byte> buffer(int buffer);
  std::span<const std::byte> slice(int buffer, std::size_t offset, std::size_t length,
                                   const std::string& place);

  Container container_;
  CameraFaults camera_faults_;
  tinygltf::Model model_;
  std::map<int, std::vector<std::byte>> buffers_, decompressed_, external_images_;
  std::size_t left() const;          // of what may be spent
  std::size_t read_ = 0;             // bytes of all files
  std::size_t spent_ = 0, kept_ = 0; // kept_: of spent_, by what stays for the next scene
  std::size_t pictures_ = 0;         // of their allowance
};

} // namespace gg::scene::gltf
