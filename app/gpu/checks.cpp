#include "gpu/checks.h"

#include "core/error.h"

#include <algorithm>

namespace gg::gpu {
namespace {

[[noreturn]] void wrong(const std::string& where, const std::string& what) {
  throw Error(ExitCode::internal, where, what);
}

[[noreturn]] void too_large(const std::string& where, const std::string& what) {
  throw Error(ExitCode::device, where, what,
              "Use a smaller picture, scene or environment, or another --device.");
}

std::string number(std::size_t value) {
  return std::to_string(value);
}

std::string in_pass(const Pass& pass) {
  return "pass '" + pass.label + "'";
}

bool same_texture_part(const View& a, const View& b) {
  return a.texture == b.texture && a.level < b.level + b.level_count
         && b.level < a.level + a.level_count && a.layer < b.layer + b.layer_count
         && b.layer < a.layer + a.layer_count;
}

bool is_cube(Shape shape) {
  return shape == Shape::cube || shape == Shape::cube_array;
}

} // namespace

std::string describe(const BufferDesc& desc) {
  return "buffer '" + desc.label + "' (" + number(desc.bytes) + " bytes)";
}

std::string describe(const TextureDesc& desc) {
  const int layers = extent(desc, 0).layers;
  return "texture '" + desc.label + "' (" + std::to_string(desc.width) + " x "
         + std::to_string(desc.height) + (layers > 1 ? " x " + std::to_string(layers) : "") + ", "
         + std::to_string(desc.levels) + (desc.levels == 1 ? " level)" : " levels)");
}

std::string describe(const SamplerDesc& desc) {
  std::string text = desc.magnify == Filter::linear && desc.minify == Filter::linear ? "linear"
                     : desc.magnify == desc.minify                                   ? "nearest"
                                                                                     : "mixed";
  if (desc.between_levels == Filter::linear) text += " between levels too";
  if (desc.max_anisotropy > 1.0f) text += ", anisotropic";
  const bool same = desc.u == desc.v && desc.v == desc.w;
  text += !same                    ? ", wraps mixed"
          : desc.u == Wrap::clamp  ? ", clamped"
          : desc.u == Wrap::repeat ? ", repeated"
                                   : ", mirrored";
  return text;
}

void check(const BufferDesc& desc, std::span<const std::byte> contents, const Limits& limits) {
  if (desc.label.empty()) wrong("a buffer", "has no label");
  if (desc.bytes == 0) wrong(describe(desc), "is empty");
  if (contents.size() > desc.bytes)
    wrong(describe(desc), "is given " + number(contents.size()) + " bytes");
  if (has(desc.use, Use::storage) && desc.bytes > limits.storage_bytes)
    too_large(describe(desc), "is larger than the " + number(limits.storage_bytes)
                                  + " bytes that this device takes");
}

void check(const TextureDesc& desc, const Limits& limits) {
  if (desc.label.empty()) wrong("a texture", "has no label");
  const std::string name = describe(desc);
  if (desc.format == Format::none) wrong(name, "has no format");
  if (desc.width < 1 || desc.height < 1 || desc.layers < 1) wrong(name, "has no texels");
  if (desc.levels < 1 || desc.levels > max_levels(desc))
    wrong(name, "cannot have that many levels");
  if ((desc.shape == Shape::d2 || desc.shape == Shape::cube) && desc.layers != 1)
    wrong(name, "is not an array but has layers");
  if (is_cube(desc.shape) && desc.width != desc.height) wrong(name, "is a cube but not square");
  if (has(desc.use, Use::storage)
      && (desc.format == Format::rgba8_srgb || desc.format == Format::depth32f))
    wrong(name, "is of a format that shaders cannot store");
  const int edge = desc.shape == Shape::d3 ? limits.texture_3d
                   : is_cube(desc.shape)   ? limits.texture_cube
                                           : limits.texture_2d;
  const int layers = desc.shape == Shape::d3 ? limits.texture_3d : limits.array_layers;
  if (desc.width > edge || desc.height > edge)
    too_large(name,
              "is larger than the " + std::to_string(edge) + " texels that this device takes");
  if (extent(desc, 0).layers > layers)
    too_large(name,
              "has more than the " + std::to_string(layers) + " layers that this device takes");
}

void check(const PipelineDesc& desc, const Limits& limits) {
  const std::string name = "pipeline '" + desc.label + "'";
  if (desc.label.empty()) wrong("a pipeline", "has no label");
  if (desc.colors.empty() && desc.depth == Format::none) wrong(name, "draws into nothing");
  if (desc.colors.size() > static_cast<std::size_t>(limits.attachments))
    too_large(name, "draws into more targets than this device has");
  if (desc.depth != Format::none && desc.depth != Format::depth32f)
    wrong(name, "has a depth target whose format is not depth32f");
  for (const Attribute& attribute : desc.attributes) {
    if (attribute.binding < 0
        || static_cast<std::size_t>(attribute.binding) >= desc.bindings.size())
      wrong(name, "has an attribute at location " + std::to_string(attribute.location)
                      + " without a vertex binding");
    if (attribute.components < 1 || attribute.components > 4)
      wrong(name, "has an attribute of " + std::to_string(attribute.components) + " components");
  }
}

void check_range(const BufferDesc& desc, std::size_t offset, std::size_t bytes) {
  if (offset > desc.bytes || bytes > desc.bytes - offset)
    wrong(describe(desc), "has no bytes " + number(offset) + " to " + number(offset + bytes));
}

void check_part(const TextureDesc& desc, int level, int layer) {
  if (level < 0 || level >= desc.levels || layer < 0 || layer >= extent(desc, level).layers)
    wrong(describe(desc),
          "has no level " + std::to_string(level) + ", layer " + std::to_string(layer));
}

void check_texels(const TextureDesc& desc, int level, int layer, std::size_t bytes) {
  check_part(desc, level, layer);
  const Extent size = extent(desc, level);
  const std::size_t expected = static_cast<std::size_t>(size.width)
                               * static_cast<std::size_t>(size.height)
                               * bytes_per_texel(desc.format);
  if (bytes != expected)
    wrong(describe(desc), "level " + std::to_string(level) + " takes " + number(expected)
                              + " bytes, not " + number(bytes));
}

void check_view(const View& view) {
  if (!view.texture) wrong("a view", "is of no texture");
  const TextureDesc& desc = view.texture->desc;
  if (view.level < 0 || view.level_count < 1 || view.level + view.level_count > desc.levels
      || view.layer < 0 || view.layer_count < 1
      || view.layer + view.layer_count > extent(desc, view.level).layers)
    wrong(describe(desc), "is viewed beyond its levels or layers");
}

void check_bound(const View& view, const shaders::Binding& binding, const std::string& pipeline) {
  using shaders::Kind;
  const TextureDesc& desc = view.texture->desc;
  const auto refuse = [&](const std::string& what) {
    wrong("pipeline '" + pipeline + "', " + binding.name, describe(desc) + " " + what);
  };
  if (!has(desc.use, binding.kind == Kind::image ? Use::storage : Use::sampled))
    refuse(binding.kind == Kind::image ? "was not made for storage" : "was not made to be sampled");
  if (binding.kind == Kind::image && view.level_count != 1) refuse("is bound with several levels");
  if (binding.kind == Kind::image && binding.format != Format::none
      && binding.format != desc.format)
    refuse("is of another format than the image");
  const bool integer = desc.format == Format::r32ui || desc.format == Format::rg32ui
                       || desc.format == Format::rgba32ui;
  if (integer != binding.integer) refuse(integer ? "holds integers" : "does not hold integers");
  const bool volume = desc.shape == Shape::d3;
  bool fits = false;
  switch (binding.shape) {
  case Shape::d2:
    fits = view.layer_count == 1 && (!volume || binding.kind == Kind::image);
    break;
  case Shape::d2_array:
    fits = !volume;
    break;
  case Shape::d3:
    fits = volume && view.layer_count == extent(desc, view.level).layers;
    break;
  case Shape::cube:
    fits = is_cube(desc.shape) && view.layer_count == 6;
    break;
  case Shape::cube_array:
    fits = is_cube(desc.shape) && view.layer_count % 6 == 0;
    break;
  }
  if (!fits) refuse("is viewed in a shape that the shader does not expect");
}

void check(const Pass& pass, const Limits& limits) {
  if (pass.label.empty()) wrong("a pass", "has no label");
  if (!pass.record) wrong(in_pass(pass), "records nothing");
  if (pass.colors.size() > static_cast<std::size_t>(limits.attachments))
    too_large(in_pass(pass), "draws into more targets than this device has");
  std::vector<const View*> targets;
  for (const ColorTarget& color : pass.colors)
    targets.push_back(&color.view);
  if (pass.depth) targets.push_back(&pass.depth->view);
  for (const View* target : targets) {
    check_view(*target);
    const TextureDesc& desc = target->texture->desc;
    if (!has(desc.use, Use::attachment))
      wrong(in_pass(pass), describe(desc) + " was not made to be drawn into");
    if (target->level_count != 1 || target->layer_count != 1)
      wrong(in_pass(pass), describe(desc) + " is drawn into by more than one level and layer");
    const bool depth = pass.depth && target == &pass.depth->view;
    if (depth != (desc.format == Format::depth32f))
      wrong(in_pass(pass), describe(desc) + (depth ? " has no depth" : " has no colour"));
    const Extent a = extent(desc, target->level), b = target_extent(pass);
    if (a.width != b.width || a.height != b.height)
      wrong(in_pass(pass), describe(desc) + " differs in size from its other targets");
    for (const View& read : pass.reads)
      if (same_texture_part(*target, read))
        wrong(in_pass(pass), describe(desc) + " is read and drawn into at once");
  }
  for (const View& view : pass.reads)
    check_view(view);
  for (const View& view : pass.storage)
    check_view(view);
}

Extent target_extent(const Pass& pass) {
  const View& view = pass.colors.empty() ? pass.depth->view : pass.colors.front().view;
  return extent(view.texture->desc, view.level);
}

void check_targets(const PipelineDesc& desc, const Pass& pass) {
  const auto refuse = [&](const char* what) {
    wrong(in_pass(pass) + ", pipeline '" + desc.label + "'", what);
  };
  if (desc.colors.size() != pass.colors.size()) refuse("draws into another number of targets");
  for (std::size_t i = 0; i < desc.colors.size(); ++i)
    if (desc.colors[i] != pass.colors[i].view.texture->desc.format)
      refuse("draws into targets of another format");
  if ((desc.depth != Format::none) != pass.depth.has_value())
    refuse("and the pass do not agree about depth");
}

void check_dispatch(std::uint32_t x, std::uint32_t y, std::uint32_t z, const Limits& limits,
                    const std::string& pipeline) {
  if (x > limits.groups || y > limits.groups || z > limits.groups)
    too_large("pipeline '" + pipeline + "'", "a dispatch of " + number(x) + " x " + number(y)
                                                 + " x " + number(z) + " groups is larger than the "
                                                 + number(limits.groups)
                                                 + " along an axis that this device takes");
}

void check_declared(const Pass& pass, const View& view, bool storage) {
  const Use use = view.texture->desc.use;
  if (!storage && !has(use, Use::attachment) && !has(use, Use::storage)) return;
  const std::vector<View>& declared = storage ? pass.storage : pass.reads;
  if (std::ranges::none_of(declared, [&](const View& v) { return same_texture_part(v, view); }))
    wrong(in_pass(pass), describe(view.texture->desc) + " is used but not declared in "
                             + (storage ? "storage" : "reads"));
}

void check_declared(const Pass& pass, const BufferRef& buffer, bool writes) {
  const auto in = [&](const std::vector<BufferRef>& list) {
    return std::ranges::find(list, buffer) != list.end();
  };
  if (!in(pass.writes_buffers) && (writes || !in(pass.reads_buffers)))
    wrong(in_pass(pass), describe(buffer->desc) + " is used but not declared in "
                             + (writes ? "writes_buffers" : "reads_buffers"));
}

} // namespace gg::gpu
