#include "apps/scene_arguments.h"

#include <limits>

#include <fmt/format.h>

#include "apps/interruption.h"
#include "murosimf/catalog/plugin.h"
#include "murosimf/files/xml_element.h"
#include "murosimf/model/error.h"

namespace murosimf::app {
namespace {

template <class Seed>
void add_any_seed(const Command& command, Seed& seed) {
  command.add("--seed", seed, "Seed of all random numbers, instead of the scene's")
      .within(std::int64_t{0}, std::numeric_limits<std::int64_t>::max());
}

}  // namespace

void add_scene(const Command& command, SceneArguments& scene, const char* meaning) {
  add_scene_file(command, scene.file, meaning);
  command.add("--threads", scene.threads, "Threads; results do not depend on their number")
      .within(1, 256)
      .shows_default();
  command.add("--no-lanes", scene.no_lanes,
              "Equal robots step one by one instead of together; the same results, later");
  add_seed(command, scene.seed);
  command.add("--set", scene.overrides, "PATH=VALUE: change the scene, for example 'blue.*.level=simplified_dynamics'")
      .one_at_a_time();
  command
      .add("--at", scene.events,
           "TIME:PATH=VALUE: change the scene while it runs, for example '3:blue1.level=articulated_dynamics'")
      .one_at_a_time();
  command
      .add("--push", scene.pushes,
           "OBJECT=FORCE@BEGIN..END: push a body, for example 'blue1.torso=[60,0,0]@2..2.1' (N, world axes, s)")
      .one_at_a_time();
  add_lenient(command, scene.lenient);
  add_plugins(command, scene.plugins);
  add_libraries(command, scene.libraries);
}

scene::SceneOptions options_of(const SceneArguments& scene) {
  load_plugins(scene.plugins);
  return {.threads = scene.threads,
          .seed = scene.seed,
          .overrides = scene.overrides,
          .events = scene.events,
          .pushes = scene.pushes,
          .libraries = scene.libraries,
          .lenient = scene.lenient,
          .lanes = !scene.no_lanes,
          .files = {.only_from = scene.only_from},
          .stop = interrupted};
}

void add_scene_file(const Command& command, std::string& file, const char* meaning) {
  command.add("scene", file, meaning).required().offers_list("scenes");
}

void add_seed(const Command& command, std::optional<std::int64_t>& seed) { add_any_seed(command, seed); }

void add_seed(const Command& command, std::optional<std::uint64_t>& seed) { add_any_seed(command, seed); }

void add_lenient(const Command& command, bool& lenient) {
  command.add("--lenient", lenient, "Accept unknown elements in model files, with a warning");
}

void add_no_cameras(const Command& command, bool& no_cameras) {
  command.add("--no-cameras", no_cameras, "Draw nothing for cameras: they have no frames then");
}

void add_libraries(const Command& command, bool& libraries) {
  command.add(
      "--libraries", libraries,
      "Load the control software that the scene file names (controller = \"library\"): it may do what it likes");
}

void add_body(const Command& command, std::string& body) {
  command.add("--body", body,
              "Of several robots in an MJCF file that with this body; 'world': all that is bolted to the world");
}

void add_xacro(const Command& command, std::vector<std::string>& arguments) {
  command.add("--xacro", arguments, "Argument of a robot file with macros (.xacro), name:=value; as often as needed");
}

std::map<std::string, std::string> xacro_values(const std::vector<std::string>& arguments) {
  std::map<std::string, std::string> values;
  for (const std::string& argument : arguments) {
    const std::size_t end = argument.find(":=");
    if (end == 0 || end == std::string::npos) {
      throw SetupError(files::one_line(fmt::format("--xacro '{}': write name:=value", argument)));
    }
    values[argument.substr(0, end)] = argument.substr(end + 2);
  }
  return values;
}

void add_plugins(const Command& command, std::vector<std::string>& plugins) {
  command.add("--plugin", plugins, "Load this shared library first: controllers, levels, laws and sensors of one's own")
      .one_at_a_time();
}

void load_plugins(const std::vector<std::string>& plugins) {
  for (const std::string& file : plugins) with_context("--plugin", [&] { catalog::load_plugin(file); });
}

}  // namespace murosimf::app
