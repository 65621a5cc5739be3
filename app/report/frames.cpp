#include "report/frames.h"

#include "core/error.h"
#include "core/progress.h"
#include "environment/stack.h"
#include "report/key.h"
#include "report/timing.h"
#include "report/truths.h"
#include "truth/interrupt.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <chrono>
#include <map>

namespace gg::report {
namespace {

void stop_if_asked() {
  if (truth::Interruptible::requested()) throw Interrupted{};
}

std::string today() {
  const auto now = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}",
                     fmt::gmtime(std::chrono::system_clock::to_time_t(now)));
}

// A method's renderer, and the device memory that it took.
struct Drawing {
  std::unique_ptr<frame::Renderer> renderer;
  std::size_t bytes = 0;
};

// One scene on one device: its environment, and a renderer for each method, made once: what it has
// compiled serves its pictures of every number of samples and their timing.
class Stage {
public:
  Stage(gpu::Device& device, const Plan& plan, const Subject& subject, const Loaded& loaded)
      : device_(device), plan_(plan), subject_(subject), loaded_(loaded) {
    const std::size_t before = device.memory_bytes();
    if (loaded.environment) stack_ = environment::build_or_load(device, *loaded.environment);
    environment_bytes_ = device.memory_bytes() - before;
  }

  gpu::Device& device() const { return device_; }
  std::size_t environment_bytes() const { return environment_bytes_; }

  const Drawing& drawing(const Method& method) {
    Drawing& drawing = drawings_[method.name];
    if (drawing.renderer) return drawing;
    const std::size_t before = device_.memory_bytes();
    drawing.renderer = std::make_unique<frame::Renderer>(
        device_, loaded_.scene,
        frame::FrameDesc{
            .width = subject_.width,
            .height = subject_.height,
            .samples = plan_.samples.front(),
            .camera = loaded_.camera,
            .environment = {stack_ ? &*stack_ : nullptr, loaded_.rotation, loaded_.intensity},
            .method = method.method,
            .correlated_smith = plan_.correlated_smith,
            .multiple_scattering = plan_.multiple_scattering});
    drawing.bytes = device_.memory_bytes() - before;
    return drawing;
  }

private:
  gpu::Device& device_;
  const Plan& plan_;
  const Subject& subject_;
  const Loaded& loaded_;
  std::optional<environment::Stack> stack_;
  std::size_t environment_bytes_ = 0;
  std::map<std::string, Drawing> drawings_; // by method
};

std::string picture_key(const Subject& subject, const Plan& plan, const DeviceFacts& device,
                        const Method& method, int samples) {
  Key key;
  for (const std::string& text :
       {subject.key, key_of_frame_program(), device.backend, device.surface, device.name,
        device.driver, method.name, std::string(plan.correlated_smith ? "correlated" : ""),
        std::string(plan.multiple_scattering ? "multiple" : "")})
    key.add(text);
  return key.add(samples).text();
}

image::Image draw(Stage& stage, const Method& method, int samples, const std::string& what) {
  Progress progress(what, samples);
  progress.update(0);
  frame::Renderer& renderer = *stage.drawing(method).renderer;
  if (frame::FrameDesc desc = renderer.desc(); desc.samples != samples) {
    desc.samples = samples;
    renderer.set(desc);
  }
  for (int i = 0; i < samples; ++i) {
    stop_if_asked();
    renderer.draw_sample(i);
    progress.update(i + 1);
  }
  return renderer.read();
}

// Fills in times, bytes, triangles and lookups of all cells.
void time_all(const std::vector<std::unique_ptr<Stage>>& stages, const Plan& plan,
              const std::string& what, std::vector<Cell>& cells) {
  std::vector<Timed> timed;
  for (const auto& stage : stages)
    for (const Method& method : plan.methods) {
      stop_if_asked();
      const Drawing& drawing = stage->drawing(method);
      for (const int samples : plan.samples) {
        Cell& cell = cells[timed.size()];
        cell.bytes = stage->environment_bytes() + drawing.bytes;
        cell.triangles = drawing.renderer->triangle_count();
        cell.lookups = drawing.renderer->needs().lookups;
        timed.push_back({&stage->device(), drawing.renderer.get(), samples});
      }
    }
  Progress progress(what + ": timing", plan.pictures);
  const std::vector<Timing> timings = time_in_turn(timed, plan.pictures, [&](int round) {
    stop_if_asked();
    progress.update(round);
  });
  for (std::size_t i = 0; i < cells.size(); ++i)
    cells[i].timing = timings[i];
}

