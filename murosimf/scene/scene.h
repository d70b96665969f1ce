/// scene.h - a scene file, built and ready to run.
///
///     scene::Scene scene("three_on_three");
///     scene.simulation().run(30s);
///     fmt::print("{}", scene::to_text(scene.report()));
#pragma once

#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "murosimf/collision/ground_contact.h"
#include "murosimf/math/random.h"
#include "murosimf/runtime/path_recorder.h"
#include "murosimf/runtime/simulation.h"
#include "murosimf/scene/run_report.h"
#include "murosimf/scene/scene_spec.h"
#include "murosimf/sensors/sensor.h"

namespace murosimf::render {
class Renderer;
}

namespace murosimf::scene {

struct SceneOptions {
  int threads = 1;
  std::optional<std::uint64_t> seed;   ///< instead of the scene's
  std::vector<std::string> overrides;  ///< PATH=VALUE, as for --set
  std::vector<std::string> events;     ///< TIME:PATH=VALUE, as for --at
  std::vector<std::string> pushes;     ///< `OBJECT=FORCE@BEGIN..END`, as for --push
  bool lenient = false;                ///< accept unknown elements in model files
  bool cameras = true;                 ///< false: nothing is drawn for cameras; they have no frames
  bool paths = false;                  ///< remember where everybody has been, for write_picture
  StopRequest stop{};                  ///< ends runs of the simulation early (Simulation::stop_if)
};

class Scene {
 public:
  /// `name`: a file, or the name of a scene that comes with the program. Throws SetupError.
  explicit Scene(const std::filesystem::path& name, const SceneOptions& options = {});
  ~Scene();
  Scene(const Scene&) = delete;  // the simulation calls back into the scene
  Scene& operator=(const Scene&) = delete;

  [[nodiscard]] const SceneSpec& spec() const { return spec_; }
  [[nodiscard]] Simulation& simulation() { return *simulation_; }
  [[nodiscard]] const Simulation& simulation() const { return *simulation_; }

  // Changes of a robot (of the contact: also of the ball) between two steps. They are events of the report. All throw
  // SetupError, and change nothing, for unknown names and if the robot cannot change as it is now.
  void exchange_level(std::string_view robot, std::string_view level);
  void exchange_contact(std::string_view entity, std::string_view law);
  /// Of all servos of a robot at articulated_dynamics; the others remember it.
  void exchange_servo_law(std::string_view robot, std::string_view law);

  /// What has happened so far. `wall` is the wall time that it took.
  [[nodiscard]] RunReport report(Duration wall, const Lateness& lateness = {}) const;

  /// Draws the field from above with everybody's path so far (without SceneOptions::paths: only where they are now). Throws
  /// SetupError if the file cannot be written.
  void write_picture(const std::filesystem::path& file) const;

  /// A line about events and pushes whose time has not come; empty if all have, and before the first step.
  [[nodiscard]] std::string events_to_come() const;

  /// Robots, ball and bodies, in the order of sensors' labels.
  [[nodiscard]] const std::vector<Entity*>& moving_entities() const { return moving_entities_; }

  /// A renderer of this scene for who looks from outside (murosimf render), in the scene's light. The simulation must
  /// be initialized and outlive it. Throws SetupError if this machine or this build cannot draw.
  [[nodiscard]] std::unique_ptr<render::Renderer> make_renderer(const LightSpec& light);

 private:
  struct RobotKind {
    ModelPtr model;
    std::vector<sensors::SensorSpec> sensors;  // of its files
  };

