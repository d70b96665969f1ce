/// run_advance.h - runs a scene to its end, shows the progress, and takes pictures on the way.
#pragma once

#include <chrono>
#include <memory>

#include "apps/progress.h"
#include "apps/run_options.h"
#include "apps/run_outputs.h"
#include "apps/steering.h"
#include "murosimf/drawing/debug_draw_source.h"
#include "murosimf/runtime/clock.h"

namespace murosimf::app {

class RunAdvance {
 public:
  /// What takes part besides; null: it does not.
  struct Others {
    const league::League* game = nullptr;               ///< a referee
    const drawing::DebugDrawSource* drawing = nullptr;  ///< other programs that draw
    Ros2* ros2 = nullptr;
  };
  RunAdvance(scene::Scene& scene, const RunOptions& options, RunOutputs& outputs, const Others& others, Duration end);

  /// Until the end, a signal, or a supervisor. Control software that crashes ends it, too.
  void run(Steering& steering);

  [[nodiscard]] bool crashed() const { return crashed_; }
  /// Since one could not be written.
  [[nodiscard]] bool lacks_pictures() const { return lacks_pictures_; }
  /// [wall] without that for pictures.
  [[nodiscard]] Duration wall() const { return wall_; }
  [[nodiscard]] const Lateness& lateness() const { return lateness_; }

 private:
  using WallClock = std::chrono::steady_clock;

  void show(Duration now);
  void warn(Duration now, const std::string& text);
  void run_alone();
  void run_steered(Steering& steering);
  void take(PictureSequence& pictures);
  void advance_to(Duration time, Clock& clock);

  scene::Scene& scene_;
  const RunOptions& options_;
  RunOutputs& outputs_;
  Others others_;
  Duration start_, end_;
  WallClock::time_point wall_start_ = WallClock::now();
  Progress line_;
  bool told_of_trouble_ = false, crashed_ = false, lacks_pictures_ = false;
  Duration wall_{};
  Lateness lateness_;
};

}  // namespace murosimf::app
