#include "report/exports.h"

#include "report/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gg::report {
namespace {

using nlohmann::json;

json to_json(const Cell& c) {
  json result{{"method", c.method},
              {"samples", c.samples},
              {"lookups", report::to_json(c.lookups)},
              {"backend", c.device.backend},
              {"surface", c.device.surface},
              {"device", c.device.name},
              {"driver", c.device.driver},
              {"device_memory_bytes", c.bytes},
              {"triangles", c.triangles},
              {"errors", to_json(c.verdict)},
              {"command", c.command}};
  result.update(to_json(c.timing));
  return result;
}

json to_json(const Section& s) {
  json result{{"scene", s.name},
              {"path", s.path},
              {"environment", s.environment},
              {"width", s.width},
              {"height", s.height},
              {"objects", s.objects},
              {"measured", s.measured},
              {"truth",
               {{"samples", s.truth_samples},
                {"relative_error", s.truth_error},
                {"seconds", s.truth_seconds},
                {"command", s.truth_command}}},
              {"needs", s.needs},
              {"cells", json::array()},
              {"front", s.front},
              {"front_trimmed", s.front_trimmed}};
  for (const Cell& cell : s.cells)
    result["cells"].push_back(to_json(cell));
  if (s.choice) result["choice"] = {{"cell", s.choice->index}, {"met", s.choice->met}};
  return result;
}

} // namespace

json to_json(const Report& report) {
  json result{{"schema", 2},
              {"groundglass", report.version},
              {"command", report.command},
              {"scenes", json::array()}};
  if (report.limit.max_error) result["max_error"] = *report.limit.max_error;
  if (report.limit.budget) result["budget_ms"] = *report.limit.budget;
  for (const Section& section : report.sections)
    result["scenes"].push_back(to_json(section));
  return result;
}

std::string to_csv(const Report& report) {
  std::string text = "scene,method,samples,backend,device,width,height,reflected,refracted,"
                     "internally_reflected,residual,ms_median,"
                     "ms_low_quartile,ms_high_quartile,ms_min,ms_max,pictures,relmse,relmse_"
                     "trimmed,relmse_of_noise,"
                     "pixels_within_noise,rmse,bias,absolute_difference_p99,psnr_db,flip,frame_"
                     "relmse,frame_relmse_trimmed,frame_flip,"
                     "pixels,device_memory_bytes,triangles,on_front,on_front_trimmed\n";
  for (const Section& s : report.sections)
    for (std::size_t i = 0; i < s.cells.size(); ++i) {
      const Cell& c = s.cells[i];
      const Spread& ms = c.timing.picture;
      const image::Errors& e = c.verdict.objects;
      const auto on = [&](const std::vector<std::size_t>& front) {
        return std::ranges::find(front, i) != front.end() ? 1 : 0;
      };
      text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},", csv_field(s.name),
                          csv_field(c.method), c.samples, csv_field(c.device.backend),
                          csv_field(c.device.name), s.width, s.height, c.lookups.reflected,
                          c.lookups.refracted, c.lookups.internally_reflected, c.lookups.residual);
      text += fmt::format("{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{},", ms.median, ms.low_quartile,
                          ms.high_quartile, ms.least, ms.most, ms.count);
      text += fmt::format("{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},",
                          e.relmse, e.relmse_trimmed, e.noise ? e.noise->relmse : 0.0,
                          e.noise ? e.noise->pixels_within : 0.0, e.rmse, e.bias, e.p99, e.psnr,
                          e.flip);
      text += fmt::format("{:.6g},{:.6g},{:.6g},{},{},{},{},{}\n", c.verdict.frame.relmse,
                          c.verdict.frame.relmse_trimmed, c.verdict.frame.flip, e.pixels, c.bytes,
                          c.triangles, on(s.front), on(s.front_trimmed));
    }
  return text;
}

} // namespace gg::report
