#include "tables/make_tables.h"

#include "core/error.h"
#include "core/progress.h"
#include "tables/make_interface.h"
#include "tables/make_reflection.h"
#include "tables/thin_wall.h"

#include <functional>
#include <optional>
#include <regex>
#include <vector>

namespace gg::tables {
namespace {

// One file to be made: how many steps it takes, how long each is beside others', and what to do.
struct Task {
  std::string file;
  int steps = 0, share = 1;
  std::function<void(const Step&)> make;
};

// What tables share, made when the first of them asks.
class Workshop {
public:
  Workshop(std::filesystem::path directory, Progress& progress)
      : directory_(std::move(directory)), progress_(progress) {}

  const std::filesystem::path& directory() const { return directory_; }
  const FitViews& views() {
    if (!views_) views_.emplace(make_fit_views(&progress_));
    return *views_;
  }
  // The grid that lobes are fitted on, kept for the tables of other numbers of gaussians.
  const Grid& grid(const std::string& of, const std::function<Grid()>& make) {
    if (grid_of_ != of) {
      grid_ = {};
      grid_ = make();
      grid_of_ = of;
    }
    return grid_;
  }

private:
  std::filesystem::path directory_;
  Progress& progress_;
  std::optional<FitViews> views_;
  std::string grid_of_;
  Grid grid_;
};

std::vector<Task> tasks(Workshop& shop) {
  const Step none = [] {};
  std::vector<Task> list;
  for (const Model& model : models) {
    const std::string of = name(model);
    list.push_back(
        {"reflection-energy-" + of, reflection_energy_steps(), 1, [&shop, model](auto& step) {
           write(shop.directory(), make_reflection_energy(model, step));
         }});
    list.push_back(
        {"interface-energy-" + of, interface_energy_steps(), 1, [&shop, model](auto& step) {
           write(shop.directory(), make_interface_energy(model, step));
         }});
    for (int gaussians = 1; gaussians <= lobes_of(model); ++gaussians)
      list.push_back({"reflection-lobes" + std::to_string(gaussians) + "-" + of,
                      reflection_lobe_steps(), gaussians,
                      [&shop, model, gaussians, of, none](auto& step) {
                        const Grid& grid = shop.grid("reflection-" + of, [&] {
                          return reflection_grid(shop.views(), model, none);
                        });
                        write(shop.directory(),
                              make_reflection_lobes(model, shop.views(), grid, gaussians, step));
                      }});
    for (int gaussians = 1; gaussians <= lobes_of(model); ++gaussians)
      list.push_back({"interface-lobes" + std::to_string(gaussians) + "-" + of,
                      interface_lobe_steps(), gaussians,
                      [&shop, model, gaussians, of, none](auto& step) {
                        const Grid& grid = shop.grid("interface-" + of, [&] {
                          return interface_grid(shop.views(), model, none);
                        });
                        write(shop.directory(),
                              make_interface_lobes(model, shop.views(), grid, gaussians, step));
                      }});
    list.push_back(
        {"thin-wall-energy-" + of, thin_wall_grid_steps(), 1, [&shop, model](auto& step) {
           write(shop.directory(), thin_wall_grid(shop.views(), model, step).energy);
         }});
    for (int gaussians = 1; gaussians <= most_wall_lobes; ++gaussians)
      list.push_back({"thin-wall-lobes" + std::to_string(gaussians) + "-" + of,
                      thin_wall_lobe_steps(), gaussians,
                      [&shop, model, gaussians, of, none](auto& step) {
                        const Grid& grid = shop.grid("wall-" + of, [&] {
                          return thin_wall_grid(shop.views(), model, none).grid;
                        });
                        write(shop.directory(),
                              make_thin_wall_lobes(model, shop.views(), grid, gaussians, step));
                      }});
  }
  return list;
}

} // namespace

void make_tables(const std::filesystem::path& directory, const std::string& only) {
  std::regex expression;
  try {
    expression = std::regex(only, std::regex::extended);
  } catch (const std::regex_error&) {
    throw Error(ExitCode::usage, only, "is not a regular expression",
                "For instance lobes[12]-ggx.");
  }
  const auto wanted = [&](const Task& task) { return std::regex_search(task.file, expression); };
  long total = 0;
  {
    Progress unseen("tables", 0);
    Workshop shop(directory, unseen);
    for (const Task& task : tasks(shop))
      if (wanted(task)) total += task.steps * task.share;
  }
  if (total == 0)
    throw Error(ExitCode::usage, only, "is in no table's name",
                "Names are such as interface-lobes2-ggx-separable.");
  Progress progress("tables", total);
  Workshop shop(directory, progress);
  long done = 0;
  for (const Task& task : tasks(shop)) {
    if (!wanted(task)) continue;
    progress.update(done, task.file);
    task.make([&] { progress.update(done += task.share, task.file); });
  }
}

} // namespace gg::tables
