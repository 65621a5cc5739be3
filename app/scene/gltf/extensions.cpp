#include "scene/gltf/extensions.h"

#include "image/image.h"
#include "scene/gltf/fail.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace gg::scene::gltf {
namespace {

constexpr std::array known = {
    "KHR_mesh_quantization",
    "KHR_texture_transform",
    "EXT_texture_webp",
    "KHR_draco_mesh_compression",
    "EXT_meshopt_compression",
    "KHR_lights_punctual",
    "KHR_materials_emissive_strength",
    "KHR_materials_unlit",
    "KHR_materials_ior",
    "KHR_materials_specular",
    "KHR_materials_transmission",
    "KHR_materials_volume",
    "KHR_materials_dispersion",
    "KHR_materials_anisotropy",
    "KHR_materials_clearcoat",
    "KHR_materials_iridescence",
    "KHR_materials_diffuse_transmission",
};

// Read where libktx is there; else the plain image beside it is used, or the file refused where it has none (images.cpp).
constexpr std::string_view basis = "KHR_texture_basisu";

bool is_known(std::string_view name) {
  return std::find(known.begin(), known.end(), name) != known.end();
}

std::string printable(const std::string& name) {
  std::string text = name.substr(0, 60);
  std::replace_if(
      text.begin(), text.end(), [](char ch) { return ch < ' ' || ch > '~'; }, '?');
  return text;
}

} // namespace

void check_extensions(const nlohmann::json& json, const std::string& file) {
  if (json.contains("extensionsRequired"))
    for (const std::string name : json["extensionsRequired"]) {
      if (name == basis && !image::can_decode_ktx2())
        fail_unsupported(file, "extensionsRequired",
                         "the file requires KHR_texture_basisu: KTX2 images, which libktx reads; "
                         "it is not installed",
                         image::without_libktx);
      if (!is_known(name) && name != basis)
        fail_unsupported(file, "extensionsRequired",
                         "the file requires " + printable(name) + ", which is not supported",
                         "Export it without that extension.");
    }
  if (json.contains("extensionsUsed"))
    for (const std::string name : json["extensionsUsed"])
      if (!is_known(name) && name != basis)
        note("the extension " + printable(name) + " is not modelled: what it says is ignored");
}

} // namespace gg::scene::gltf
