#include "frame/neighbour_blocks.h"

#include "glsl/f32.h"
#include "glsl/f64.h"
#include "needs/neighbours.h"
#include "needs/proxies.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace gg::frame {
namespace {

using scene::Material;

constexpr int mean_across = 64; // pixels of a map along each side that stand for all

glm::vec3 mean_of(const image::Image8& image, bool srgb) {
  glm::dvec3 sum(0.0);
  for (int y = 0; y < mean_across; ++y)
    for (int x = 0; x < mean_across; ++x) {
      const auto at = [](int i, int size) {
        return static_cast<std::size_t>((2 * i + 1) * size / (2 * mean_across));
      };
      const std::size_t pixel =
          4 * (at(y, image.height) * static_cast<std::size_t>(image.width) + at(x, image.width));
      for (int c = 0; c < 3; ++c) {
        const double value = image.rgba[pixel + static_cast<std::size_t>(c)] / 255.0;
        sum[c] += srgb ? image::linear_from_srgb(value) : value;
      }
    }
  return glm::vec3(sum / static_cast<double>(mean_across * mean_across));
}

struct Maps {
  const scene::Scene& scene;
  ImageMeans& means;

  // Of the colours that a map holds, linear; white where there is none.
  glm::vec3 mean(const scene::Slot& slot, bool srgb) const {
    if (!slot) return glm::vec3(1.0f);
    const scene::Index index = scene.textures[static_cast<std::size_t>(slot.texture)].image;
    if (index == scene::none || !scene.images[static_cast<std::size_t>(index)])
      return glm::vec3(1.0f);
    const auto [mean, is_new] = means.try_emplace({index, srgb});
    if (is_new) mean->second = mean_of(*scene.images[static_cast<std::size_t>(index)], srgb);
    return mean->second;
  }
};

glm::vec3 conductor_f0(const scene::Conductor& conductor) {
  glm::vec3 f0;
  for (int c = 0; c < 3; ++c)
    f0[c] = static_cast<float>(glsl::f64::fresnelConductor(1.0, static_cast<double>(conductor.n[c]),
                                                           static_cast<double>(conductor.k[c])));
  return f0;
}

// The part of a proxy's block that its material fills.
uniforms::NeighbourData block_of(const Maps& maps, const Material& m) {
  uniforms::NeighbourData block{};
  const glm::vec3 color = glm::vec3(m.base_color) * maps.mean(m.base_color_map, true);
  if (m.unlit) {
    block.emission = glm::vec4(color, 0.0f);
    return block;
  }
  const glm::vec3 surface = maps.mean(m.metallic_roughness_map, false);
  const float metallic = m.conductor ? 1.0f : m.metallic * surface.z;
  const float across =
      m.exact_alpha ? *m.exact_alpha : scene::microfacet_alpha(m) * surface.y * surface.y;
  // Brushed: one width of the same variance of slopes.
  const float alpha =
      m.anisotropy_strength > 0.0f
          ? glm::length(glsl::f32::ggxAnisoWidths(across, m.anisotropy_strength)) / std::sqrt(2.0f)
          : across;
  const float normal = m.ior > 0.0f ? (m.ior - 1.0f) / (m.ior + 1.0f) : 1.0f;
  const glm::vec3 dielectric =
      glm::min(normal * normal * m.specular_color, glm::vec3(1.0f)) * m.specular;
  const glm::vec3 f0 =
      m.conductor ? conductor_f0(*m.conductor) : glm::mix(dielectric, color, metallic);
  const float transmitted = needs::is_refractive(m) ? m.transmission * (1.0f - metallic) : 0.0f;
  block.f0 = glm::vec4(f0, glm::mix(m.specular, 1.0f, metallic));
  block.base = glm::vec4((1.0f - metallic) * (1.0f - transmitted) * color, alpha);
  block.emission = glm::vec4(m.emissive * maps.mean(m.emissive_map, true), 0.0f);
  if (needs::is_refractive(m)) {
    block.emission.w = std::max(m.ior, 1.0f);
    block.through = glm::vec4(transmitted * color, 0.0f);
  }
  return block;
}

// Metres through the body of a proxy: the mean chord of a ball, 4/3 of its radius; of a box to the opposite face; what the
// material says of a sheet.
float depth_of(const needs::Proxies& proxies, const needs::Proxy& proxy) {
  if (proxy.radius > 0.0f) return 4.0f / 3.0f * proxy.radius;
  const glm::vec3 n = glm::normalize(glm::cross(proxy.side_u, proxy.side_v));
  float depth = 0.0f;
  for (const needs::Proxy& other : proxies.all)
    if (other.body == proxy.body && proxy.one_sided)
      depth = std::max(depth, glm::dot(n, proxy.centre - other.centre));
  return depth > 0.0f ? depth : proxy.material->thickness;
}

glm::vec3 absorbed(const Material& m, float metres) {
  if (!(m.thickness > 0.0f) || !std::isfinite(m.attenuation_distance)
      || !(m.attenuation_distance > 0.0f))
    return glm::vec3(1.0f);
  // Black has no logarithm: a millionth a distance is black as far as 8 bits show.
  return glm::pow(glm::max(m.attenuation_color, glm::vec3(1e-6f)),
                  glm::vec3(metres / m.attenuation_distance));
}

} // namespace

std::vector<uniforms::NeighboursData> neighbour_blocks(const needs::Needs& needs,
                                                       ImageMeans& means) {
  const Maps maps{*needs.scene, means};
  std::map<const Material*, uniforms::NeighbourData> materials;
  std::vector<uniforms::NeighboursData> blocks;
  for (const needs::Draw& draw : needs.draws.all) {
    if (draw.neighbours.empty()) continue;
    uniforms::NeighboursData& block = blocks.emplace_back();
    block.counts.x = static_cast<int>(draw.neighbours.size());
    if (draw.own_proxy) {
      const needs::Proxy& own = needs.proxies->all[*draw.own_proxy];
      const uniforms::NeighbourData material = block_of(maps, *own.material);
      uniforms::NeighbourData& body = block.each[needs::most_neighbours];
      body.centre = glm::vec4(own.centre, own.radius);
      body.sideU = glm::vec4(own.side_u, 0.0f);
      body.sideV = glm::vec4(own.side_v, 0.0f);
      body.base = glm::min(material.f0 + material.base + material.through, glm::vec4(1.0f));
    }
    const needs::Proxy* before = nullptr;
    for (std::size_t i = 0; i < draw.neighbours.size(); ++i) {
      const needs::Proxy& proxy = needs.proxies->all[draw.neighbours[i]];
      const auto [material, is_new] = materials.try_emplace(proxy.material);
      if (is_new) material->second = block_of(maps, *proxy.material);
      uniforms::NeighbourData& own = block.each[i] = material->second;
      own.centre = glm::vec4(proxy.centre, proxy.radius);
      own.sideU = glm::vec4(proxy.side_u, proxy.one_sided ? 1.0f : 0.0f);
      const bool continues = before && before->body == proxy.body && proxy.radius == 0.0f;
      own.sideV = glm::vec4(proxy.side_v, continues ? 1.0f : 0.0f);
      if (own.emission.w > 0.0f)
        own.through *= glm::vec4(absorbed(*proxy.material, depth_of(*needs.proxies, proxy)), 1.0f);
      own.through.w = needs::is_lens(proxy) ? 1.0f : 0.0f;
      before = &proxy;
    }
  }
  return blocks;
}

} // namespace gg::frame
