// What is drawn, read from files: meshes and materials of a .glb, an environment, the tables; and the uniform blocks of the shaders.
// The same for OpenGL and Vulkan: no graphics interface is used here.
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/packing.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

[[noreturn]] inline void fail(const std::string& what) {
  std::fprintf(stderr, "%s\n", what.c_str());
  std::exit(1);
}

inline std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) fail(path + " cannot be read");
  return {std::istreambuf_iterator<char>(file), {}};
}

// Bindings are those of the shaders: blocks 0 and 1 (the second at an offset of each draw in Vulkan), textures 2 to 13.
enum {
  FRAME,
  DRAW,
  COLOR,
  ROUGHNESS,
  ENERGY,
  LOBES,
  REFLECTION,
  PYRAMID,
  DEPTH,
  EVEN,
  ODD,
  BACKS,
  SECOND_FRONTS,
  SECOND_BACKS,
  BINDINGS
};

// Uniform blocks, std140: shaders/*.frag say what each member is.
constexpr int LEVELS = 14;
struct FrameBlock {
  glm::mat4 clip_from_world;
  glm::vec4 eye, right, up, forward, picture, range, atlas, tiles[LEVELS];
};
struct DrawBlock {
  glm::mat4 world_from_mesh;
  glm::vec4 color, surface, glass, absorption;
};
struct PassBlock {
  glm::vec4 pass, from;
};

struct Vertex {
  glm::vec3 position, normal;
  glm::vec2 uv;
};
struct Picture { // 8 bits RGBA; empty: white
  int width = 1, height = 1;
  std::vector<unsigned char> texels{255, 255, 255, 255};
  bool nearest = false, clamped = false;
};
struct Mesh {
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;
  DrawBlock block;
  Picture color, roughness;
  bool glass = false;
};
struct Camera {
  glm::mat4 world{1.0F};
  float yfov = 0.8F, near = 0.01F, far = 100.0F;
};
struct Scene {
  std::vector<Mesh> meshes;
  Camera camera;
  glm::vec3 low{std::numeric_limits<float>::max()}, high{std::numeric_limits<float>::lowest()};
};

template <class T>
std::vector<T> accessor_of(const tinygltf::Model& model, int index, int across) {
  const tinygltf::Accessor& a = model.accessors[index];
  const tinygltf::BufferView& view = model.bufferViews[a.bufferView];
  const unsigned char* data =
      model.buffers[view.buffer].data.data() + view.byteOffset + a.byteOffset;
  std::vector<T> out;
  for (std::size_t i = 0; i < a.count; ++i)
    for (int c = 0; c < across; ++c) {
      const unsigned char* at =
          data + i * a.ByteStride(view) + c * tinygltf::GetComponentSizeInBytes(a.componentType);
      if (a.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT)
        out.push_back(T(*reinterpret_cast<const float*>(at)));
      else if (a.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT)
        out.push_back(T(*reinterpret_cast<const std::uint32_t*>(at)));
      else if (a.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT)
        out.push_back(T(*reinterpret_cast<const std::uint16_t*>(at)));
      else
        out.push_back(T(*at));
    }
  return out;
}

inline Picture picture_of(const tinygltf::Model& model, int texture) {
  Picture picture;
  if (texture < 0) return picture;
  const tinygltf::Image& image = model.images[model.textures[texture].source];
  picture.width = image.width;
  picture.height = image.height;
  picture.texels = image.image;
  if (const int s = model.textures[texture].sampler; s >= 0) {
    picture.nearest = model.samplers[s].magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
    picture.clamped = model.samplers[s].wrapS == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE;
  }
  return picture;
}

inline double number_of(const tinygltf::Material& m, const char* extension, const char* name,
                        double otherwise) {
  const auto found = m.extensions.find(extension);
  return found != m.extensions.end() && found->second.Has(name)
             ? found->second.Get(name).GetNumberAsDouble()
             : otherwise;
}

