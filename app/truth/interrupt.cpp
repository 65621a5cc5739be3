#include "truth/interrupt.h"

#include <array>
#include <atomic>
#include <csignal>

namespace gg::truth {
namespace {

constexpr std::array signals{SIGINT, SIGTERM};
std::array<struct sigaction, signals.size()> previous{};
// A signal handler may only touch lock-free atomics.
std::atomic<bool> stop{false};
static_assert(std::atomic<bool>::is_always_lock_free);

void restore() {
  for (std::size_t i = 0; i < signals.size(); ++i)
    ::sigaction(signals[i], &previous[i], nullptr);
}

void on_signal(int) {
  stop.store(true);
  restore(); // sigaction is async-signal-safe
}

} // namespace

Interruptible::Interruptible() {
  stop.store(false);
  struct sigaction ask {};
  ask.sa_handler = on_signal;
  sigemptyset(&ask.sa_mask);
  for (std::size_t i = 0; i < signals.size(); ++i)
    ::sigaction(signals[i], &ask, &previous[i]);
}

Interruptible::~Interruptible() {
  restore();
}

bool Interruptible::requested() {
  return stop.load();
}

} // namespace gg::truth
