#include "viewer/picture.h"

#include "needs/needs.h"

#include <algorithm>
#include <utility>

namespace gg::viewer {

std::shared_ptr<Picture::Drawn> Picture::prepare(const scene::Scene& scene,
                                                 const frame::FrameDesc& desc, bool is_lit) {
  auto drawn = std::make_shared<Drawn>(scene);
  drawn->at = desc.camera.world[3];
  drawn->origin->move_to(drawn->at);
  needs::View view = frame::view_of(desc);
  view.camera.world[3] = glm::vec4(0.0f, 0.0f, 0.0f, 1.0f);
  if (is_lit) view.environment = 0; // bytes, which nothing here depends on
  drawn->shapes.emplace(drawn->scene);
  needs::needs_of(drawn->scene, view,
                  &*drawn->shapes); // which asks for the shapes that such frames need
  return drawn;
}

void Picture::open(std::shared_ptr<const scene::Scene> scene, std::shared_ptr<Drawn> drawn,
                   std::shared_ptr<const scene::CoarseLists> coarse) {
  renderer_.reset(); // before the scene that it reads
  pass_ = 0;
  scene_ = std::move(scene);
  coarse_ = std::move(coarse);
  drawn_scene_ = std::move(drawn);
}

void Picture::open_as(const Picture& other) {
  renderer_.reset();
  scene_ = other.scene_;
  drawn_scene_ = other.drawn_scene_;
}

namespace {

bool same_vertices(const scene::Scene& a, const scene::Scene& b) {
  return std::ranges::equal(a.streams, b.streams, {}, &scene::Stream::values,
                            &scene::Stream::values);
}

} // namespace

void Picture::pose(std::shared_ptr<const scene::Scene> scene) {
  // With the file's own vertices: those that are drawn may have been moved to another origin.
  pass_ = 0; // what is being drawn is given up
  const bool moved_alone = same_vertices(*scene_, *scene);
  scene_ = std::move(scene);
  Drawn& drawn = *drawn_scene_;
  if (drawn.scene.indices != scene_->indices) { // the file is another
    coarse_.reset();
    if (renderer_) renderer_->use_coarse(nullptr);
  }
  drawn.scene = *scene_;
  drawn.origin.emplace(drawn.scene);
  drawn.origin->move_to(drawn.at);
  if (!renderer_) return;
  moved_alone ? renderer_->scene_changed() : renderer_->geometry_changed();
}

void Picture::light(std::shared_ptr<const environment::Stack> stack) {
  stack_ = std::move(stack);
}

void Picture::light_as(const Picture& other) {
  stack_ = other.stack_;
  set_light(other.rotation_, other.intensity_);
}

void Picture::set_light(float rotation, float intensity) {
  rotation_ = rotation;
  intensity_ = intensity;
}

void Picture::set(frame::FrameDesc desc, bool exact) {
  desc_ = std::move(desc);
  exact_ = exact;
  Drawn& drawn = *drawn_scene_;
  if (exact || !renderer_) {
    const glm::vec3 at = desc_.camera.world[3];
    if (at != drawn.at) drawn.shapes.reset();
    drawn.at = at;
    drawn.origin->move_to(at);
  }
  place(desc_);
  put(scene_->materials);
  const scene::CoarseLists* coarse = exact ? nullptr : coarse_.get();
  if (renderer_) {
    if (exact) renderer_->scene_changed();
    renderer_->use_coarse(coarse);
    renderer_->set(desc_);
  } else {
    frame::Prepared prepared{.shapes = std::exchange(drawn.shapes, std::nullopt), .coarse = coarse};
    renderer_ = std::make_unique<frame::Renderer>(device_, drawn.scene, desc_, std::move(prepared));
  }
  drawn_stack_ = stack_; // until now the renderer read the one before
  drawn_ = 0;
  pass_ = 0;
}

void Picture::place(frame::FrameDesc& desc) const {
  desc.camera.world[3] -= glm::vec4(drawn_scene_->at, 0.0f);
  desc.environment = {stack_.get(), rotation_, intensity_};
}

void Picture::put(const Materials& materials) {
  std::ranges::copy(materials, drawn_scene_->scene.materials.begin());
}

void Picture::draw_pass(std::map<std::string, double>* times) {
  renderer_->draw_pass(drawn_, pass_, times);
  if (++pass_ < renderer_->pass_count(drawn_)) return;
  pass_ = 0;
  ++drawn_;
  texture_ = renderer_->picture();
  factor_ =
      desc_.samples > 1 ? static_cast<float>(desc_.samples) / static_cast<float>(drawn_) : 1.0f;
}

void Picture::draw_sample(std::map<std::string, double>* times) {
  do
    draw_pass(times);
  while (amid_sample());
}

std::vector<gpu::PipelineDesc> Picture::missing(frame::FrameDesc desc, const Materials* materials) {
  place(desc);
  if (materials) put(*materials);
  auto pipelines = renderer_->missing(desc);
  if (materials) put(scene_->materials);
  return pipelines;
}

void Picture::set_unseen(frame::FrameDesc desc, const Materials* materials) {
  place(desc);
  if (materials) put(*materials);
  renderer_->use_coarse(coarse_.get());
  renderer_->set(desc);
}

void Picture::set_seen() {
  put(scene_->materials);
  renderer_->use_coarse(exact_ ? nullptr : coarse_.get());
  renderer_->set(desc_);
}

image::Image Picture::read() {
  return renderer_->read();
}

} // namespace gg::viewer
