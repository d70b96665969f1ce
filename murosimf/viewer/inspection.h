/// inspection.h - what a viewer wants to know of a running scene besides poses: a copy, made between two steps (Session::visit).
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

/// An object of an entity, by their numbers.
struct ObjectPath {
  int entity = 0, object = 0;
  friend auto operator<=>(const ObjectPath&, const ObjectPath&) = default;
};

struct PropertyValue {
  std::string name, unit;
  std::vector<double> numbers;
  bool constant = false;  ///< of the model: cannot change while it runs
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
  std::optional<Vec3d> believed_pose;  ///< [m, m, rad] where it takes itself to be (soccer/beliefs.h)
};

struct SensorState {
  std::shared_ptr<const sensors::SensorInfo> info;
  double time = 0;  ///< [s] of the sample
  std::uint64_t samples = 0;
  std::vector<double> values;
};

struct CameraState {
  std::shared_ptr<const sensors::CameraInfo> info;
  bool wanted = false;          ///< it draws, since somebody reads its pictures
  double time = 0;              ///< [s] of the picture
  imaging::ColorImage picture;  ///< empty if there is none
};

/// What a joint's servo gives, of what it can.
struct JointLoad {
  ObjectPath path;
  double share = 0;  ///< |joint_torque| by the limit of the servo's torque
};

/// What is to be looked at.
struct InspectionRequest {
  std::vector<ObjectPath> objects;      ///< all properties of these
  std::vector<std::string> properties;  ///< but of those that change only these, if there are any
  std::optional<int> sensors_of;        ///< of this entity
  bool pictures = false;                ///< also what its cameras have drawn
  bool algorithms = false;
  bool loads = false;                                ///< of the joints of all robots
  std::uint64_t drawings_known = 0;                  ///< Inspection::drawings, of those that are known already
  std::size_t events_known = 0, warnings_known = 0;  ///< so many of both are known already
};

struct Inspection {
  Duration time{};
  int changes_to_see = 0;             ///< scene::SceneParts
  std::vector<EntityState> entities;  ///< in the order of the world
  std::vector<ObjectValues> objects;  ///< as requested
  std::optional<int> sensors_of;      ///< entity of those that follow
  std::vector<SensorState> sensors;
  std::vector<CameraState> cameras;
  std::vector<AlgorithmStatistics> algorithms;
  std::vector<JointLoad> loads;
  std::uint64_t drawings = 0;                        ///< changes with what is drawn for people who watch
  std::optional<std::vector<drawing::Drawn>> drawn;  ///< that; nothing: it is known
  std::size_t first_event = 0, first_warning = 0;    ///< numbers of those that follow
  std::vector<Event> events;
  std::vector<std::string> warnings;  ///< of the scene, then of the simulation
};

/// Reads only. In the thread that runs the scene, between two steps.
[[nodiscard]] Inspection inspect(const scene::Scene& scene, const InspectionRequest& request);

/// What does not change while a scene runs and nobody is added to it: for who draws trees and needs numbers of models.
struct EntityOutline {
  std::string name;
  ModelPtr model;
  std::string team;
  Color color;
  bool is_robot = false, is_ball = false, moves = false;
  int label = -1;  ///< number among the robots, from 0
};
[[nodiscard]] std::vector<EntityOutline> outline_of(const scene::Scene& scene);

}  // namespace murosimf::viewer
