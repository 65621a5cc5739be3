#include "viewer/shader_reload.h"

#include "gpu/shader_files.h"

#include <exception>
#include <utility>

namespace gg::viewer {

ShaderReload::ShaderReload(gpu::Backend backend, std::function<void()> wake)
    : backend_(backend), wake_(std::move(wake)), looked_(Clock::now()) {
  files_.watch(gpu::shader_files());
  thread_ = std::thread([this] { run(); });
}

ShaderReload::~ShaderReload() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void ShaderReload::look() {
  constexpr auto between_looks = std::chrono::milliseconds(500);
  const auto now = Clock::now();
  if (now - looked_ < between_looks) return;
  looked_ = now;
  bool changed = false;
  while (!files_.changed().empty())
    changed = true;
  if (!changed) return;
  {
    const std::lock_guard lock(mutex_);
    wanted_ = true;
  }
  changed_.notify_all();
}

std::optional<ShaderReload::Done> ShaderReload::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(done_, std::nullopt);
}

bool ShaderReload::ready() const {
  const std::lock_guard lock(mutex_);
  return done_.has_value();
}

void ShaderReload::run() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return stopping_ || wanted_; });
    if (stopping_) return;
    wanted_ = false;
    lock.unlock();
    Done done;
    try {
      done.compiled = gpu::recompile_changed_shaders(backend_);
    } catch (const std::exception& error) {
      done.failed = error.what();
    }
    lock.lock();
    done_ = std::move(done);
    wake_();
  }
}

} // namespace gg::viewer
