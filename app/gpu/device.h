// The device: makes objects, runs passes, reads results back. One interface, one implementation per
// backend.
#pragma once

#include "gpu/types.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace gg::gpu {

// Records what one pass does. Valid only inside Pass::record. Resources are bound by the names that
// the GLSL text gives them (reflection finds where they live); a name that the pipeline does not
// use is ignored, one that it uses and that is not bound when drawing is an Error(internal) naming
// both.
class Encoder {
public:
  virtual ~Encoder() = default;
  virtual void use(const PipelineRef& pipeline) = 0;
  virtual void buffer(std::string_view block, const BufferRef& buffer, std::size_t offset = 0,
                      std::size_t bytes = 0) = 0; // uniform or storage block; bytes 0 = to the end
  virtual void texture(std::string_view name, const View& view, const SamplerRef& sampler) = 0;
  virtual void image(std::string_view name, const View& view) = 0; // storage image, one level
  virtual void vertices(int binding, const BufferRef& buffer, std::size_t offset = 0) = 0;
  virtual void indices(const BufferRef& buffer) = 0; // 32 bit
  virtual void cull(Cull cull) = 0;                  // in place of the pipeline's own
  virtual void
  front_is_clockwise(bool clockwise) = 0; // for mirrored instances; false at the start of a pass
  virtual void draw(std::uint32_t vertex_count, std::uint32_t instance_count = 1) = 0;
  virtual void draw_indexed(std::uint32_t index_count, std::uint32_t instance_count = 1,
                            std::uint32_t first_index = 0) = 0;
  virtual void dispatch(std::uint32_t x, std::uint32_t y, std::uint32_t z) = 0;
};

// A pass declares what it reads and writes; who orders and synchronises is the backend's business.
// A pass draws (it has targets) or computes (it has none). Not declaring what some pass writes is an
// Error(internal) when it is bound; what is only ever uploaded need not be declared. The draws and
// dispatches of one pass do not see what its others store.
struct Pass {
  std::string label; // of the debug group and of the timer
  std::vector<ColorTarget> colors;
  std::optional<DepthTarget> depth;
  std::vector<View> reads;                              // sampled textures
  std::vector<View> storage;                            // storage images, read and written
  std::vector<BufferRef> reads_buffers, writes_buffers; // storage buffers
  std::function<void(Encoder&)> record;
};

struct PassTime {
  std::string label;
  double ms = 0.0;
};

struct DeviceInfo {
  int index = 0;       // for --device
  std::string backend; // "opengl", "vulkan"
  std::string surface; // "egl", "osmesa", "headless", "window"
  std::string name;    // the renderer's own words
  std::string driver;  // version
  bool software = false;
};

// What a device has done since it was made. A frame in steady state changes none of the first
// three.
struct DeviceCounters {
  std::uint64_t created = 0;     // objects of the API: buffers, textures, views, samplers, programs
  std::uint64_t allocations = 0; // of device memory, where the API lets us ask for it
  std::uint64_t compiled = 0;    // shader modules and pipelines
  std::uint64_t submissions = 0, passes = 0, draws = 0, dispatches = 0;
  double record_ms = 0.0; // host time in run(), recording and submitting; waiting is not counted
};

// Used by one thread at a time, the one that created it. Objects may outlive their device.
class Device {
public:
  virtual ~Device() = default;
  virtual const DeviceInfo& info() const = 0;

  // Creation throws Error(device) when memory runs out or a limit is passed, naming the label and
  // the size.
  virtual BufferRef create(const BufferDesc& desc, std::span<const std::byte> contents = {}) = 0;
  virtual TextureRef create(const TextureDesc& desc) = 0;
  virtual SamplerRef create(const SamplerDesc& desc) = 0; // equal descriptions give the same object
  virtual PipelineRef
  create(const PipelineDesc& desc) = 0; // Error(internal) with the compiler's log
  virtual PipelineRef create(const ComputeDesc& desc) = 0;
  // These pipelines will be created: their stages are compiled on other threads meanwhile. Never necessary; what is wrong with
  // one is said when it is created.
  virtual void expect(std::span<const PipelineDesc> pipelines) = 0;
  virtual void expect(std::span<const ComputeDesc> pipelines) = 0;

  // Texels of one level and layer (slice, face), tightly packed, row 0 first.
  virtual void upload(const TextureRef& texture, int level, int layer,
                      std::span<const std::byte> texels) = 0;
  virtual void upload(const BufferRef& buffer, std::size_t offset,
                      std::span<const std::byte> bytes) = 0;
  virtual void
  generate_mipmaps(const TextureRef& texture) = 0; // box filter, in linear light for sRGB formats
  virtual std::vector<std::byte> read(const TextureRef& texture, int level, int layer) = 0;
  virtual std::vector<std::byte> read(const BufferRef& buffer, std::size_t offset,
                                      std::size_t bytes) = 0;

  // Runs the passes in order. With `times`, each pass's duration on the device is appended (this
  // waits for the device).
  virtual void run(std::span<const Pass> passes, std::vector<PassTime>* times = nullptr) = 0;
  virtual void finish() = 0; // waits until everything asked for is done

  virtual std::size_t memory_bytes() const = 0; // held by buffers and textures that are alive
  virtual int max_texture_size() const = 0;
  virtual DeviceCounters counters() const = 0;
};

enum class Backend { opengl, vulkan };
enum class Surface { automatic, egl, osmesa };

struct DeviceDesc {
  Backend backend = Backend::opengl;
  Surface surface = Surface::automatic; // EGL if it works, else OSMesa
  int device = -1;                      // index in the listing; -1 prefers a real GPU
  bool debug = false;                   // messages of the driver become Error(device)
};

// Throws Error(device): what is missing (library, driver, version, extension) and what to install
// or choose.
std::unique_ptr<Device> create_device(const DeviceDesc& desc);

// Every device that each backend and surface offers on this machine. Never throws for a missing
// driver: it is not listed.
std::vector<DeviceInfo> list_devices();

} // namespace gg::gpu
