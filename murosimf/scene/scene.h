/// scene.h - a scene file, built and ready to run.
///
///     scene::Scene scene("three_on_three");
///     scene.simulation().run(30s);
///     fmt::print("{}", to_text(make_report(scene, {})));  // scene_report.h
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "murosimf/scene/scene_options.h"
#include "murosimf/scene/scene_parts.h"

namespace murosimf::scene {

class Scene {
 public:
  /// `name`: a file, or the name of a scene that comes with the program. Throws SetupError.
  explicit Scene(const std::filesystem::path& name, const SceneOptions& options = {});
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
  /// Of all servos of a robot at articulated_dynamics; the others remember it.
  void exchange_servo_law(std::string_view robot, std::string_view law);

  /// The state of the simulation (Simulation::save), and at which levels and laws entities are.
  [[nodiscard]] std::vector<std::byte> save();
  /// Goes on from there, also in another process: in a scene of the same file and options. Throws SetupError and changes nothing if
  /// the state is of another one.
  void load(std::span<const std::byte> bytes);

  /// For what reports and draws (scene_report.h, scene_pictures.h).
  [[nodiscard]] SceneParts& parts() { return parts_; }
  [[nodiscard]] const SceneParts& parts() const { return parts_; }

 private:
  SceneParts parts_;
};

}  // namespace murosimf::scene
