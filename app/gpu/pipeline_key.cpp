#include "gpu/pipeline_key.h"

namespace gg::gpu {
namespace {

class Key {
public:
  explicit Key(const std::string& stages) : text_(stages) {}

  void add(char what, auto... values) {
    text_ += ' ';
    text_ += what;
    ((text_ += std::to_string(static_cast<std::uint32_t>(values)) + ','), ...);
  }
  void add(const std::vector<Constant>& constants) {
    for (const Constant& constant : constants)
      add('c', constant.id, constant.bits);
  }
  const std::string& text() const { return text_; }

private:
  std::string text_;
};

} // namespace

std::string key_of(const PipelineDesc& desc) {
  Key key(desc.vertex + ' ' + desc.fragment);
  key.add(desc.constants);
  for (const VertexBinding& binding : desc.bindings)
    key.add('b', binding.stride, binding.step);
  for (const Attribute& a : desc.attributes)
    key.add('a', a.location, a.components, a.binding, a.offset);
  for (const Format color : desc.colors)
    key.add('o', color);
  key.add('d', desc.depth, desc.depth_write, desc.depth_compare, desc.cull, desc.blend);
  return key.text();
}

std::string key_of(const ComputeDesc& desc) {
  Key key(desc.compute);
  key.add(desc.constants);
  return key.text();
}

} // namespace gg::gpu
