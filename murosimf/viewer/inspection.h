/// inspection.h - data of a running scene for a viewer, in addition to poses: a copy, made between two steps (Session::visit).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/drawing/drawn.h"
#include "murosimf/imaging/image.h"
#include "murosimf/runtime/simulation.h"
#include "murosimf/scene/scene.h"
#include "murosimf/sensors/camera_frame.h"
#include "murosimf/sensors/reading.h"

namespace murosimf::viewer {

/// An object of an entity, by their indices.
struct ObjectPath {
  int entity = 0, object = 0;
  friend auto operator<=>(const ObjectPath&, const ObjectPath&) = default;
};

struct PropertyValue {
  std::string name, unit;
  std::vector<double> numbers;
  bool constant = false;  ///< of the model: does not change while it runs
};

struct ObjectValues {
  ObjectPath path;
  std::vector<PropertyValue> properties;
};

struct EntityState {
  std::string name;
  std::string level, contact, controller;  ///< empty: none
  bool is_robot = false, moves = false, present = true, frozen = false;
  int standing_foot = -1;  ///< 0 or 1 at kinematic_walking, else -1
  int falls = 0;
  std::optional<Vec3d> believed_pose;  ///< [m, m, rad] the robot's own estimate of its pose (soccer/beliefs.h)
};

struct SensorState {
  std::shared_ptr<const sensors::SensorInfo> info;
  double time = 0;  ///< [s] of the sample
  std::uint64_t samples = 0;
  std::vector<double> values;
};

struct CameraState {
  std::shared_ptr<const sensors::CameraInfo> info;
  bool wanted = false;          ///< it is drawn, since its pictures are read
  double time = 0;              ///< [s] of the picture
  imaging::ColorImage picture;  ///< empty if there is none
};

/// Load of a joint's servo relative to its limit.
struct JointLoad {
  ObjectPath path;
  double share = 0;  ///< |joint_torque| divided by the limit of the servo's torque
};

/// Selection of the data.
struct InspectionRequest {
  std::vector<ObjectPath> objects;      ///< all properties of these
  std::vector<std::string> properties;  ///< restricts changing properties to these, if not empty
  std::optional<int> sensors_of;        ///< of this entity
  bool pictures = false;                ///< includes pictures of its cameras
  bool algorithms = false;
  bool loads = false;                                ///< of the joints of all robots
  std::uint64_t drawings_known = 0;                  ///< Inspection::drawings of the drawings known already
  std::size_t events_known = 0, warnings_known = 0;  ///< numbers of those known already
};

struct Inspection {
  Duration time{};
  int changes_to_see = 0;             ///< scene::SceneParts
  std::vector<EntityState> entities;  ///< in the order of the world
  std::vector<ObjectValues> objects;  ///< as requested
  std::optional<int> sensors_of;      ///< entity of the following members
  std::vector<SensorState> sensors;
  std::vector<CameraState> cameras;
  std::vector<AlgorithmStatistics> algorithms;
  std::vector<JointLoad> loads;
  std::uint64_t drawings = 0;                        ///< changes with the debug drawings
  std::optional<std::vector<drawing::Drawn>> drawn;  ///< debug drawings; nothing: unchanged
  std::size_t first_event = 0, first_warning = 0;    ///< indices of the first of each
  std::vector<Event> events;
  std::vector<std::string> warnings;  ///< of the scene, then of the simulation
};

/// Read-only. In the thread that runs the scene, between two steps.
[[nodiscard]] Inspection inspect(const scene::Scene& scene, const InspectionRequest& request);

/// Data that does not change while a scene runs unless an entity is added: for trees and indices of models.
struct EntityOutline {
  std::string name;
  ModelPtr model;
  std::string team;
  Color color;
  bool is_robot = false, is_ball = false, moves = false;
  int label = -1;  ///< index among the robots, from 0
};
[[nodiscard]] std::vector<EntityOutline> outline_of(const scene::Scene& scene);

}  // namespace murosimf::viewer
