/// scene_spec.h - the contents of a scene file: plain data, checked one by one, before anything is built.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/component_files/sensor_table.h"
#include "murosimf/control_software/control_link_options.h"
#include "murosimf/control_software/radio_options.h"
#include "murosimf/dynamics/integrator.h"
#include "murosimf/locomotion/motion_state.h"
#include "murosimf/math/scalar.h"
#include "murosimf/math/vec3.h"
#include "murosimf/model/material.h"
#include "murosimf/model/option.h"
#include "murosimf/scene_file/ball.h"
#include "murosimf/scene_file/body_spec.h"
#include "murosimf/world/entity.h"
#include "murosimf/world/state_archive.h"
#include "murosimf/world/time.h"

namespace murosimf::scene_file {

inline constexpr double longest_duration = 3e9;  ///< [s] a century; nanoseconds in 64 bits end after three

/// [air]: the air around balls.
using AirSpec = air::AirOptions;

struct FieldSpec {
  std::string size = "kid_size_2008";
  std::string surface = "carpet";
  Vec3d friction_direction;  ///< [1] in which its pile leans, in the ground plane; zero: none
  bool goals = true;
  std::optional<bool> nets;  ///< of the goals; empty: as in the field's size
  bool landmark_poles = false;
  std::optional<double> friction;  ///< [1] between the ground and everything; empty: by the pairs of materials
};

struct BallSpec : BallOptions {
  Color color{1.0, 0.45, 0.1};
  Vec3d position;  ///< [m] z: height of its lowest point
  Vec3d velocity;  ///< [m/s]
  std::string contact = "implicit_stick";
  bool present = true;  ///< at the start
};

/// Camera of pictures of the bodies.
struct ViewSpec {
  Vec3d center{0, 0, 0.2};     ///< [m] in the middle of the picture, if `width` is given
  double width = 0;            ///< [m] of the picture; 0: all of the field
  double azimuth = -pi / 2.4;  ///< [rad] of the eye, counterclockwise from x
  double elevation = pi / 7;   ///< [rad] above the ground
};

/// Light of the scene for cameras (render/light.h).
struct LightSpec {
  std::string name = "hall";
  std::optional<Vec3d> toward;  ///< direction to the lamp; default: that of `name`
  double brightness = 1;        ///< [1] of all light
  bool shadows = false;
  int samples = 1;  ///< per pixel; 4 smooths edges

