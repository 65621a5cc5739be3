#include "viewer/loading.h"

#include "core/error.h"
#include "needs/left_out.h"

#include <filesystem>
#include <new>
#include <utility>

namespace gg::viewer {

Loading::Loading(const Commands& commands, std::function<void()> wake)
    : commands_(commands), wake_(std::move(wake)), thread_([this] { run(); }) {}

Loading::~Loading() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
    next_.reset();
  }
  changed_.notify_all();
  thread_.join();
}

void Loading::start(Job job) {
  {
    const std::lock_guard lock(mutex_);
    next_ = std::move(job);
  }
  changed_.notify_all();
}

std::optional<Loading::Done> Loading::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(done_, std::nullopt);
}

bool Loading::ready() const {
  const std::lock_guard lock(mutex_);
  return done_.has_value();
}

bool Loading::idle() const {
  const std::lock_guard lock(mutex_);
  return !reading_ && !next_ && !done_;
}

std::string Loading::doing() const {
  const std::lock_guard lock(mutex_);
  return doing_;
}

void Loading::run() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return stopping_ || next_; });
    if (stopping_) return;
    const Job job = *std::exchange(next_, std::nullopt);
    doing_ = std::filesystem::path(job.scene ? job.view.scene : job.view.env).filename().string();
    if (doing_.empty()) doing_ = "the environment";
    if (job.pose) doing_.clear();
    reading_ = true;
    lock.unlock();
    Done done = read(job);
    lock.lock();
    done_ = std::move(done);
    doing_.clear();
    reading_ = false;
    wake_();
  }
}

Loading::Done Loading::read(const Job& job) const {
  Done done{.view = job.view, .pose = job.pose};
  try {
    if (job.scene) done.scene = std::make_shared<scene::Scene>(commands_.load_scene(job.view));
    if (job.scene && !job.pose)
      done.coarse = std::make_shared<const scene::CoarseLists>(scene::coarse_lists(*done.scene));
    if (!job.pose)
      done.map = commands_.load_environment(job.view, done.scene ? *done.scene : *job.current);
    if (job.scene && !job.pose) {
      const frame::FrameDesc desc{
          .width = job.width,
          .height = job.height,
          .camera = commands_.camera(job.view, *done.scene, job.width, job.height),
          .method = commands_.method(job.view.method),
          .without = needs::left_out(job.view.without)};
      done.drawn = Picture::prepare(*done.scene, desc, done.map.has_value());
    }
  } catch (const std::bad_alloc&) {
    done.failure = std::current_exception();
    done.error = job.view.scene + ": there is not enough memory for it";
  } catch (const std::exception& error) {
    done.failure = std::current_exception();
    done.error = error.what();
  }
  return done;
}

} // namespace gg::viewer