  /// The model, or a copy with the constants that the scene changes for this entity.
  [[nodiscard]] ModelPtr model_for(const std::string& entity, const ModelPtr& model);
  void add_entities();
  void add_field();
  void add_bodies();
  void add_body(const BodySpec& body);
  /// Null if it is no body of [[bodies]].
  [[nodiscard]] const BodySpec* body_spec(const Entity& entity) const;
  void start_bodies();
  /// Who cannot walk on what stands on the field.
  void warn_about_static_bodies();
  void add_robot(const RobotSpec& robot);
  [[nodiscard]] Mat3d random_tilt(const RandomStream& random) const;
  void scatter_postures();
  /// Gives a sensor of a robot's file a rate that the scene's steps allow, if steps of usual length would allow its own.
  /// What has changed; empty: nothing.
  [[nodiscard]] std::string fit_to_steps(sensors::SensorSpec& spec) const;
  /// Those of the robot's files, changed by the scene. Notes rates that had to change.
  [[nodiscard]] std::vector<sensors::SensorSpec> sensors_of(const RobotSpec& robot);
  void attach_sensors();
  /// Who draws for cameras, made when the first of them asks; null if nobody can, which is a warning then.
  [[nodiscard]] sensors::ViewSource* view_source();
  [[nodiscard]] std::string sensor_remarks(const RobotSpec& robot) const;
  /// What sensors have to say of the level of their robots: one line for robots of which the same is true.
  void note_about_sensors();
  /// The same of one robot, unless it was said before.
  void note_about_sensors(const RobotSpec& robot);
  void attach_controllers();
  [[nodiscard]] std::string level_at(const Entity& entity, double time) const;
  /// Throws SetupError if its level ignores forces when the push begins.
  void check_feels(const Entity& entity, const PushSpec& push) const;
  void attach_pushes();
  void attach_contact();
  void note(const RobotSpec& robot, const std::string& text);
  void warn(const RobotSpec& robot, const std::string& text);
  /// Whatever the scene says that changes nothing (unused_settings.h).
  void warn_about_settings();
  void check_no_contact(const RobotSpec& robot, const Model& model);
  /// Settings and events, before the first step (property_checks.h).
  void check_properties();
  void check_property(const PropertySetting& setting, double time);
  /// Who stands in whom.
  void warn_about_start();
  /// Has a controller's next cycles looked at, which may write what was set.
  void watch(const PropertySetting& setting, const std::string& entity);
  /// What a user may have overlooked: steps too long, joints without servos.
  void warn_about(const RobotSpec& robot, const Model& model);
  void attach_motion();
  void attach_observers();
  [[nodiscard]] std::vector<Vec3d> path_of(Entity& entity) const;
  void schedule_events();
  void apply_settings();
  void apply(const PropertySetting& setting, const std::string& entity);
  void apply(const SceneEvent& event, const std::string& entity);
  [[nodiscard]] RobotSpec& spec_of(std::string_view robot);
  void renew_level(const RobotSpec& robot);
  void check_materials(const Model& model) const;
  [[nodiscard]] ModelPtr model(const std::string& name, const std::string& where);

  SceneSpec spec_;
  SceneOptions options_;
  std::unique_ptr<Simulation> simulation_;
  std::map<std::string, RobotKind> models_;                              // equal robots share one
  std::map<std::pair<ModelPtr, std::string>, ModelPtr> changed_models_;  // equal changes share one, too
  std::set<std::pair<std::string, std::string>> said_;                   // robots, and remarks of their sensors
  std::vector<std::string> notes_;                                       // about sensors
  std::vector<std::string> warnings_;                                    // from reading models
  std::map<std::string, int> settings_;                                  // how often each property was set
  std::unique_ptr<render::Renderer> renderer_;                           // of cameras
  bool cannot_draw_ = false;
  Entity* field_ = nullptr;
  Entity* ball_ = nullptr;
  std::vector<Entity*> robots_;                               // in the order of the spec
  std::vector<std::vector<const sensors::Sensor*>> sensors_;  // by robot
  std::vector<Entity*> bodies_;                               // those of [[bodies]] that move
  std::vector<Entity*> moving_entities_;                      // robots, ball and bodies
  std::vector<collision::GroundContact*> ground_contacts_;    // by moving entity
  const PathRecorder* recorder_ = nullptr;                    // null: nobody asked for paths
};

}  // namespace murosimf::scene