inline void add_material(Mesh& mesh, const tinygltf::Model& model, int index, int bodies) {
  const tinygltf::Material m = index < 0 ? tinygltf::Material() : model.materials[index];
  const auto& plain = m.pbrMetallicRoughness;
  const std::vector<double>& c = plain.baseColorFactor;
  const char *volume = "KHR_materials_volume", *passes = "KHR_materials_transmission";
  const double transmission = number_of(m, passes, "transmissionFactor", 0.0),
               distance = number_of(m, volume, "attenuationDistance", 0.0);
  mesh.glass = transmission > 0.0;
  mesh.block.color = glm::vec4(c[0], c[1], c[2], m.extensions.count("KHR_materials_unlit"));
  mesh.block.surface = glm::vec4(plain.roughnessFactor, plain.metallicFactor, -1.0, -1.0);
  mesh.block.glass =
      glm::vec4(transmission, number_of(m, "KHR_materials_ior", "ior", 1.5),
                number_of(m, volume, "thicknessFactor", 0.0), mesh.glass ? bodies + 1 : 0);
  mesh.block.absorption = glm::vec4(0.0F);
  if (distance > 0.0
      && m.extensions.at(volume).Has(
          "attenuationColor")) // Beer's law: what is left after that distance
    for (int k = 0; k < 3; ++k)
      mesh.block.absorption[k] = float(
          -std::log(std::max(
              m.extensions.at(volume).Get("attenuationColor").Get(k).GetNumberAsDouble(), 1e-6))
          / distance);
  mesh.color = picture_of(model, plain.baseColorTexture.index);
  mesh.roughness = picture_of(model, plain.metallicRoughnessTexture.index);
}

inline void add_node(Scene& scene, const tinygltf::Model& model, int index, const glm::mat4& parent,
                     int& bodies) {
  const tinygltf::Node& node = model.nodes[index];
  glm::mat4 world = parent;
  if (!node.matrix.empty()) world *= glm::mat4(glm::make_mat4(node.matrix.data()));
  if (const auto& t = node.translation; !t.empty())
    world = glm::translate(world, glm::vec3(t[0], t[1], t[2]));
  if (const auto& q = node.rotation; !q.empty())
    world *= glm::mat4_cast(glm::quat(float(q[3]), float(q[0]), float(q[1]), float(q[2])));
  if (const auto& s = node.scale; !s.empty())
    world = glm::scale(world, glm::vec3(s[0], s[1], s[2]));
  if (node.camera >= 0) {
    const auto& seen = model.cameras[node.camera].perspective;
    scene.camera = {world, float(seen.yfov), float(seen.znear),
                    float(seen.zfar > 0.0 ? seen.zfar : 1000.0)};
  }
  for (const tinygltf::Primitive& one :
       node.mesh < 0 ? std::vector<tinygltf::Primitive>() : model.meshes[node.mesh].primitives) {
    Mesh mesh;
    mesh.block.world_from_mesh = world;
    const auto position = accessor_of<float>(model, one.attributes.at("POSITION"), 3),
               normal = accessor_of<float>(model, one.attributes.at("NORMAL"), 3);
    const auto uv = one.attributes.count("TEXCOORD_0")
                        ? accessor_of<float>(model, one.attributes.at("TEXCOORD_0"), 2)
                        : std::vector<float>();
    for (std::size_t i = 0; i < position.size() / 3; ++i) {
      mesh.vertices.push_back({glm::make_vec3(&position[3 * i]), glm::make_vec3(&normal[3 * i]),
                               uv.empty() ? glm::vec2(0.0F) : glm::make_vec2(&uv[2 * i])});
      const glm::vec3 p(world * glm::vec4(mesh.vertices.back().position, 1.0F));
      scene.low = glm::min(scene.low, p);
      scene.high = glm::max(scene.high, p);
    }
    mesh.indices = accessor_of<std::uint32_t>(model, one.indices, 1);
    add_material(mesh, model, one.material, bodies);
    bodies += mesh.glass;
    scene.meshes.push_back(std::move(mesh));
  }
  for (const int child : node.children)
    add_node(scene, model, child, world, bodies);
}

// Binary glTF of triangles with normals; base colour, roughness, metal, and the extensions transmission, volume, ior and unlit. Without
// a camera of its own it is looked at from +z.
inline Scene scene_of(const std::string& path) {
  tinygltf::Model model;
  std::string error, warning;
  if (!tinygltf::TinyGLTF().LoadBinaryFromFile(&model, &error, &warning, path))
    fail(path + ": " + error);
  Scene scene;
  scene.camera.yfov = 0.0F;
  int bodies = 0;
  for (const int root : model.scenes[std::max(model.defaultScene, 0)].nodes)
    add_node(scene, model, root, glm::mat4(1.0F), bodies);
  if (scene.camera.yfov == 0.0F) {
    const float radius = 0.5F * glm::length(scene.high - scene.low);
    scene.camera = {glm::translate(glm::mat4(1.0F), 0.5F * (scene.low + scene.high)
                                                        + glm::vec3(0.0F, 0.0F, 2.6F * radius)),
                    0.8F, radius / 50.0F, radius * 50.0F};
  }
  return scene;
}

