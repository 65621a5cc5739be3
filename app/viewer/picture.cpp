#include "viewer/picture.h"

namespace gg::viewer {

void Picture::open(std::shared_ptr<const scene::Scene> scene) {
  renderer_.reset(); // before the scene that it reads
  scene_ = std::move(scene);
}

void Picture::light(const environment::Map* map) {
  std::shared_ptr<const environment::Stack> stack;
  if (map) stack = std::make_shared<const environment::Stack>(environment::build(device_, *map));
  renderer_.reset(); // before the cubes that it reads
  stack_ = std::move(stack);
}

void Picture::light_as(const Picture& other) {
  if (stack_ != other.stack_) renderer_.reset();
  stack_ = other.stack_;
  set_light(other.rotation_, other.intensity_);
}

void Picture::set_light(float rotation, float intensity) {
  rotation_ = rotation;
  intensity_ = intensity;
}

void Picture::set(frame::FrameDesc desc) {
  desc_ = std::move(desc);
  restart();
}

void Picture::restart() {
  desc_.environment = {stack_.get(), rotation_, intensity_};
  if (renderer_)
    renderer_->set(desc_);
  else
    renderer_ = std::make_unique<frame::Renderer>(device_, *scene_, desc_);
  drawn_ = 0;
}

void Picture::draw_sample(std::map<std::string, double>* times) {
  renderer_->draw_sample(drawn_, times);
  ++drawn_;
}

float Picture::factor() const {
  return drawn_ > 0 && desc_.samples > 1
             ? static_cast<float>(desc_.samples) / static_cast<float>(drawn_)
             : 1.0f;
}

image::Image Picture::read() {
  return renderer_->read();
}

} // namespace gg::viewer
