// `murosimf run`: builds a scene, runs it, reports.
#include <fmt/format.h>

#include "apps/command_line.h"
#include "apps/error_output.h"
#include "apps/interruption.h"
#include "apps/option_values.h"
#include "apps/roboviz_arguments.h"
#include "apps/ros2_arguments.h"
#include "apps/run_advance.h"
#include "apps/run_options.h"
#include "apps/run_outputs.h"
#include "apps/steering.h"
#include "murosimf/league/league.h"
#include "murosimf/recording/state_file.h"
#include "murosimf/scene/scene.h"
#include "murosimf/scene/scene_python.h"
#include "murosimf/scene/scene_report.h"
#include "murosimf/session/own_state.h"

namespace murosimf::app {
namespace {

std::string why_stopped(const RunAdvance& advance) {
  if (advance.crashed()) return "a crash";
  return interrupted() ? signal_name() : "a supervisor";
}

void go_on_from(scene::Scene& scene, const std::string& file) {
  recording::load_state(scene, file);
  const std::string owners = session::own_state(scene.simulation().world(), scene.parts().outside.memory.get());
  if (!owners.empty()) scene.parts().diagnostics.note(fmt::format("{}: nothing of it is in {}", owners, file));
}

int run_scene(const RunOptions& options, Steering& steering) {
  RunOutputs outputs(options);
  const scene::SceneOptions scene_options = scene_options_of(options);
  scene::Scene scene(options.scene.file, scene_options);
  check_serial(scene.spec(), options.serial);
  check_vendors(scene.spec(), options);
  const double asked = options.duration.value_or(scene.spec().duration);
  const Duration end = read_duration(asked);
  const std::unique_ptr<league::League> game = game_of(scene, options.game);
  const std::unique_ptr<drawing::RobovizServer> roboviz = roboviz_server(options.roboviz);
  outputs.attach(scene, scene_options, game.get(), roboviz.get());
  const std::unique_ptr<Ros2> ros2 = join_ros2(scene, options.ros2);
  scene.simulation().initialize();
  outputs.scene_is_read();
  if (!options.from.empty()) go_on_from(scene, options.from);
  outputs.begin();

  RunAdvance advance(scene, options, outputs, {game.get(), roboviz.get(), ros2.get()}, end);
  advance.run(steering);
  if (steering.goes_on()) return 0;
  scene::RunReport report = make_report(scene, advance.wall(), advance.lateness());
  report.drawings = packets_of(roboviz.get());
  const std::string ended = scene::end_of_run(scene.parts());
  if (!ended.empty()) {
    report.stopped = {ended, asked};
  } else if (scene.simulation().now() < end) {
    report.stopped = {why_stopped(advance), asked};
  }
  const RunOutputs::Written written = outputs.write(report);
  if (advance.crashed()) return unexpected;
  if (!written.recording || !written.files || advance.lacks_pictures()) return user_error;
  if (report.stopped && ended.empty()) return exit_code();
  return written.states ? 0 : user_error;
}

/// One scene after the other, if supervisors want others.
int run(const RunOptions& options) {
  end_gently();
  check(options);
  Steering steering(options);
  int code = run_scene(options, steering);
  while (steering.goes_on()) {
    const RunOptions next = steering.take_next();
    code = run_scene(next, steering);
  }
  return code;
}

}  // namespace

void add_run(CommandLine& line) { line.add<RunOptions>("run", "Run a scene and say what happened", define_run, run); }

}  // namespace murosimf::app
