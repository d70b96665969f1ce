// `murosimf new-name`: what moves in a scene, at which level, and how many joints it has.
#include <fmt/format.h>

#include "apps/command_line.h"
#include "apps/standard_output.h"
#include "murosimf/scene/scene.h"

namespace murosimf::app {
namespace {

struct NewNameOptions {
  std::string scene;  ///< file, or the name of one that comes with the program
};

// What begins with "--" is an option, other names are arguments (apps/command.h).
void define(const Command& command, NewNameOptions& options) {
  command.add("scene", options.scene, "Scene (TOML), or the name of one that comes with the program")
      .required()
      .offers_list("scenes");
}

/// Returns the exit code. Errors of the user are SetupErrors, which the program prints in one line.
int show(const NewNameOptions& options) {
  const scene::Scene whole(options.scene);
  std::string text;
  for (const Entity* entity : whole.moving_entities()) {
    const std::size_t joints = entity->model().joints().size();
    text += fmt::format("{:<20} {:<22} {:>3} joints\n", entity->name(), entity->level, joints);
  }
  write_standard_output(text);
  return 0;
}

}  // namespace

void add_new_name(CommandLine& line) {
  // its place in --help is that in the list of main.cpp
  line.add<NewNameOptions>("new-name", "Name what moves in a scene", define, show);
}

}  // namespace murosimf::app
