// The pictures and times of a scene, by every method on every device.
#pragma once

#include "report/cache.h"
#include "report/results.h"
#include "report/subject.h"

#include <functional>
#include <memory>

namespace gg::report {

// The devices of a plan: opened when first asked for, then kept.
class Devices {
public:
  explicit Devices(const Plan& plan) : plan_(plan), open_(plan.devices.size()) {}
  gpu::Device& at(std::size_t i);
  std::size_t count() const { return open_.size(); }

private:
  const Plan& plan_;
  std::vector<std::unique_ptr<gpu::Device>> open_;
};

struct Drawn {
  std::vector<Cell>
      cells; // device by device, method by method, sample count by sample count; without verdicts
  std::vector<std::string> picture_keys;
  std::string measured;     // when the times were taken
  std::size_t pictures = 0; // drawn in this run
  bool timed = false;       // in this run
};

// Draws what the cache does not have. Times are of one sitting: if one of them is not in the cache
// under this very list of methods and devices, all are taken again, in turn. Throws Interrupted.
Drawn drawn(const Subject& subject, const Plan& plan, const Cache& cache, Devices& devices,
            const std::function<const Loaded&()>& loaded);

} // namespace gg::report