struct Environment {
  int width = 0, height = 0;
  std::vector<float> texels; // RGBA, rows from the zenith
};
inline Environment environment_of(const std::string& path) {
  Environment map;
  float* read = stbi_loadf(path.c_str(), &map.width, &map.height, nullptr, 4);
  if (!read) fail(path + ": " + stbi_failure_reason());
  map.texels.assign(read, read + 4 * map.width * map.height);
  stbi_image_free(read);
  for (float& x : map.texels)
    x = std::min(x, 65504.0F); // the largest half float
  return map;
}

struct Table {
  std::array<int, 3> size;
  std::string halves; // RGBA
};
// The sizes are those of tables.json: x cosine, y sqrt(alpha), z relative index.
inline std::array<Table, 3> tables_of(const std::string& folder) {
  return {{{{65, 32, 26}, bytes_of(folder + "/interface-energy-ggx.bin")},
           {{25, 32, 26}, bytes_of(folder + "/interface-lobes2-ggx.bin")},
           {{32, 32, 5}, bytes_of(folder + "/reflection-lobes1-ggx.bin")}}};
}

// The environment's levels: the first sharp, then Gaussians of sigma 0.01 radians and up, sqrt(2) apart; a texel is at most as wide as
// its level's sigma. Tiles stand one above the other, even levels in one atlas and odd ones in another.
struct Level {
  int size = 512, row = 0;
  float sigma = 0.0035F;
};
struct Levels {
  std::array<Level, LEVELS> level;
  int width = 514;
  std::array<int, 2> height{0, 0};
  Levels() {
    for (int k = 0; k < LEVELS; ++k) {
      Level& one = level[k];
      if (k > 0) {
        one.sigma = 0.01F * std::pow(2.0F, 0.5F * float(k - 1));
        one.size = std::max(16, 1 << int(std::ceil(std::log2(3.5F / one.sigma) - 0.01F)));
      }
      one.row = height[k % 2];
      height[k % 2] += one.size + 2;
    }
  }
  PassBlock block(int k) const { // of the pass that makes level k
    const Level &one = level[k], &before = level[std::max(k - 1, 0)];
    return {
        glm::vec4(one.size,
                  k == 0 ? 0.0F : std::sqrt(one.sigma * one.sigma - before.sigma * before.sigma),
                  0.0F, 0.0F),
        glm::vec4(before.size, before.row, width, height[(k + 1) % 2])};
  }
};

// offset: of the picture, in pixels to the right and down. samples: pictures, each at another offset, that are averaged: lobes blur
// over so much less of a pixel. lowest_first: whether a picture's first row is its lowest (OpenGL).
inline FrameBlock frame_of(const Scene& scene, const Levels& levels, int width, int height,
                           glm::vec2 offset, int samples, int last_level, bool lowest_first) {
  const Camera& c = scene.camera;
  const float focal = 1.0F / std::tan(0.5F * c.yfov), aspect = float(width) / float(height);
  const glm::vec2 shift(-2.0F * offset.x / float(width), 2.0F * offset.y / float(height));
  glm::mat4 projection = lowest_first ? glm::perspectiveRH_NO(c.yfov, aspect, c.near, c.far)
                                      : glm::perspectiveRH_ZO(c.yfov, aspect, c.near, c.far);
  projection[2][0] = -shift.x;
  projection[2][1] = -shift.y;
  FrameBlock frame;
  frame.clip_from_world = projection * glm::inverse(c.world);
  const glm::vec3 right(c.world[0]), up(c.world[1]), back(c.world[2]),
      half(aspect / focal, 1.0F / focal, 0.0F);
  frame.eye = glm::vec4(glm::vec3(c.world[3]), 1.0F);
  frame.right = glm::vec4(half.x * right, 0.0F);
  frame.up = glm::vec4(half.y * up, 0.0F);
  frame.forward = glm::vec4(-back - shift.x * half.x * right - shift.y * half.y * up, 0.0F);
  frame.picture = glm::vec4(width, height, 0.5F * float(height) * focal, last_level);
  frame.range =
      glm::vec4(c.near, c.far, std::max(1.02F * glm::length(scene.high - scene.low), c.near),
                lowest_first ? 1.0F : 0.0F);
  frame.atlas = glm::vec4(levels.width, levels.height[0], levels.height[1], 1.0F / float(samples));
  for (int k = 0; k < LEVELS; ++k)
    frame.tiles[k] =
        glm::vec4(levels.level[k].size, levels.level[k].row, levels.level[k].sigma, 0.0F);
  return frame;
}

