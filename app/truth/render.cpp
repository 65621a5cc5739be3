#include "truth/render.h"

#include "core/clock.h"

#include <tbb/blocked_range2d.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <optional>

namespace gg::truth {
namespace {

// How many samples the next pass takes, after which the error decides whether there is another: they
// grow by a sixteenth. It depends on no clock, so that the same command ends with the same samples.
long pass_size(long done, long goal, long pixels) {
  constexpr long most_in_a_pass = 1L << 21;
  const long short_enough = std::max(1L, most_in_a_pass / pixels);
  return std::clamp(done / least_samples, 1L, std::min(short_enough, goal - done));
}

// One pass into a copy of the film; false if it was stopped on the way.
bool add_pass(const Integrator& integrator, const Camera& camera, std::uint64_t seed, long count,
              Film& film, const std::function<bool()>& stop) {
  const long first = film.samples();
  std::atomic<bool> going{true};
  constexpr int tile = 16; // pixels: some milliseconds of work, enough tiles for all threads
  tbb::parallel_for(tbb::blocked_range2d<int>(0, film.height(), tile, 0, film.width(), tile),
                    [&](const tbb::blocked_range2d<int>& range) {
                      if (!going.load()) return;
                      for (int y = range.rows().begin(); y < range.rows().end(); ++y)
                        for (int x = range.cols().begin(); x < range.cols().end(); ++x) {
                          Pixel& pixel = film.at(x, y);
                          const std::uint64_t place = static_cast<std::uint64_t>(y)
                                                          * static_cast<std::uint64_t>(film.width())
                                                      + static_cast<std::uint64_t>(x);
                          for (long k = first; k < first + count; ++k) {
                            Random random = Random::stratified(seed, place, k);
                            const glm::dvec2 at = random.uniform2(); // box filter of one pixel
                            const Sample sample =
                                integrator.trace(camera.through(x + at.x, y + at.y), random);
                            pixel.add(k, sample);
                          }
                        }
                      if (stop()) going.store(false);
                    });
  film.add_samples(count);
  return going.load();
}

} // namespace

bool render(const Integrator& integrator, const Camera& camera, const RenderDesc& desc, Film& film,
            const Watch& watch) {
  // TBB grants no more threads than the machine has, unless it is told.
  std::optional<tbb::global_control> allowed;
  if (desc.threads > 0)
    allowed.emplace(tbb::global_control::max_allowed_parallelism,
                    static_cast<std::size_t>(desc.threads));
  tbb::task_arena arena(desc.threads > 0 ? desc.threads : tbb::task_arena::automatic);
  const long pixels = static_cast<long>(film.width()) * film.height();
  double error = film.samples() > 0 ? film.relative_error() : INFINITY;
  long pass_ends = film.samples();
  double samples_a_second = 0.0;
  while (film.samples() < desc.samples) {
    const long done = film.samples();
    if (done >= pass_ends) {
      if (desc.error > 0.0 && done >= least_samples && error <= desc.error) break;
      pass_ends = done + pass_size(done, desc.samples, pixels);
    }
    if (watch.stop()) return false;
    // In parts of about a second.
    const long count = std::clamp(static_cast<long>(samples_a_second), 1L, pass_ends - done);
    const auto start = Clock::now();
    Film next = film;
    const bool complete = arena.execute(
        [&] { return add_pass(integrator, camera, desc.seed, count, next, watch.stop); });
    if (!complete) return false;
    const double seconds = seconds_since(start);
    // A pass shorter than the clock's step.
    samples_a_second = std::min(static_cast<double>(count) / std::max(seconds, 1e-6), 1e9);
    film = std::move(next);
    error = film.relative_error();
    watch.report(film, error);
  }
  return true;
}

} // namespace gg::truth
