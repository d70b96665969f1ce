/// scene.h - a scene file, built and ready to run.
///
///     scene::Scene scene("three_on_three");
///     scene.simulation().run(30s);
///     fmt::print("{}", to_text(make_report(scene, {})));  // scene_report.h
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <future>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/scene/scene_options.h"
#include "murosimf/scene/scene_parts.h"

namespace murosimf::scene {

class Scene {
 public:
  /// `name`: a file, or the name of a scene that comes with the program. Throws SetupError.
  explicit Scene(const std::filesystem::path& name, const SceneOptions& options = {});
  /// From a spec that a program has built or read before (scene_file/scene_spec.h); of the options, overrides, events and pushes
  /// concern files only. Throws SetupError.
  explicit Scene(scene_file::SceneSpec spec, const SceneOptions& options = {});
  Scene(const Scene&) = delete;  // the simulation calls back into its parts
  Scene& operator=(const Scene&) = delete;

  [[nodiscard]] const scene_file::SceneSpec& spec() const { return parts_.spec; }
  [[nodiscard]] Simulation& simulation() { return *parts_.simulation; }
  [[nodiscard]] const Simulation& simulation() const { return *parts_.simulation; }
  /// Robots, ball and bodies, in the order of sensors' labels.
  [[nodiscard]] const std::vector<Entity*>& moving_entities() const { return parts_.moving_entities; }

  // Changes of a robot (of the contact: also of ball and bodies) between two steps. They are events of the report. All
  // throw SetupError, and change nothing, for unknown names and if the robot cannot change as it is now.
  void exchange_level(std::string_view robot, std::string_view level);
  void exchange_contact(std::string_view entity, std::string_view law);
  /// For all servos of a robot at articulated_dynamics; other levels store it.
  void exchange_servo_law(std::string_view robot, std::string_view law);

  // Robots, ball and bodies leave between two steps, and return in their initial state (scene_presence.h); they may also be absent at
  // the start (`present = false`). Throw SetupError, and change nothing, for unknown names, and if there is nothing to change.
  void enter(std::string_view entity);
  void leave(std::string_view entity);

  // Adds a robot or moving body between two steps, as if it were the last entry of the file: with its sensors, controller and
  // level. Existing sensors see it by rays and in pictures; the outputs of detectors and ground truth are those
  // of the start. Initializes. A reset then includes it, and earlier states no longer fit. Throw SetupError, and change
  // nothing, for what a file could not contain either. The address of the entity is stable.
  Entity& add(scene_file::RobotSpec robot);
  Entity& add(scene_file::BodySpec body);

  /// From any thread: changes a level, law, command, property or presence at the beginning of the next step, by PATH = VALUE as in the scene's
  /// events ("blue1.level = full_dynamics"). The future becomes ready when it is done, and throws SetupError if it fails. Completed changes
  /// are listed in simulation().commands(), with which events_of_commands() repeats the run.
  std::future<void> post(std::string change);

  /// The same at once, between two steps, by the thread that runs it: all of them in order, or, if one is invalid or
  /// fails, none. Throws SetupError then, and the scene is unchanged.
  void change(const std::vector<std::string>& changes);

  /// Returns to the beginning without rebuilding: the same run, readings included, as of a new scene with these options and,
  /// if given, this seed. Throws SetupError if the scene cannot start.
  void reset(std::optional<std::uint64_t> seed = {});

  /// The state of the simulation (Simulation::save), and at which levels and laws entities are.
  [[nodiscard]] std::vector<std::byte> save();
  /// Continues from such a state, also in another process: in a scene of the same file and options. Throws SetupError and changes nothing if
  /// the state belongs to another one.
  void load(std::span<const std::byte> bytes);

  /// For reports and pictures (scene_report.h, scene_pictures.h).
  [[nodiscard]] SceneParts& parts() { return parts_; }
  [[nodiscard]] const SceneParts& parts() const { return parts_; }

 private:
  SceneParts parts_;
};

/// The commands of a run as SceneOptions::events of a run that repeats it.
[[nodiscard]] std::vector<std::string> events_of_commands(const std::vector<Command>& commands);

}  // namespace murosimf::scene
