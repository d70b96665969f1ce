/// algorithm_catalog.h - algorithms by the names that files and the command line use, and functions that attach them.
///
/// A new level or contact law is one more line in algorithm_catalog.cpp, a controller one in built_in_controllers.cpp; sensors
/// have sensor_types.h. A program or a plug-in (plugin.h) adds to `registries()`, before it builds a scene.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/catalog/command_type.h"
#include "murosimf/collision/contact_laws/body_contact_law.h"
#include "murosimf/collision/contact_laws/contact_law.h"
#include "murosimf/component_files/sensor_types.h"
#include "murosimf/control_software/control_link_options.h"
#include "murosimf/control_software/crash_note.h"
#include "murosimf/dynamics/moving_tree.h"
#include "murosimf/dynamics/simplified_dynamics.h"
#include "murosimf/locomotion/keyframe_motion.h"
#include "murosimf/model/find_entry.h"
#include "murosimf/model/option.h"
#include "murosimf/model/registry.h"
#include "murosimf/robot/robot_formats.h"
#include "murosimf/runtime/external_input_log.h"
#include "murosimf/runtime/simulation.h"

namespace murosimf::control_software {
class TcpServer;  // tcp_server.h
}

namespace murosimf::catalog {

/// Options of a level; all levels receive the same struct and use the members that apply to them.
struct LevelOptions {
  dynamics::JointReferenceOptions reference;
  bool base_rigid = false;           ///< simplified_dynamics: the paper's literal reading
  std::string servo_law;             ///< articulated_dynamics: overrides the law of all servos; empty: their own
  dynamics::MovingTreeOptions tree;  ///< full_dynamics, articulated_dynamics; its integrator: simplified_dynamics too
  const Entity* environment = nullptr;  ///< kinematic_walking: the ground that it walks on; null: the plane z = 0
  OptionValues own;                     ///< [robots.level_options] of the robot; those in LevelType::options apply
};

struct LevelType {
  std::string name, meaning;
  LevelTraits traits;
  std::string keys;  ///< keys of a robot that it uses, in addition to those of all levels: "contact fixed_base"
  std::string
      inputs;  ///< properties that can be set and have an effect at this level, in addition to those of all levels
  std::function<std::unique_ptr<MotionLevel>(Setup&, const LevelOptions&)> make;
  std::vector<OptionInfo> options{};  ///< of its own
};

/// Limits of the step [s] for levels without and with servos (docs/scenes.md).
struct LongestSteps {
  double without_servos, with_servos;
};
constexpr LongestSteps usual_steps{1 / usual_step_rate, 1 / usual_step_rate};

/// Law of contact with the ground.
struct ContactLawType {
  std::string name, meaning;
  std::function<std::shared_ptr<const collision::ContactLaw>(const OptionValues&)> make;
  LongestSteps longest_steps;         ///< limits with which a robot stands and walks
  std::vector<OptionInfo> options{};  ///< of its own
  /// Limits that depend on options; null: they do not.
  std::function<LongestSteps(const OptionValues&)> longest_steps_with{};
  LongestSteps accurate_steps = usual_steps;  ///< limits for accurate results; with default options
};

/// Limits with which a robot stands and walks under the law, with these options.
[[nodiscard]] LongestSteps stable_steps(const ContactLawType& law, const OptionValues& given);
/// Limits for accurate results: used for `rate = "auto"` (scene_file/automatic_rate.h).
[[nodiscard]] LongestSteps accurate_steps(const ContactLawType& law, const OptionValues& given);

/// Law between moving bodies.
struct BodyContactLawType {
  std::string name, meaning;
  std::function<std::unique_ptr<collision::BodyContactLaw>(const OptionValues&)> make;
  std::vector<OptionInfo> options{};           ///< of its own
  double accurate_step = 1 / usual_step_rate;  ///< [s] limit for accurate results
};

/// Properties of the scene and the robot that a controller may use.
struct ControllerOptions {
  std::vector<Entity*> moving_entities;  ///< robots and ball
  Vec3d half_field{3, 2, 0};             ///< [m] from the middle to the touch and goal lines
  double attacks = 1;                    ///< +1: the robot's team plays towards positive x, -1: the other way
  Vec3d command;                         ///< [m/s, m/s, rad/s] first walk_command
  std::optional<locomotion::KeyframeMotion> motion;
  Vec3d start;             ///< [m, m, rad] x, y and heading that the scene's file gives the robot, without its jitter
  Markings markings;       ///< of the field
  std::uint64_t seed = 1;  ///< of the scene
  double rate = 0;         ///< [Hz] of the controller; 0: its usual rate
  OptionValues own;        ///< [robots.options] of the robot, those in ControllerType::options
  std::string library;     ///< file, of the controller "library"
  double call_budget = 0;  ///< [s] of wall time for each of its calls; 0: any
  bool reload = false;     ///< reloads the library when its file changes
  control_software::ControlLinkOptions link{};            ///< between the robot and software outside of the program
  std::shared_ptr<control_software::CrashNote> crashes;   ///< null: crashes are not recorded
  std::shared_ptr<control_software::TcpServer> software;  ///< accepts the software of the controller "tcp"; null: none
  std::filesystem::path folder;         ///< folder of the scene's file, searched for files that it names
  std::filesystem::path terminals;      ///< folder for links to serial lines; empty: there are none
  std::optional<int> dds_domain{};      ///< of robots of Booster that name no other; nothing: there is no DDS
  std::optional<int> unitree_domain{};  ///< the same of robots of Unitree
  std::optional<int> ros2_domain{};     ///< of robots that nodes of ROS 2 command; nothing: none do
  ExternalInputOptions outside;         ///< recording and repetition of external input
};

struct ControllerType {
  std::string name, meaning;
  std::string keys;  ///< keys of a robot that it uses, in addition to those of all controllers: "command"
  std::function<void(Simulation&, Entity&, const ControllerOptions&)> attach;
  std::vector<OptionInfo> options{};  ///< of its own
  bool any_options = false;           ///< accepts options of any name
  /// [m/s, m/s, rad/s] Velocity that results from a command with these options; empty: it follows no command.
  std::function<Vec3d(const Model&, const OptionValues& options, const Vec3d& command)> attainable{};
};

/// All registries that plug-ins can extend.
struct Registries {
  Registry<LevelType>& levels;
  Registry<ContactLawType>& contacts;
  Registry<BodyContactLawType>& body_contacts;
  Registry<ControllerType>& controllers;
  Registry<component_files::SensorType>& sensors;
  Registry<robot::RobotFormat>& formats;
  Registry<CommandType>& commands;  ///< in addition to the program's own (apps/main.cpp)
};

/// True if `word` is among the words of a list in the catalog.
[[nodiscard]] bool has_word(std::string_view words, std::string_view word);

/// The registries of this program. Entries are permanent; add to them before building a scene that uses them.
[[nodiscard]] Registries& registries();

// Read-only access.
[[nodiscard]] const Registry<LevelType>& levels();
[[nodiscard]] const Registry<ContactLawType>& contacts();
[[nodiscard]] const Registry<BodyContactLawType>& body_contacts();
[[nodiscard]] const Registry<ControllerType>& controllers();

// Created with those of `given` that are their options: the others are for algorithms that may replace them later. Throw
// SetupError if there is none of that name.
[[nodiscard]] std::unique_ptr<MotionLevel> make_level(std::string_view name, Setup& setup, const LevelOptions& options);
[[nodiscard]] std::shared_ptr<const collision::ContactLaw> make_contact_law(std::string_view name,
                                                                            const OptionValues& given = {});
[[nodiscard]] std::unique_ptr<collision::BodyContactLaw> make_body_contact_law(std::string_view name,
                                                                               const OptionValues& given = {});

}  // namespace murosimf::catalog