nlohmann::json times_of(const std::vector<Cell>& cells, const std::string& measured) {
  nlohmann::json list = nlohmann::json::array();
  for (const Cell& cell : cells) {
    nlohmann::json one = to_json(cell.timing);
    one["device_memory_bytes"] = cell.bytes;
    one["triangles"] = cell.triangles;
    one["lookups"] = to_json(cell.lookups);
    list.push_back(std::move(one));
  }
  return {{"measured", measured}, {"cells", std::move(list)}};
}

// True if the cache has them all.
bool take_times(const std::optional<nlohmann::json>& times, Drawn& result) {
  if (times) try {
      const auto& list = times->at("cells");
      std::vector<Cell> cells = result.cells;
      for (std::size_t i = 0; i < cells.size(); ++i) {
        cells[i].timing = timing_from(list.at(i));
        cells[i].bytes = list.at(i).at("device_memory_bytes");
        cells[i].triangles = list.at(i).at("triangles");
        cells[i].lookups = lookups_from(list.at(i).at("lookups"));
      }
      result.measured = times->at("measured");
      result.cells = std::move(cells);
      return true;
    } catch (const nlohmann::json::exception&) {
    }
  return false;
}

} // namespace

gpu::Device& Devices::at(std::size_t i) {
  if (!open_[i]) open_[i] = plan_.devices[i].second();
  return *open_[i];
}

Drawn drawn(const Subject& subject, const Plan& plan, const Cache& cache, Devices& devices,
            const std::function<const Loaded&()>& loaded) {
  Drawn result;
  Key all;
  for (std::size_t d = 0; d < devices.count(); ++d) {
    const gpu::DeviceInfo& info = devices.at(d).info();
    for (const Method& method : plan.methods)
      for (const int samples : plan.samples) {
        result.cells.push_back({.method = method.name,
                                .samples = samples,
                                .device = {info.backend, info.surface, info.name, info.driver}});
        result.picture_keys.push_back(
            picture_key(subject, plan, result.cells.back().device, method, samples));
        all.add(result.picture_keys.back());
      }
  }
  const std::string times_key = all.add(plan.pictures).text();

  std::vector<std::unique_ptr<Stage>> stages(devices.count());
  const auto stage = [&](std::size_t d) -> Stage& {
    if (!stages[d]) stages[d] = std::make_unique<Stage>(devices.at(d), plan, subject, loaded());
    return *stages[d];
  };
  for (std::size_t i = 0; i < result.cells.size(); ++i) {
    const std::string& key = result.picture_keys[i];
    if (cache.has("picture", key, "exr")) continue;
    const std::size_t sets = plan.methods.size() * plan.samples.size(); // of a device
    const Method& method = plan.methods[i % sets / plan.samples.size()];
    const int samples = result.cells[i].samples;
    const std::string what =
        fmt::format("{}: {}, {} sample{} on {}", subject.name, method.name, samples,
                    samples == 1 ? "" : "s", result.cells[i].device.backend);
    const image::Image picture = draw(stage(i / sets), method, samples, what);
    if (const auto bad = image::find_non_finite(picture))
      throw Error(ExitCode::internal, what,
                  fmt::format("drew {} in pixel ({}, {})", bad->value, bad->x, bad->y),
                  "Please report it with the scene.");
    image::write(cache.path("picture", key, "exr"), picture);
    ++result.pictures;
  }
  if (!take_times(cache.json("times", times_key), result)) {
    for (std::size_t d = 0; d < devices.count(); ++d)
      stage(d);
    time_all(stages, plan, subject.name, result.cells);
    result.measured = today();
    result.timed = true;
    cache.store("times", times_key, times_of(result.cells, result.measured));
  }
  return result;
}

} // namespace gg::report
