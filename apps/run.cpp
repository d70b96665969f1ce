// `murosimf run`: builds a scene, runs it, reports.
#include <algorithm>

#include <fmt/format.h>

#include "apps/command_line.h"
#include "apps/interruption.h"
#include "apps/last_words.h"
#include "apps/option_values.h"
#include "apps/roboviz_arguments.h"
#include "apps/run_advance.h"
#include "apps/run_options.h"
#include "apps/run_outputs.h"
#include "murosimf/league/league.h"
#include "murosimf/recording/state_file.h"
#include "murosimf/scene/scene.h"
#include "murosimf/scene/scene_report.h"

namespace murosimf::app {
namespace {

/// Serial lines need a place where programs find them, and a place needs lines.
void check_serial(const scene_file::SceneSpec& spec, const std::string& folder) {
  const auto found = std::ranges::find(spec.robots, "serial", &scene_file::RobotSpec::controller);
  if (folder.empty() && found != spec.robots.end()) {
    throw SetupError(
        fmt::format("{}: {} has a serial line; say where programs find it: --serial DIR", found->where, found->name));
  }
  if (!folder.empty() && found == spec.robots.end()) {
    throw SetupError("--serial: no robot has a serial line (controller = \"serial\")");
  }
}

std::string why_stopped(const RunAdvance& advance) {
  if (advance.crashed()) return "a crash";
  return interrupted() ? signal_name() : "a supervisor";
}

int run(const RunOptions& options) {
  end_gently();
  check(options);
  RunOutputs outputs(options);
  const scene::SceneOptions scene_options = scene_options_of(options);
  scene::Scene scene(options.scene.file, scene_options);
  check_serial(scene.spec(), options.serial);
  const double asked = options.duration.value_or(scene.spec().duration);
  const Duration end = read_duration(asked);
  const std::unique_ptr<league::League> game = game_of(scene, options.game);
  const std::unique_ptr<connect::RobovizDoor> roboviz = roboviz_door(options.roboviz);
  outputs.attach(scene, scene_options, game.get(), roboviz.get());
  scene.simulation().initialize();
  outputs.scene_is_read();
  if (!options.from.empty()) recording::load_state(scene, options.from);
  outputs.begin();

  RunAdvance advance(scene, options, outputs, game.get(), roboviz.get(), end);
  advance.run();
  scene::RunReport report = make_report(scene, advance.wall(), advance.lateness());
  report.drawings = packets_of(roboviz.get());
  if (scene.simulation().now() < end) report.stopped = {why_stopped(advance), asked};
  const RunOutputs::Written written = outputs.write(report);
  if (advance.crashed()) return unexpected;
  if (!written.recording) return users_mistake;
  if (report.stopped) return exit_code();
  return written.states ? 0 : users_mistake;
}

}  // namespace

void add_run(CommandLine& line) { line.add<RunOptions>("run", "Run a scene and say what happened", define_run, run); }

}  // namespace murosimf::app
