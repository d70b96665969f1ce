#include "murosimf/scene/robot_placement.h"

#include <algorithm>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/collision/ground_points.h"
#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/model/fixed_base.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene/scene_algorithms.h"

namespace murosimf::scene {
namespace {

/// Rotation about the robot's base that makes it upright with this heading.
Mat3d turn_to(Entity& robot, double heading) {
  const auto soles = robot.model().having(properties::sole);
  const Mat3d base = robot.base().get(properties::orientation);
  if (soles.empty()) return rotation_z(heading) * transpose(base);
  const Mat3d sole = robot.object(robot.model().objects()[soles.front()].name).get(properties::orientation);
  return rotation_z(heading) * transpose(sole);
}

/// [m] Lowest point relative to the base after that rotation.
double lowest_point(Entity& robot, const Mat3d& turn) {
  const auto& shapes = collision::ground_shapes(robot.model());
  if (shapes.empty() || has_fixed_base(robot.model())) return 0;
  const Vec3d base = robot.base().get(properties::position);
  double lowest = std::numeric_limits<double>::infinity();
  for (const collision::GroundShape& shape : shapes) {
    auto object = robot.object(robot.model().objects()[shape.object].name);
    const Vec3d r = turn * (object.get(properties::position) - base);
    lowest = std::min(lowest, collision::lowest_point(shape, r, turn * object.get(properties::orientation), {}));
  }
  return lowest;
}

/// Moves all its objects: levels may continue from any of them.
void move(Entity& robot, const Mat3d& turn, const Vec3d& base) {
  std::vector<Vec3d>& r = robot.column(properties::position).values;
  std::vector<Mat3d>& R = robot.column(properties::orientation).values;
  MUROSIMF_ASSERT(!r.empty() && r.size() == R.size());
  const Vec3d before = r[0];
  for (std::size_t object = 0; object < r.size(); ++object) {
    r[object] = base + turn * (r[object] - before);
    R[object] = turn * R[object];
  }
  robot.base().set(properties::base_quaternion, from_matrix(R[0]));
}

void stop(Entity& robot) {
  std::ranges::fill(robot.column(properties::linear_velocity).values, Vec3d{});
  std::ranges::fill(robot.column(properties::angular_velocity).values, Vec3d{});
  if (!robot.model().joints().empty()) std::ranges::fill(robot.column(properties::joint_velocity).values, 0.0);
}

}  // namespace

void place(SceneParts& parts, std::string_view name, const Placement& placement) {
  Entity& robot = parts.simulation->world().entity(name);
  if (std::ranges::find(parts.moving_entities, &robot) == parts.moving_entities.end()) {
    throw SetupError(fmt::format("'{}' does not move, so it is not placed", name));
  }
  if (robot.idle()) {
    throw SetupError(fmt::format("{} is {}, so it is not placed", name, robot.present() ? "frozen" : "not there"));
  }
  const Mat3d turn = turn_to(robot, placement.heading);
  const double lowest = lowest_point(robot, turn);
  move(robot, turn, placement.position - Vec3d{0, 0, lowest});
  stop(robot);
  const auto spec = std::ranges::find(parts.spec.robots, name, &scene_file::RobotSpec::name);
  const std::string level = robot.level;
  const catalog::LevelOptions options =
      spec == parts.spec.robots.end() ? catalog::LevelOptions{} : level_options(parts, *spec);
  parts.simulation->exchange(level, robot, [&](Setup& setup) { return catalog::make_level(level, setup, options); });
  stop(robot);  // removes momentum kept by the level
}

}  // namespace murosimf::scene
