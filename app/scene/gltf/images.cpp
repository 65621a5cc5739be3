#include "scene/gltf/images.h"

#include "image/size.h"
#include "scene/gltf/fail.h"
#include "scene/gltf/values.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <set>
#include <thread>

namespace gg::scene::gltf {
namespace {

constexpr const char* export_plain = "Export it with PNG, JPEG or WebP images.";

Wrap wrap_of(int value, const std::string& file, const std::string& place) {
  switch (value) {
  case TINYGLTF_TEXTURE_WRAP_REPEAT:
    return Wrap::repeat;
  case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
    return Wrap::mirrored_repeat;
  case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
    return Wrap::clamp;
  default:
    fail(file, place, fmt::format("is {}, which glTF does not have", value));
  }
}

Sampler sampler_of(const Document& document, int index) {
  const auto& source = document.model().samplers[static_cast<std::size_t>(index)];
  const std::string place = element("samplers", index);
  Sampler s;
  s.wrap_s = wrap_of(source.wrapS, document.name(), place + ".wrapS");
  s.wrap_t = wrap_of(source.wrapT, document.name(), place + ".wrapT");
  s.magnify =
      source.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST ? Filter::nearest : Filter::linear;
  switch (source.minFilter) {
  case TINYGLTF_TEXTURE_FILTER_NEAREST:
    s.minify = Filter::nearest, s.mipmaps = false;
    break;
  case TINYGLTF_TEXTURE_FILTER_LINEAR:
    s.mipmaps = false;
    break;
  case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST:
    s.minify = s.between_levels = Filter::nearest;
    break;
  case TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_NEAREST:
    s.between_levels = Filter::nearest;
    break;
  case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_LINEAR:
    s.minify = Filter::nearest;
    break;
  case TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR:
  case -1: // not said: ours to choose
    break;
  default:
    fail(document.name(), place + ".minFilter",
         fmt::format("is {}, which glTF does not have", source.minFilter));
  }
  return s;
}

// Textures that the given materials read, in order.
std::set<Index> textures_read(const std::vector<bool>& used, Scene& scene) {
  std::set<Index> result;
  for (std::size_t i = 0; i < scene.materials.size(); ++i)
    if (used[i])
      for (const Slot* slot : slots(scene.materials[i]))
        if (*slot) result.insert(slot->texture);
  return result;
}

struct Job {
  Index image;
  std::span<const std::byte> bytes;
  std::string name;
  long long pixels = 0;
};

// Decoders take as much memory again as the picture, and several are at work: together on no more pixels than one picture
// may have.
class Workbench {
public:
  void take(long long pixels) {
    std::unique_lock lock(mutex_);
    free_.wait(lock, [&] { return taken_ == 0 || taken_ + pixels <= image::max_pixels; });
    taken_ += pixels;
  }
  void give_back(long long pixels) {
    {
      const std::lock_guard lock(mutex_);
      taken_ -= pixels;
    }
    free_.notify_all();
  }

private:
  std::mutex mutex_;
  std::condition_variable free_;
  long long taken_ = 0;
};

// Decoding is most of the time to load a textured scene, and images do not depend on each other.
// The error that is thrown is that of the first broken image in the file, whichever thread met it (of its heads, which are
// read before, if one of them is broken).
void decode(const std::vector<Job>& jobs, Scene& scene) {
  std::vector<std::exception_ptr> errors(jobs.size());
  std::atomic<std::size_t> next = 0;
  Workbench bench;
  const auto work = [&] {
    for (std::size_t i; (i = next++) < jobs.size();) {
      bench.take(jobs[i].pixels);
      try {
        scene.images[static_cast<std::size_t>(jobs[i].image)] =
            std::make_shared<const image::Image8>(
                image::decode(jobs[i].bytes.data(), jobs[i].bytes.size(), jobs[i].name));
      } catch (...) {
        errors[i] = std::current_exception();
      }
      bench.give_back(jobs[i].pixels);
    }
  };
  {
    std::vector<std::jthread> helpers;
    const std::size_t most = std::max(1u, std::thread::hardware_concurrency());
    for (std::size_t i = 1; i < std::min(most, jobs.size()); ++i)
      helpers.emplace_back(work);
    work();
  }
  for (const std::exception_ptr& error : errors)
    if (error) std::rethrow_exception(error);
}

} // namespace

std::vector<Slot*> slots(Material& m) {
  return {&m.base_color_map,
          &m.metallic_roughness_map,
          &m.normal_map,
          &m.occlusion_map,
          &m.emissive_map,
          &m.specular_map,
          &m.specular_color_map,
          &m.transmission_map,
          &m.thickness_map,
          &m.anisotropy_map,
          &m.clearcoat_map,
          &m.clearcoat_roughness_map,
          &m.clearcoat_normal_map,
          &m.iridescence_map,
          &m.iridescence_thickness_map,
          &m.diffuse_transmission_map,
          &m.diffuse_transmission_color_map};
}

void read_textures(const Document& document, Scene& scene) {
  for (const tinygltf::Texture& source : document.model().textures) {
    Texture texture;
    // The plain picture before KTX2, which loses some of it and is not read on every machine.
    const auto of_extension = [&](const char* name) {
      const auto found = source.extensions.find(name);
      return found != source.extensions.end() ? integer_or(found->second, "source", none) : none;
    };
    const Index webp = of_extension("EXT_texture_webp");
    texture.image = webp != none ? webp : source.source;
    if (texture.image == none) texture.image = of_extension("KHR_texture_basisu");
    if (source.sampler >= 0) texture.sampler = sampler_of(document, source.sampler);
    scene.textures.push_back(texture);
  }
}

void decode_images(Document& document, const std::vector<bool>& material_is_used, Scene& scene) {
  std::set<Index> images;
  for (const Index t : textures_read(material_is_used, scene)) {
    const Index image = scene.textures[static_cast<std::size_t>(t)].image;
    const auto& source = document.model().textures[static_cast<std::size_t>(t)];
    if (image != none)
      images.insert(image);
    else if (!source.extensions.empty())
      fail_unsupported(document.name(), element("textures", t),
                       "is only there as " + source.extensions.begin()->first
                           + ", which is not read",
                       export_plain);
    else
      fail(document.name(), element("textures", t), "has no image");
  }
  std::vector<Job> jobs;
  for (const Index i : images) {
    const std::string name = document.name() + ": " + element("images", i);
    jobs.push_back({i, document.image(i), name});
    scene.images.resize(std::max(scene.images.size(), static_cast<std::size_t>(i) + 1));
  }
  for (Job& job : jobs) {
    job.pixels = image::size_of(job.bytes.data(), job.bytes.size(), job.name).pixels();
    document.spend_on_picture(4 * static_cast<std::size_t>(job.pixels),
                              element("images", job.image));
  }
  decode(jobs, scene);
}

} // namespace gg::scene::gltf
