/// scene_parts.h - what a scene consists of once it is built: plain data that the functions of this folder share.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/connect/crash_note.h"
#include "murosimf/files/allowed_files.h"
#include "murosimf/runtime/external_input_log.h"
#include "murosimf/runtime/path_recorder.h"
#include "murosimf/runtime/simulation.h"
#include "murosimf/scene/diagnostics.h"
#include "murosimf/scene/scene_cameras.h"
#include "murosimf/scene_file/scene_spec.h"
#include "murosimf/sensors/sensor.h"

namespace murosimf::collision {
class GroundContact;
class MultirateStepping;
}  // namespace murosimf::collision
namespace murosimf::connect {
class MessageExchange;
class TcpServer;
}  // namespace murosimf::connect
namespace murosimf::motion {
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

/// Light and ball as they are now (section_changes.h).
struct ChangingSections {
  scene_file::LightSpec light;
  scene_file::BallOptions ball;  ///< the usual ones, if there is no ball
  Color ball_color;
  void state(StateArchive& archive) { archive(light, ball, ball_color); }
};

/// What a reset goes back to.
struct StartOfScene {
  ChangingSections sections;
  std::vector<Algorithms> algorithms;      ///< by moving entity
  std::optional<Diagnostics> diagnostics;  ///< of building
};

/// Stays where it is: the simulation calls back into it.
struct SceneParts {
  SceneParts(scene_file::SceneSpec what, int threads);
  ~SceneParts();
  SceneParts(const SceneParts&) = delete;
  SceneParts& operator=(const SceneParts&) = delete;

  scene_file::SceneSpec spec;  ///< what the file says, with the levels and laws of now
  std::unique_ptr<Simulation> simulation;
  Diagnostics diagnostics;
  std::map<std::string, int> times_set;  ///< how often each property was, by its path
  Entity* field = nullptr;
  Entity* ball = nullptr;
  std::vector<Entity*> robots;                               ///< in the order of the spec
  std::vector<std::vector<const sensors::Sensor*>> sensors;  ///< by robot
  std::vector<Entity*> bodies;                               ///< those of [[bodies]] that move
  std::vector<Entity*> moving_entities;                      ///< robots, ball and bodies
  std::vector<collision::GroundContact*> ground_contacts;    ///< by moving entity
  std::map<const Entity*, motion::Push*> pushes;             ///< of those that can be pushed
  collision::MultirateStepping* step_multiple = nullptr;     ///< null: all make the scene's steps
  sensors::WorldQueries* queries = nullptr;                  ///< null: no sensor asks for them
  connect::MessageExchange* messages = nullptr;              ///< null: no software asks for them
  const PathRecorder* recorder = nullptr;                    ///< null: nobody asked for paths
  std::shared_ptr<connect::CrashNote> crashes = std::make_shared<connect::CrashNote>();  ///< of control software
  std::shared_ptr<connect::TcpServer> software;  ///< that of the controller "tcp" comes in there; null: nowhere
  std::string terminals;                         ///< folder for links to serial lines; empty: there are none
  ExternalInputOptions outside;                  ///< what is done with all that comes from outside
  bool libraries = false;                        ///< those that files name are loaded
  bool only_shown = false;                       ///< SceneOptions::only_shown
  std::shared_ptr<Assets> assets;                ///< for robots that come later
  bool lenient = false;                          ///< of their files: unknown elements are warnings
  StartOfScene at_start;
  /// SceneOptions::only_from
  std::shared_ptr<const files::AllowedFiles> only_from{};
  std::unique_ptr<CameraRenderer> cameras;  ///< null: nothing is drawn for them
  int changes_to_see = 0;  ///< so far, of what renderers have taken over: light, shapes, colors, who is there
};

/// Null if the entity is no body of [[bodies]].
[[nodiscard]] const scene_file::BodySpec* body_spec(const scene_file::SceneSpec& spec, const Entity& entity);

/// Throws SetupError with the nearest name if there is no such robot.
[[nodiscard]] scene_file::RobotSpec& robot_spec(scene_file::SceneSpec& spec, std::string_view robot);

}  // namespace murosimf::scene
