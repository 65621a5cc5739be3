// What a pass has bound by which name, and the checks of what it asks for: the part of an encoder that is
// the same for every backend. Implementation of app/gpu.
#pragma once

#include "gpu/device.h"
#include "gpu/names.h"
#include "gpu/shaders/module.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace gg::gpu {

// One resource of a pipeline: the name it is asked for by, and the number the API binds it to.
struct Slot {
  int name = 0; // in Names
  std::uint32_t unit = 0;
  shaders::Binding binding;
};

// A pipeline as encoders see it.
struct BuiltPipeline : Pipeline {
  std::vector<Slot> slots;
  std::optional<PipelineDesc> drawing; // none: it computes
};

class CheckedEncoder : public Encoder {
public:
  void buffer(std::string_view block, const BufferRef& buffer, std::size_t offset,
              std::size_t bytes) final;
  void texture(std::string_view name, const View& view, const SamplerRef& sampler) final;
  void image(std::string_view name, const View& view) final;

protected:
  // What is bound by a name. Set again, it gets a new version.
  struct Bound {
    enum class What { nothing, buffer, texture, image } what = What::nothing;
    std::uint64_t version = 0;
    BufferRef buffer;
    std::size_t offset = 0, bytes = 0;
    View view;
    SamplerRef sampler;
  };

  explicit CheckedEncoder(const Names& names) : names_(names) {}

  void start(const Pass& pass);
  void let_go() noexcept; // of everything that was bound
  bool drawing() const { return drawing_; }
  const Pass& pass() const { return *pass_; }

  // All throw Error(internal) that names the pass and the pipeline in use.
  [[noreturn]] void refuse(const std::string& what) const;
  // True if the pipeline is another than the last one; resources are to be bound again then.
  bool change(const PipelineRef& pipeline);
  const Bound& bound_to(const Slot& slot) const; // something, of the slot's kind
  // `awaited`: what was written to the buffer may not be visible unless the pass declares it.
  void check_block(const Slot& slot, const Bound& bound, bool awaited) const;
  void check_view_of(const Slot& slot, const Bound& bound) const; // a texture or an image
  void check_vertices(int binding, const BufferRef& buffer, std::size_t offset) const;
  void check_indices(const BufferRef& buffer) const;
  void check_use(bool draws) const; // that the pipeline in use does that
  void check_index_range(const BufferRef& indices, std::uint32_t first, std::uint32_t count) const;

  // The pipeline in use; `Built` is the backend's own type.
  template <class Built>
  Built& pipeline() const {
    return static_cast<Built&>(*pipeline_);
  }

  // By slot of the pipeline: the version that the API has been given.
  std::vector<std::uint64_t> applied_;
  bool resources_changed_ = false;

private:
  Bound* find(std::string_view name);

  const Names& names_;
  const Pass* pass_ = nullptr;
  bool drawing_ = false;
  std::shared_ptr<BuiltPipeline> pipeline_;
  std::vector<Bound> bound_; // by number of the name
  std::uint64_t version_ = 0;
};

} // namespace gg::gpu
