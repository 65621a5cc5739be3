// groundglass convert: a picture of linear radiance, as truth writes it, for a display.
#include "commands/commands.h"
#include "commands/options.h"
#include "core/error.h"
#include "frame/display.h"
#include "image/image.h"

#include <fmt/core.h>

#include <cmath>

namespace gg::commands {
namespace {

struct ConvertOptions {
  std::string picture, out, tonemap = "neutral";
  float exposure = 0.0f; // EV
};

void convert(const ConvertOptions& o) {
  if (!image::is_writable_extension(o.out))
    throw Error(ExitCode::usage, o.out, "has an extension that is not known",
                "Write .png or .jpg (for display), or .exr, .hdr or .pfm (linear radiance).");
  if (!std::isfinite(o.exposure))
    throw Error(ExitCode::usage, "--exposure", "must be a finite number of stops");
  const frame::ToneMap tone_map = frame::parse_tone_map(o.tonemap);
  const image::Image picture = image::read(o.picture);
  image::require_finite(picture, o.picture);
  image::write(o.out, image::is_display_extension(o.out)
                          ? frame::for_display(picture, o.exposure, tone_map)
                          : picture);
  fmt::print(text_stream({o.out}), "{}: {} x {} pixels\n", o.out, picture.width, picture.height);
}

} // namespace

void add_convert(Command program) {
  auto options = std::make_shared<ConvertOptions>();
  Command command = program.subcommand(
      "convert", "Write a picture as another kind of file: an .exr as a .png, say");
  command.option("PICTURE", &options->picture, "The picture to read (.exr, .hdr, .pfm, .png, .jpg)")
      .required();
  command.option("-o,--output", &options->out, "Picture to write: .png, .jpg, .exr, .hdr or .pfm")
      .required();
  command.option("--exposure", &options->exposure, "Stops of brightness added for display");
  command.option("--tonemap", &options->tonemap, "none, neutral, aces or agx (.png, .jpg)");
  command.action([options] { convert(*options); });
}

} // namespace gg::commands
