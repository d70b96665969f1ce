// `murosimf compare`: which level of detail is adequate for an experiment.
#include <optional>

#include <fmt/format.h>

#include "apps/command_line.h"
#include "apps/error_output.h"
#include "apps/interruption.h"
#include "apps/progress.h"
#include "apps/results.h"
#include "apps/scene_arguments.h"
#include "apps/standard_output.h"
#include "murosimf/recording/state_file.h"
#include "murosimf/studies/compare_report.h"
#include "murosimf/studies/compare_seeds.h"

namespace murosimf::app {
namespace {

struct CompareArguments {
  studies::CompareOptions options;
  std::vector<std::string> thresholds;  ///< NAME=VALUE
  std::string json;                     ///< file, "-" for standard output
  std::string plots;                    ///< folder for PNG files
  int seeds = 1;
  double servo_tolerance = 0;  ///< [%]
  bool details = false;        ///< tables, too
  std::string from;            ///< file with a state; empty: the scene's beginning
  std::vector<std::string> plugins;
};

void define(const Command& command, CompareArguments& arguments) {
  studies::CompareOptions& options = arguments.options;
  add_scene_file(command, options.scene);
  command.add("--entity", options.entity, "The robot whose level changes").required();
  command.add("--levels", options.levels, "Levels, separated by commas; all if not given").separated_by(',');
  command.add("--contacts", options.contacts, "Contact laws, separated by commas; the scene's if not given")
      .separated_by(',');
  command.add("--set", options.overrides, "PATH=VALUE: change the scene, for example 'field.surface=grass'")
      .one_at_a_time();
  command.add("--duration", options.end, "Simulated time at which runs end, in seconds, instead of the scene's");
  command.add("--from", arguments.from, "Begin from a state of this scene: of 'run --save-at', or a recording");
  add_seed(command, options.seed);
  command.add("--seeds", arguments.seeds, "How many seeds, from the seed on: with what share is a level adequate?")
      .within(1, 10000)
      .shows_default();
  command
      .add("--servo-tolerance", arguments.servo_tolerance,
           "Percent by which gains of the robot's servos are off at most, by seed")
      .within(0, 90)
      .shows_default();
  command.add("--repeat", options.repeat, "Timed runs per level; their median counts").within(1, 1000).shows_default();
  command.add("--threshold", arguments.thresholds, "NAME=VALUE: what still counts as the same").one_at_a_time();
  command
      .add("--outcome", options.outcomes,
           "NAME.QUANTITY or NAME.QUANTITY=TOLERANCE: what alone decides, for example 'ball.end=0.3'")
      .one_at_a_time();
  command.add("--details", arguments.details, "Print tables: what happened at each level, and how far it is off");
  add_json(command, arguments.json);
  command.add("--plots", arguments.plots, "Write PNG plots to this folder");
  add_lenient(command, options.lenient);
  add_plugins(command, arguments.plugins);
}

int compare(const CompareArguments& arguments) {
  studies::Thresholds thresholds;
  for (const std::string& text : arguments.thresholds) thresholds.set(text);
  // where results go is checked before anything is computed, so that no result is lost
  check_json_file(arguments.json);
  if (!arguments.plots.empty()) studies::check_plots(arguments.plots);
  load_plugins(arguments.plugins);

  end_gently();
  std::optional<Progress> progress(std::in_place);
  studies::CompareOptions options = arguments.options;
  options.progress = [&](double share, const std::string& what) { progress->show(share, what); };
  options.stop = interrupted;
  options.servo_tolerance = arguments.servo_tolerance / 100;
  if (!arguments.from.empty()) {
    options.go_to_start = [&](scene::Scene& scene) { recording::load_state(scene, arguments.from); };
  }
  const bool several = arguments.seeds > 1 || options.servo_tolerance > 0;
  const studies::SeedsComparison result = studies::compare_seeds(options, arguments.seeds, thresholds);
  const studies::Comparison& comparison = result.first;
  progress.reset();
  if (result.stopped) say_error(fmt::format("stopped by {}; what had not ended is missing", signal_name()));
  std::string text = several ? studies::summary(result) : studies::summary(comparison, result.of_first);
  if (arguments.details) text += studies::details(comparison, result.of_first);
  Results results;
  results.write([&] {
    write_result(arguments.json, text,
                 several ? studies::to_json(result, thresholds)
                         : studies::to_json(comparison, result.of_first, thresholds));
  });
  if (!arguments.plots.empty() && !comparison.stopped) {
    results.write([&] { studies::write_plots(comparison, arguments.plots); });
  }
  return results.exit_code(result.stopped ? exit_code() : 0);
}

}  // namespace

void add_compare(CommandLine& line) {
  line.add<CompareArguments>("compare", "Run a scene at several levels and say which is adequate", define, compare);
}

}  // namespace murosimf::app
