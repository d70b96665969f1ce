// `murosimf view`: a scene in a window, to be watched, touched and understood.
#include <cstdlib>

#include <fmt/format.h>

#include "apps/command_line.h"
#include "apps/error_output.h"
#include "apps/interruption.h"
#include "apps/option_values.h"
#include "apps/repeat_arguments.h"
#include "apps/results.h"
#include "apps/roboviz_arguments.h"
#include "apps/scene_arguments.h"
#include "apps/standard_output.h"
#include "apps/view_recording.h"
#include "murosimf/drawing/debug_draw_source.h"
#include "murosimf/model/error.h"
#include "murosimf/recording/recorded_series.h"
#include "murosimf/recording/recorded_source.h"
#include "murosimf/session/live_source.h"
#include "murosimf/viewer/view_report.h"
#include "murosimf/viewer/window.h"

namespace murosimf::app {
namespace {

struct ViewOptions {
  SceneArguments scene;
  std::string speed = "1", size = "1280x720", keys, script, screenshot, json, roboviz;
  std::optional<double> after, duration;
  std::optional<std::int64_t> samples;
  RecordOptions record;
  bool paused = false, no_shadows = false, shadows = false;
};

void define(const Command& command, ViewOptions& options) {
  add_scene(command, options.scene,
            "Scene file (TOML), the name of one that comes with the program, or a recording (MCAP)");
  command.add("--speed", options.speed, "Simulated seconds per second, or 'max'").shows_default();
  command.add("--paused", options.paused, "Begin paused");
  command.add("--duration", options.duration, "Simulated seconds after which it pauses; without end if not given");
  command.add("--size", options.size, "WIDTHxHEIGHT of the window in pixels").shows_default();
  command.add("--keys", options.keys, "Which key does what (TOML; docs/viewer.md)");
  const Option none = command.add("--no-shadows", options.no_shadows, "Draw no shadows");
  command.add("--shadows", options.shadows, "Draw shadows also where that is slow").excludes(none);
  command.add("--samples", options.samples, "To a pixel, for smooth edges; 4 with a graphics card, else 1 if not given")
      .within(1, 8);
  const Option script = command.add("--script", options.script, "Do what this file says, then end (docs/viewer.md)");
  const Option after =
      command.add("--after", options.after, "End after so many seconds").within(0.0, 1e6).excludes(script);
  command.add("--screenshot", options.screenshot, "PNG file of the window, at the end").needs(after);
  add_record(command, options.record);
  add_roboviz(command, options.roboviz);
  add_json(command, options.json);
}

viewer::WindowOptions window_options(const ViewOptions& options) {
  viewer::WindowOptions window{.title = "MuRoSimF: " + options.scene.file, .stop = interrupted};
  const PictureSize size = read_size(options.size);
  window.width = size.width;
  window.height = size.height;
  if (!options.keys.empty()) window.keys = viewer::KeyMap(options.keys);
  if (!options.script.empty()) window.script = viewer::read_script(options.script);
  window.screenshot = options.screenshot;
  window.after = options.after;
  if (options.samples && (*options.samples & (*options.samples - 1)) != 0) {
    throw SetupError(fmt::format("--samples {}: must be 1, 2, 4 or 8", *options.samples));
  }
  if (options.samples) window.samples = static_cast<int>(*options.samples);
  if (options.shadows || options.no_shadows) window.shadows = options.shadows;
  return window;
}

/// A scene that runs, or a recording that is played, with what other programs drew then; `end`: of it. `recording`: null if nothing is
/// recorded.
session::MakeSource source_of(const SceneArguments& scene, ViewRecording* recording, Duration& end,
                              const std::shared_ptr<drawing::DebugDrawBuffer>& others) {
  if (!recording::is_recording(scene.file)) {
    scene::SceneOptions options = options_of(scene);
    options.pushable = true;
    if (recording) return [recording, options] { return recording->make_source(options); };
    return [file = scene.file, options] {
      return std::make_unique<session::LiveSource>(std::make_unique<scene::Scene>(file, options));
    };
  }
  if (recording) throw SetupError("--record: this is a recording already");
  refuse_changes(scene);
  const auto run = recorded_run_of(scene.file, repeat_arguments(scene));
  end = std::min(end, run->end());
  return [run, repeat = options_of(repeat_arguments(scene)), others] {
    return std::make_unique<recording::RecordedSource>(run, repeat, others);
  };
}

/// Mesa tells of each driver that it tries in vain, in lines that look like ours, also where the next one draws. A user who wants to read them
/// sets these variables otherwise.
void quiet_drivers() {
  constexpr int unless_set = 0;
  setenv("MESA_LOG", "null", unless_set);
  setenv("EGL_LOG_LEVEL", "fatal", unless_set);
}

int view(const ViewOptions& options) {
  end_gently();
  quiet_drivers();
  check_json_file(options.json);
  if (!options.screenshot.empty()) claim_picture("--screenshot", options.screenshot);
  const viewer::WindowOptions window = window_options(options);
  viewer::ViewerOptions viewer_options;
  viewer_options.session.speed = read_speed(options.speed);
  if (options.duration) viewer_options.end = read_duration(*options.duration);
  if (const std::string reason = viewer::no_window_because(); !reason.empty()) throw SetupError(reason);
  const auto roboviz = roboviz_server(options.roboviz);
  const auto drawn_then = std::make_shared<drawing::DebugDrawBuffer>();
  std::optional<ViewRecording> recording;
  if (!options.record.file.empty()) recording.emplace(options.scene, options.record, roboviz.get());
  viewer_options.make_source =
      source_of(options.scene, recording ? &*recording : nullptr, viewer_options.end, drawn_then);
  if (recording) viewer_options.session.no_way_back = ViewRecording::no_way_back();
  if (is_asked_for(options.record)) viewer_options.session.record = [&](bool on) { recording->record(on); };
  viewer_options.session.paused = options.paused;
  viewer_options.others = roboviz ? static_cast<const drawing::DebugDrawSource*>(roboviz.get()) : drawn_then.get();
  viewer::Viewer viewer(viewer_options);
  const viewer::WindowReport shown = show(viewer, window);
  viewer.settle();
  viewer.running().finish();
  const bool recorded = !recording || recording->finish();
  write_result(options.json, to_text(viewer, shown),
               options.json.empty() ? "" : to_json(viewer, shown, packets_of(roboviz.get())));
  return recorded ? exit_code() : user_error;
}

}  // namespace

void add_view(CommandLine& line) {
  line.add<ViewOptions>("view", "Show a scene in a window, where it can be touched, or a recording", define, view);
}

}  // namespace murosimf::app
