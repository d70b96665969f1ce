#include "apps/repeat_arguments.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/interruption.h"
#include "apps/scene_arguments.h"
#include "murosimf/model/error.h"

namespace murosimf::app {

void add_repeat(const Command& command, RepeatArguments& arguments) {
  command.add("--threads", arguments.threads, "Threads; results do not depend on their number")
      .within(1, 256)
      .shows_default();
  add_plugins(command, arguments.plugins);
  command.add("--libraries", arguments.libraries,
              "Load the control software that the run had (controller = \"library\"): it may do what it likes");
}

recording::RepeatOptions options_of(const RepeatArguments& arguments) {
  return {.threads = arguments.threads, .libraries = arguments.libraries, .stop = interrupted};
}

RepeatArguments repeat_arguments(const SceneArguments& arguments) {
  return {.threads = arguments.threads, .plugins = arguments.plugins, .libraries = arguments.libraries};
}

void refuse_changes(const SceneArguments& arguments) {
  const bool changes = arguments.seed || arguments.lenient || !arguments.overrides.empty() ||
                       !arguments.events.empty() || !arguments.pushes.empty();
  if (!changes) return;
  throw SetupError(fmt::format(
      "'{}' is a recording: what happened in it stays (--seed, --set, --at, --push, --lenient are for scenes)",
      arguments.file));
}

std::shared_ptr<const recording::RecordedRun> recorded_run_of(const std::string& file,
                                                              const RepeatArguments& arguments) {
  auto run = std::make_shared<const recording::RecordedRun>(file);
  check_plugins(*run, arguments);
  load_plugins(arguments.plugins);
  return run;
}

void check_plugins(const recording::RecordedRun& run, const RepeatArguments& arguments) {
  if (run.description().plugins.size() <= arguments.plugins.size()) return;
  throw SetupError(fmt::format("{}: this run had plug-ins ({}); name them again with --plugin: a recording loads none",
                               run.file().file().string(), fmt::join(run.description().plugins, ", ")));
}

}  // namespace murosimf::app