// Levels of the scene's pyramid, down to four texels along the shorter side.
inline int last_level_of(int width, int height) {
  return std::max(0, int(std::log2(std::min(width, height))) - 2);
}

// What the command line asks for: [SCENE.glb [ENVIRONMENT.hdr [OUT [WIDTH HEIGHT [SAMPLES along each axis of a pixel [TIER]]]]]]
// OUT: .png, as a display shows it, or .hdr, linear radiance.
// TIER: faces (the nearest back faces of glass) or pairs (and the faces behind those)
struct Asked {
  std::string scene = "scene.glb", environment = "environment.hdr", out = "picture.png";
  int width = 640, height = 480, samples = 2;
  bool pairs = false;
};
inline Asked asked_of(int argc, char** argv) {
  Asked asked;
  std::string* const names[] = {&asked.scene, &asked.environment, &asked.out};
  int* const numbers[] = {&asked.width, &asked.height, &asked.samples};
  for (int k = 1; k < argc && k < 7; ++k)
    if (k < 4)
      *names[k - 1] = argv[k];
    else
      *numbers[k - 4] = std::atoi(argv[k]);
  const std::string tier = argc > 7 ? argv[7] : "faces";
  asked.pairs = tier == "pairs";
  if (tier != "pairs" && tier != "faces") fail(tier + " is no tier: faces or pairs");
  if (asked.width < 8 || asked.height < 8 || asked.samples < 1)
    fail("sizes are 8 x 8 pixels and more, samples 1 and more");
  return asked;
}
inline glm::vec2 offset_of(int k, int samples) { // the k-th of samples² places in a pixel
  return (glm::vec2(k % samples, k / samples) + 0.5F) / float(samples) - 0.5F;
}

struct Averaged {
  std::vector<float> texels; // linear RGBA
  double ms = 0.0;           // of one frame
};
// Frames at places of the pixel, averaged: a box filter. Renderer: std::vector<float> draw(glm::vec2 offset, int frames).
template <class Renderer>
Averaged averaged_of(Renderer& renderer, const Asked& asked) {
  Averaged sum{std::vector<float>(4U * asked.width * asked.height)};
  const int frames = asked.samples * asked.samples;
  renderer.draw({}, frames); // drivers compile at the first draw
  const auto start = std::chrono::steady_clock::now();
  for (int k = 0; k < frames; ++k) {
    const std::vector<float> one = renderer.draw(offset_of(k, asked.samples), frames);
    for (std::size_t i = 0; i < sum.texels.size(); ++i)
      sum.texels[i] += one[i] / float(frames);
  }
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
  sum.ms = time.count() / frames;
  return sum;
}
// Writes the picture and says so, with the device's name.
inline void write(const Averaged& picture, const Asked& asked, const char* device) {
  bool written = false;
  if (asked.out.ends_with(".png")) {
    std::vector<unsigned char> encoded(picture.texels.size(), 255);
    for (std::size_t i = 0; i < encoded.size(); ++i) {
      const float v = std::clamp(picture.texels[i], 0.0F, 1.0F);
      const float srgb = v < 0.0031308F ? 12.92F * v : 1.055F * std::pow(v, 1.0F / 2.4F) - 0.055F;
      if (i % 4 < 3) encoded[i] = static_cast<unsigned char>(255.0F * srgb + 0.5F);
    }
    written = stbi_write_png(asked.out.c_str(), asked.width, asked.height, 4, encoded.data(), 0);
  } else {
    written =
        stbi_write_hdr(asked.out.c_str(), asked.width, asked.height, 4, picture.texels.data());
  }
  if (!written) fail(asked.out + " cannot be written");
  std::printf("%s: %d x %d, %.1f ms a frame on %s\n", asked.out.c_str(), asked.width, asked.height,
              picture.ms, device);
}
