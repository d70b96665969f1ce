#include "apps/series_arguments.h"

#include <algorithm>
#include <thread>

#include "apps/standard_output.h"

namespace murosimf::app {

SeriesArguments::SeriesArguments() {
  scene.threads = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1U, 256U));
}

void add_series(const Command& command, SeriesArguments& arguments) {
  command.add("--duration", arguments.duration, "Simulated seconds of each run, instead of the scene's");
  command.add("--set", arguments.scene.overrides, "PATH=VALUE: change the scene of all runs").one_at_a_time();
  command
      .add("--threads", arguments.scene.threads, "Runs at a time; as many as the machine has processors if not given")
      .within(1, 256);
  add_no_cameras(command, arguments.no_cameras);
}

void add_series_end(const Command& command, SeriesArguments& arguments) {
  add_json(command, arguments.json);
  add_lenient(command, arguments.scene.lenient);
  add_plugins(command, arguments.scene.plugins);
  add_libraries(command, arguments.scene.libraries);
}

scene::SceneOptions options_of(const SeriesArguments& arguments) {
  scene::SceneOptions options = options_of(arguments.scene);
  options.cameras = !arguments.no_cameras;
  return options;
}

}  // namespace murosimf::app
