// What the viewer shows and what its panels ask for. Data only: panels and input change it, the viewer carries it out.
#pragma once

#include "needs/words.h"
#include "viewer/debug_view.h"
#include "viewer/history.h"
#include "viewer/inspector.h"
#include "viewer/orbit.h"
#include "viewer/pace.h"
#include "viewer/picking.h"
#include "viewer/thumbnails.h"
#include "viewer/truth_run.h"
#include "viewer/view.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gg::viewer {

// How the truth is shown.
enum class Comparing { wipe, side_by_side, relative_error, flip };
inline constexpr const char* comparing_names[] = {"wipe", "side by side", "relative error", "FLIP"};

// Done at the end of the frame in which they are asked for.
struct Requests {
  bool camera = false, materials = false, light = false, quality = false; // changed
  bool pose = false; // the time of the animation has
  bool frame_all = false, frame_picked = false, reload = false, undo = false, redo = false,
       quit = false, full_screen = false;
  std::string open;           // a scene or an environment
  std::string copy;           // the line of this command
  std::string save_picture;   // .png, .exr, ...
  std::string save_materials; // a copy of the scene's file with them
};

struct Session {
  View view;
  std::shared_ptr<scene::Scene> scene;         // null until the first is loaded
  std::vector<scene::Material> file_materials; // with --material, without the edits
  std::shared_ptr<const environment::Map> map; // null: no environment
  scene::Camera camera;                        // that the view says
  std::optional<Picked> picked;
  bool edit_all = false; // all materials instead of the picked object's
  History history;
  std::string loading;                 // a file that is being read, and how far it is
  std::string message;                 // what went wrong, until it is closed
  std::string shader_message;          // the compiler's, until it has nothing to say
  std::string said;                    // what was done last, for the status line
  std::vector<std::string> recent;     // scenes, the last first
  std::vector<Thumbnail> environments; // that come with the program

  bool panel = true;
  bool entered =
      false; // Enter was pressed: Dear ImGui misses it where it is released within the same frame
  double frames_per_second = 30.0; // wanted while something moves
  bool turntable = false;
  bool playing = false;               // the animation runs
  bool moving = false;                // the picture is a quick one
  double compiled = 1.0;              // of what the picture is drawn with
  int drawn = 0;                      // samples of the picture
  double frame_ms = 0.0, scale = 1.0; // of the last quick picture
  std::string moving_method;          // that it was drawn by
  bool standard_in_motion = true;     // where the view's method is out of reach of half of the rate
  bool pass_table = false;
  std::map<std::string, double> pass_ms; // of the last sample, while the table is open
  // As `groundglass needs` says it; passes of one label together.
  struct PassRow {
    std::string label;
    std::size_t passes = 0, draws = 0, bytes = 0; // bytes: of what it writes
  };
  std::vector<PassRow> passes;
  std::vector<needs::FeatureUse> features;
  std::size_t device_bytes = 0;
  std::string device;

  bool truth = false;                     // something is shown beside the picture: the truth,
  std::string second;                     // or another method, if this is its name
  double first_ms = 0.0, second_ms = 0.0; // of one sample at full size
  Comparing comparing = Comparing::wipe;
  float wipe = 0.5f;               // where the second begins
  std::optional<glm::vec2> wiping; // where the drag began that moves it
  bool flicker = false;            // the key that shows it alone is held
  std::shared_ptr<const TruthRun::Report> report;

  DebugKind debug = DebugKind::picture;
  double debug_greatest = 0.0; // what the brightest colour of it stands for

  bool inspector = false;
  std::optional<glm::vec2> cursor; // where it was last over the picture, 0..1 from its top left
  std::optional<glm::vec2> inspected_at; // in the cursor's place, until that moves
  std::optional<Inspection> inspected;

  Requests requests;
};

// The edit of a material, made if there is none.
Edit& edit_of(View& view, scene::Index material);
// The materials of the scene as the file and the edits say. Throws Error(usage); the scene is then as it was.
void apply_edits(Session& session);
// The materials that the material panel changes.
std::vector<scene::Index> chosen_materials(const Session& session);

} // namespace gg::viewer
