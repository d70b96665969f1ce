/// simulation_messages.h - messages of simulation_interfaces 2.1, decoded and encoded.
///
/// Source: package simulation_interfaces (ros-simulation), versions 2.0 and 2.1, docs.ros.org: fields in their order, numbers of features and
/// results. Requests of 1.x and 2.0 have the same bytes, but for the flags that 2.1 appends to SetEntityState; answers of 1.x with Spawnable and
/// WorldResource have others.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "murosimf/dds/cdr.h"
#include "murosimf/dds/ros2/message_encoding.h"

namespace murosimf::ros2 {

/// simulation_interfaces/Result, and what single services add to it.
enum class ResultCode : std::uint8_t {
  feature_unsupported = 0,
  ok = 1,
  not_found = 2,
  incorrect_state = 3,
  operation_failed = 4,
  name_not_unique = 101,          ///< SpawnEntity
  name_invalid = 102,             ///< SpawnEntity
  no_resource = 104,              ///< SpawnEntity
  namespace_invalid = 105,        ///< SpawnEntity
  resource_parse_error = 106,     ///< SpawnEntity
  missing_assets = 107,           ///< SpawnEntity
  unsupported_assets = 108,       ///< SpawnEntity
  invalid_pose = 109,             ///< SpawnEntity
  entities_spawn_failed = 150,    ///< SpawnEntities
  invalid_state = 101,            ///< SetEntityState: INVALID_POSE
  no_world_resource = 102,        ///< LoadWorld
  world_parse_error = 103,        ///< LoadWorld
  already_in_target_state = 101,  ///< SetSimulationState
};

struct Result {
  ResultCode code = ResultCode::ok;
  std::string message{};
};
void put(dds::ros2::RosWriter& out, const Result& result);

/// simulation_interfaces/SimulatorFeatures
enum class Feature : std::uint16_t {
  spawning = 0,
  deleting = 1,
  named_poses = 2,
  pose_bounds = 3,
  entity_tags = 4,
  entity_bounds = 5,
  entity_categories = 8,
  spawning_resource_string = 9,
  entity_state_getting = 10,
  entity_state_setting = 11,
  entity_info_getting = 12,
  entity_info_setting = 13,
  spawnables = 14,
  simulation_reset = 20,
  simulation_reset_spawned = 23,
  simulation_state_getting = 24,
  simulation_state_setting = 25,
  simulation_state_pause = 26,
  step_simulation_single = 31,
  step_simulation_multiple = 32,
  step_simulation_action = 33,
  world_loading = 40,
  world_info_getting = 44,
  available_worlds = 45,
  spawning_entities = 50,
};

/// simulation_interfaces/EntityCategory
enum class Category : std::uint8_t {
  object = 0,  ///< or not specified
  robot = 1,
  human = 2,
  dynamic_object = 4,
  static_object = 5
};

/// simulation_interfaces/SimulationState
enum class SimulationState : std::uint8_t { stopped = 0, playing = 1, paused = 2, quitting = 3 };

/// Types of simulation_interfaces/Bounds.
enum class BoundsType : std::uint8_t {
  empty = 0,
  box = 1,          ///< points: upper corner, lower corner
  convex_hull = 2,  ///< of the points
  sphere = 3        ///< points: middle; x of the second one is the radius
};

/// Bounds of a request, in the world.
struct Region {
  BoundsType type = BoundsType::empty;
  std::vector<Vec3d> points;  ///< [m]
  /// Whether it is everywhere.
  [[nodiscard]] bool is_empty() const { return type == BoundsType::empty || points.empty(); }
  [[nodiscard]] bool is_known() const { return type <= BoundsType::sphere; }
};

/// simulation_interfaces/EntityFilters
struct EntityFilters {
  std::string names;  ///< POSIX extended regular expression; empty: all
  std::vector<Category> categories;
  std::vector<std::string> tags;
  bool all_tags = false;
  Region bounds;
};
[[nodiscard]] EntityFilters read_filters(dds::CdrReader& in);
/// simulation_interfaces/TagsFilter
void read_tags_into(dds::CdrReader& in, EntityFilters& filters);
[[nodiscard]] bool has_tags(const EntityFilters& filters, const std::vector<std::string>& tags);

/// simulation_interfaces/EntityInfo
struct EntityInfo {
  Category category = Category::object;
  std::string description;
  std::vector<std::string> tags;
};
[[nodiscard]] EntityInfo read_info(dds::CdrReader& in);
void put(dds::ros2::RosWriter& out, const EntityInfo& info);

/// simulation_interfaces/Bounds of TYPE_BOX: its upper, then its lower corner [m]. Without points: of TYPE_EMPTY, unbounded.
struct Bounds {
  std::vector<Vec3d> points;
};
void put(dds::ros2::RosWriter& out, const Bounds& bounds);

/// simulation_interfaces/EntityState: in the world, if its frame is empty.
struct EntityState {
  Duration time{};
  std::string frame = "world";
  Vec3d position;  ///< [m]
  Quaterniond orientation{1, 0, 0, 0};
  Vec3d linear, angular;  ///< [m/s], [rad/s] axes of the frame
};
void put(dds::ros2::RosWriter& out, const EntityState& state);
[[nodiscard]] EntityState read_state(dds::CdrReader& in);

/// Request of SetEntityState. Before 2.1 it has no flags: pose and velocities are set.
struct EntityStateRequest {
  std::string entity;
  EntityState state;
  bool sets_pose = true, sets_twist = true;
};
[[nodiscard]] EntityStateRequest read_state_request(dds::CdrReader& in);
/// geometry_msgs/PoseStamped
[[nodiscard]] EntityState read_pose(dds::CdrReader& in);

/// simulation_interfaces/NamedPose, and what GetNamedPoseBounds tells of it.
struct NamedPose {
  std::string name, description;
  std::vector<std::string> tags;
  EntityState state;
  Bounds bounds;
};
void put(dds::ros2::RosWriter& out, const NamedPose& pose);

/// simulation_interfaces/WorldResource
void put_world(dds::ros2::RosWriter& out, const std::string& name, const std::string& description);

[[nodiscard]] std::vector<std::string> read_texts(dds::CdrReader& in);

}  // namespace murosimf::ros2