  void state(StateArchive& archive) { archive(name, toward, brightness, shadows, samples); }
};

/// A viewpoint of the scene: [views.NAME].
struct ViewpointSpec {
  std::string name;
  Vec3d eye, look_at;   ///< [m]
  double fov = pi / 3;  ///< [rad] from the left to the right border
};

struct TeamSpec {
  std::string name;
  Color color;
  double attacks = 1;        ///< +1: the goal at positive x, -1: the other one
  std::uint64_t number = 0;  ///< in a game with a GameController; 0: by the order there
};

/// Where a scene sets a key, and whether only its [defaults] do.
struct GivenKey {
  std::string where;
  bool by_default = false;
};

struct RobotSpec {
  std::string name;
  std::string team;
  std::string model;
  std::string where;  ///< place in the scene file, for messages
  std::string level = "kinematic_walking";
  std::string contact = "implicit_stick";
  std::string controller = "walk";
  double rate = 0;          ///< [Hz] of its motion and contact while no other entity is near; 0: the scene's
  double control_rate = 0;  ///< [Hz] of its controller; 0: the controller's own
  OptionValues options;     ///< of the controller, those that are given
  OptionValues level_options, contact_options;  ///< the same of the level and of the law of contact with the ground
  std::string servo_law;                        ///< instead of the law of the model's servos; empty: those
  std::string motion;                           ///< name or file, for the controller "keyframes"; empty for none
  std::string library;                          ///< file of the controller "library"; empty for none
  double call_budget = 0;                       ///< [s] of wall time for each of its calls; 0: any
  bool reload = false;                          ///< reloads the library when its file changes
  control_software::ControlLinkOptions link;    ///< between it and its control software
  std::string joint_reference = "filter";
  dynamics::Integrator integrator = dynamics::Integrator::semi_implicit_euler;
  bool base_rigid = false;
  bool fixed_base = false;
  Vec3d position;              ///< [m]
  double heading = 0;          ///< [rad]
  double roll = 0, pitch = 0;  ///< [rad] about the level robot's x, then its y; before the heading
  std::string body;            ///< of several robots in its file the one with this body; empty: the reader chooses
  std::map<std::string, std::string> xacro;  ///< arguments of its file with macros, by name
  std::string keyframe;                      ///< of its file, at which it starts; empty: the pose of the file
  Vec3d command;                             ///< [m/s, m/s, rad/s]
  bool present = true;                       ///< at the start
  bool accelerations = false;                ///< are computed (dynamics/accelerations.h)
  CollisionOptions collision;
  component_files::SensorChanges sensors;
  std::map<std::string, GivenKey> given;  ///< its keys that were set
};

/// A pair of [[materials]], for messages; its values are in the table.
struct GivenPair {
  std::string a, b;
  std::string where;
};

/// A property to set: --set 'blue1.pelvis.applied_force=[5,0,0,0,0,0]'.
struct PropertySetting {
  std::string where;
  std::vector<std::string> entities;
  std::string object, property;  ///< no object: the base
  std::vector<double> numbers;
};

/// A force for a limited time, at the center of mass of a body: --push.
struct PushSpec {
  std::string where;
  std::vector<std::string> entities;
  std::string object;         ///< empty: the base
  Vec3d force;                ///< [N] world
  Vec3d moment;               ///< [N m] world
  double begin = 0, end = 0;  ///< [s]
};

/// Pose at which an entity is placed while a scene runs.
struct Placement {
  Vec3d position;      ///< [m] of the base on the ground plane; z: of its lowest point
  double heading = 0;  ///< [rad] about the vertical
};

/// A change while the scene runs: of a level, law or command, presence, place, a property, a push that begins, or a
/// key of a section.
struct SceneEvent {
  double time = 0;  ///< [s]
  std::string where;
  std::vector<std::string> entities;  ///< empty if a section changes
  std::string key, value;             ///< of a robot or the section; with `setting`, only for messages
  std::optional<PropertySetting> setting;
  std::string section{};           ///< "light" or "ball" (section_change.h); empty: entities change
  std::optional<PushSpec> push{};  ///< begin 0: from the event on
  std::optional<Placement> place{};
  std::optional<locomotion::KickRequest> kick{};  ///< its number is not used
};

/// A class in Python that acts in the scene (control_software/python/python_algorithm.h).
struct AlgorithmSpec {
  std::string name;
  std::string target;                   ///< "module:Class"
  std::string on;                       ///< entity; empty: the whole scene
  double rate = 0;                      ///< [Hz] 0: that of the class
  double call_budget = 0;               ///< [s] of wall time for each call; 0: any
  double delay = 0;                     ///< [s] of a sensor's samples
  std::map<std::string, double> noise;  ///< of a sensor: deviation by output, in its unit; "": of all others
  OptionValues options;                 ///< of the class
  std::string where;                    ///< place of the class in the file
};

/// Settings of a game with a referee (league/).
struct LeagueSpec {
  bool place_penalized = true;       ///< at the side line
  std::uint64_t answer_port = 3939;  ///< of the GameController's machine
};

struct SceneSpec {
  std::filesystem::path file;
  std::string name;
  double duration = 10;  ///< [s]
  std::uint64_t seed = 1;
  double rate = usual_step_rate;  ///< [Hz] of motion and contact
  bool automatic_rate = false;    ///< `rate` follows from levels and laws (automatic_rate.h)
  std::string rate_because;       ///< the entity that limits the step in that case
  Vec3d gravity{0, 0, -9.81};     ///< [m/s^2]
  double jitter_position = 0;     ///< [m] start places vary by up to this, in x and y
  double jitter_heading = 0;      ///< [rad]
  double jitter_tilt = 0;         ///< [rad] about a random axis
  double jitter_posture = 0;      ///< [rad] joint targets vary by up to this, within joint limits
  std::string body_contact = "island_gauss_seidel";
  OptionValues body_contact_options;  ///< of that law, those that are given
  AirSpec air;
  FieldSpec field;
  ViewSpec view;
  LightSpec light;
  std::vector<ViewpointSpec> viewpoints;
  std::optional<BallSpec> ball;
  std::vector<TeamSpec> teams;
  std::vector<RobotSpec> robots;
  std::vector<BodySpec> bodies;
  MaterialTable materials = MaterialTable::standard();
  std::vector<GivenPair> material_pairs;  ///< those of `materials` that the scene sets
  std::vector<PropertySetting> settings;
  std::vector<SceneEvent> events;  ///< in the order of time
  std::vector<PushSpec> pushes;
  control_software::RadioOptions communication;
  LeagueSpec league;
  std::vector<AlgorithmSpec> algorithms;
};

/// [Hz] Rate of the longest steps that a robot makes.
[[nodiscard]] inline double step_rate(const SceneSpec& scene, const RobotSpec& robot) {
  return robot.rate > 0 ? robot.rate : scene.rate;
}

/// Reads a scene file (docs/scenes.md). `overrides` are PATH=VALUE as for --set: a key of the file ("duration=5",
/// "field.surface=grass"), a key of robots ("blue1.level=...", "blue.*.options.speed=..."), or a property
/// ("blue1.pelvis.applied_force=[5,0,0,0,0,0]"). `at_options` are TIME:PATH=VALUE as for --at (event_section.h),
/// `push_options` are as for --push (push_section.h). Throws SetupError with file:line:column.
[[nodiscard]] SceneSpec read_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides = {},
                                   const std::vector<std::string>& at_options = {},
                                   const std::vector<std::string>& push_options = {});

}  // namespace murosimf::scene_file
