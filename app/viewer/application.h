// The state of a running viewer and what carries out a frame of it.
#pragma once

#include "core/clock.h"
#include "core/error.h"
#include "environment/stack.h"
#include "viewer/display_pass.h"
#include "viewer/loading.h"
#include "viewer/pace.h"
#include "viewer/picture.h"
#include "viewer/session.h"
#include "viewer/shader_reload.h"
#include "viewer/sight.h"
#include "viewer/viewer.h"
#include "viewer/warmup.h"
#include "viewer/watched_files.h"

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <string>

namespace gg::viewer {

// The method that moves the camera where the session's is too slow.
inline const std::string standard_method = "standard";

class Application {
public:
  Application(const Settings& settings, const Commands& commands);
  ~Application();

  void loop(); // until the window is closed
  void bench();
  void screenshot();

private:
  // bench.cpp
  nlohmann::json bench_frames(int count, bool paced, const std::function<void(int)>& change);
  // loop.cpp
  void frame();
  void wait();
  bool is_busy() const;
  std::string loading_words() const;
  // opening.cpp
  void open(const std::string& path);
  void open_first();
  void take_loaded();
  void build_light();
  void fail(const Error& error); // within a catch
  void adopt(Loading::Done done);
  void adopt_pose(Loading::Done done);
  void play(double seconds);
  void pose();
  void remember(const std::string& scene);
  // requests.cpp
  void carry_out();
  void change_materials();
  void frame_picked();
  void copy(const std::string& command);
  void save_picture(const std::string& path);
  std::string words(const std::string& command, const std::string& output) const;
  // drawing.cpp
  void restart(bool quick);
  frame::FrameDesc frame_desc(double scale, int samples, const std::string& method) const;
  bool is_by_standard() const; // a quick picture is
  const std::string& quick_method() const;
  void forget_speed(); // another scene or method is to be drawn
  void attempt(const std::function<void()>& drawing);
  void draw();
  bool is_amid_quick() const;
  void draw_quick();
  void set_second();
  gpu::TextureRef compose();
  std::optional<Beside> beside();
  void run_truth();
  void take_truth();
  void take_shaders();
  Beside debug_view();
  void inspect();
  // work.cpp
  bool is_called(); // something has happened that a frame answers
  void see_events();
  bool is_moving() const;
  void work();
  void compile();
  void draw_still(Picture& picture, double& sample_ms);
  void plan_warmup();
  std::vector<Picture::Materials> materials_to_come() const;
  void warm_up();

  const Settings& settings_;
  const Commands& commands_;
  Thumbnails thumbnails_; // first: they are read while the window opens
  Session session_;
  std::unique_ptr<gpu::Window> window_;
  std::unique_ptr<Picture> picture_;
  std::unique_ptr<Warmup> warmup_;  // of it
  std::unique_ptr<Picture> second_; // by the other method, while that is shown
  std::string second_method_;       // that it was drawn by; empty: it is of another view
  std::unique_ptr<DisplayPass> display_;
  std::unique_ptr<DebugView> debug_; // of the scene, while one is shown
  std::unique_ptr<Sight> sight_;     // the same, of what is worked out along lines of sight
  gpu::TextureRef debug_shown_;      // null: it is to be drawn
  DebugKind debug_kind_ = DebugKind::picture;
  Loading loading_;
  std::optional<Loading::Done> lit_;                // what waits for its environment,
  std::unique_ptr<environment::Building> building_; // which is prefiltered, a step in each frame
  TruthRun truth_;
  struct Compiling { // what the still picture is drawn with, before its first
    bool begun = false, done = false;
    std::vector<gpu::PipelineDesc> left;
    std::size_t all = 0;
  };
  Compiling compiling_;
  Pace pace_, standard_pace_; // of the session's method; of `standard`
  WatchedFiles files_;
  ShaderReload shaders_;

  int width_ = 0, height_ = 0;            // of the picture on the screen, pixels
  bool stale_ = true;                     // the picture is of another view than the session's
  bool quick_ = false;                    // it is a quick one
  bool quick_is_first_ = false;           // the first of its scene
  double quick_ms_ = 0.0;                 // on the quick one that is being drawn
  bool camera_alone_ = false;             // nothing but the camera has changed last
  bool broken_ = false;                   // its shaders compile, and cannot be drawn with
  bool planned_ = false;                  // the warm-up has been, for this picture
  bool timing_asked_ = false;             // the picture is drawn again for the table of passes
  std::map<std::string, double> pass_ms_; // of the sample that is being drawn
  double sample_spent_ = 0.0;             // ms on the sample that is being drawn
  double window_ms_ = 0.0;                // what the last frame took besides a picture
  bool compared_ = false;                 // the truth has been given the finished picture
  std::optional<scene::Index> outlined_;  // what the display pass was told
  gpu::TextureRef beside_;                // of report_shown_
  std::shared_ptr<const TruthRun::Report> report_shown_;
  Comparing beside_kind_ = Comparing::wipe;
  bool posing_ = false;   // the time has changed since the last pose was asked for
  bool reloaded_ = false; // shaders have been, at least once
  Clock::time_point changed_ = Clock::now(), last_frame_ = Clock::now();
  std::uint64_t events_seen_ = 0;
  int settling_ = 3; // frames to be shown yet before the window may rest
};

} // namespace gg::viewer
