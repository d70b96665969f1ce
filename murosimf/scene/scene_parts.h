/// scene_parts.h - the contents of a built scene: plain data shared by the functions of this folder.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "murosimf/control_software/crash_note.h"
#include "murosimf/files/file_access.h"
#include "murosimf/runtime/external_input_log.h"
#include "murosimf/runtime/path_recorder.h"
#include "murosimf/runtime/simulation.h"
#include "murosimf/scene/diagnostics.h"
#include "murosimf/scene/scene_cameras.h"
#include "murosimf/scene_file/scene_spec.h"
#include "murosimf/sensors/sensor.h"

namespace murosimf::collision {
class BodyContact;
class GroundContact;
class MultirateStepping;
}  // namespace murosimf::collision
namespace murosimf::control_software {
class MessageExchange;
class PythonAlgorithm;
class TcpServer;
}  // namespace murosimf::control_software
namespace murosimf::dynamics {
class Push;
}
namespace murosimf::sensors {
class WorldQueries;
}

namespace murosimf::scene {

class Assets;  // assets.h

/// Levels and laws of a robot, or the law of ball and bodies.
struct Algorithms {
  std::string level, servo_law;  ///< empty: no robot
  std::string contact;
  friend bool operator==(const Algorithms&, const Algorithms&) = default;
  void state(StateArchive& archive) { archive(level, servo_law, contact); }
};

/// Present light and ball (section_changes.h).
struct ChangingSections {
  scene_file::LightSpec light;
  scene_file::BallOptions ball;  ///< defaults, if there is no ball
  Color ball_color;
  void state(StateArchive& archive) { archive(light, ball, ball_color); }
};

/// A constant of an entity's model that was changed while the scene runs.
struct ConstantChange {
  std::string entity, object, property;
  std::vector<double> numbers;
  friend bool operator==(const ConstantChange&, const ConstantChange&) = default;
  void state(StateArchive& archive) { archive(entity, object, property, numbers); }
};

/// Changes in force of what the scene was built with (constant_changes.h).
struct ChangedConstants {
  std::vector<ConstantChange> models;
  std::vector<std::string> surfaces;  ///< "materials.rubber.friction=0.3", "field.friction=0.5"
  friend bool operator==(const ChangedConstants&, const ChangedConstants&) = default;
  void state(StateArchive& archive) { archive(models, surfaces); }
};

/// A robot or body that was added to the built scene (scene_addition.h).
struct Addition {
  Duration time{};  ///< a reset begins with it
  std::variant<scene_file::RobotSpec, scene_file::BodySpec> what;
};

/// State restored by a reset.
struct StartOfScene {
  ChangingSections sections;
  std::vector<Algorithms> algorithms;      ///< by moving entity
  std::optional<Diagnostics> diagnostics;  ///< of building
};

/// Has a stable address: the simulation calls back into it.
struct SceneParts {
  SceneParts(scene_file::SceneSpec what, int threads);
  ~SceneParts();
  SceneParts(const SceneParts&) = delete;
  SceneParts& operator=(const SceneParts&) = delete;

  scene_file::SceneSpec spec;  ///< contents of the file, with the present levels and laws
  std::unique_ptr<Simulation> simulation;
  Diagnostics diagnostics;
  std::map<std::string, int> times_set;  ///< how often each property was set, by its path
  Entity* field = nullptr;
  Entity* ball = nullptr;
  std::vector<Entity*> robots;                               ///< in the order of the spec
  std::vector<std::vector<const sensors::Sensor*>> sensors;  ///< by robot
  std::vector<Entity*> bodies;                               ///< moving ones of [[bodies]]
  std::vector<Entity*> moving_entities;                      ///< robots, ball and bodies
  std::vector<collision::GroundContact*> ground_contacts;    ///< by moving entity
  std::map<const Entity*, dynamics::Push*> pushes;           ///< of entities that can be pushed
  collision::BodyContact* body_contact = nullptr;
  ChangedConstants constants;
  std::map<const Entity*, ModelPtr> built_models;                    ///< of entities whose constants were changed
  std::optional<MaterialTable> built_materials;                      ///< if they were changed
  collision::MultirateStepping* multirate_stepping = nullptr;        ///< null: all use the scene's step
  sensors::WorldQueries* queries = nullptr;                          ///< null: no sensor uses them
  control_software::MessageExchange* messages = nullptr;             ///< null: no software uses them
  std::vector<const control_software::PythonAlgorithm*> algorithms;  ///< classes of the scene file
  const PathRecorder* recorder = nullptr;                            ///< null: paths are not recorded
  std::shared_ptr<control_software::CrashNote> crashes =
      std::make_shared<control_software::CrashNote>();    ///< of control software
  std::shared_ptr<control_software::TcpServer> software;  ///< accepts that of the controller "tcp"; null: none
  std::string terminals;                                  ///< folder for links to serial lines; empty: there are none
  std::optional<int> dds_domain{};                        ///< for robots of Booster; nothing: they have no DDS
  std::optional<int> unitree_domain{};                    ///< the same for robots of Unitree
  std::optional<int> ros2_domain{};                       ///< for robots that nodes of ROS 2 command; nothing: none do
  ExternalInputOptions outside;                           ///< recording and repetition of external input
  bool libraries = false;                                 ///< whether libraries named by files are loaded
  bool only_shown = false;                                ///< SceneOptions::only_shown
  std::shared_ptr<Assets> assets;                         ///< for robots added later
  bool lenient = false;                                   ///< of their files: unknown elements are warnings
  StartOfScene at_start;
  files::FileAccess files{};        ///< SceneOptions::files, for robots that come later
  std::vector<Addition> additions;  ///< in their order
  /// What additions have been read from, also by readers that look at their files before.
  std::shared_ptr<files::FilesRead> files_of_additions = std::make_shared<files::FilesRead>();
  std::unique_ptr<CameraRenderer> cameras;  ///< null: nothing is drawn for them
  int changes_to_see = 0;  ///< so far, of what renderers have taken over: light, shapes, colors, presence
};

/// Null if the entity is no body of [[bodies]].
[[nodiscard]] const scene_file::BodySpec* body_spec(const scene_file::SceneSpec& spec, const Entity& entity);

/// Throws SetupError with the nearest name if there is no such robot.
[[nodiscard]] scene_file::RobotSpec& robot_spec(scene_file::SceneSpec& spec, std::string_view robot);

}  // namespace murosimf::scene
