#include "murosimf/ros2/entity_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "murosimf/collision/ground_points.h"
#include "murosimf/model/properties.h"

namespace murosimf::ros2 {
namespace {

std::string numbers(const Vec3d& v) { return fmt::format("[{}, {}, {}]", v.x, v.y, v.z); }

bool is_finite(const Vec3d& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// [m] Limits of one shape along the axes; r, R: pose of its object.
void widen(Bounds& bounds, const collision::GroundShape& shape, const Vec3d& r, const Mat3d& R) {
  const auto least = [&](const Vec3d& axis) { return collision::lowest_point(shape, r, R, {.normal = axis}); };
  const Vec3d lower{least({1, 0, 0}), least({0, 1, 0}), least({0, 0, 1})};
  const Vec3d upper{-least({-1, 0, 0}), -least({0, -1, 0}), -least({0, 0, -1})};
  if (bounds.points.empty()) bounds.points = {upper, lower};
  Vec3d &most = bounds.points[0], &first = bounds.points[1];
  most = {std::max(most.x, upper.x), std::max(most.y, upper.y), std::max(most.z, upper.z)};
  first = {std::min(first.x, lower.x), std::min(first.y, lower.y), std::min(first.z, lower.z)};
}

}  // namespace

Category category_of(const scene::Scene& scene, const Entity& entity) {
  const auto& robots = scene.parts().robots;
  return std::ranges::find(robots, &entity) != robots.end() ? Category::robot : Category::dynamic_object;
}

std::vector<std::string> tags_of(const Entity& entity) {
  std::vector<std::string> tags{entity.model().name()};
  if (!entity.options().team.empty()) tags.push_back(entity.options().team);
  return tags;
}

const Entity* find_entity(const scene::Scene& scene, const std::string& name) {
  const auto& all = scene.moving_entities();
  const auto found = std::ranges::find(all, name, [](const Entity* entity) { return entity->name(); });
  return found == all.end() ? nullptr : *found;
}

EntityState state_of(const scene::Scene& scene, const Entity& entity) {
  EntityState state{.time = scene.simulation().now()};
  if (const auto* position = entity.find(properties::position)) state.position = position->values[0];
  if (const auto* turn = entity.find(properties::orientation)) state.orientation = from_matrix(turn->values[0]);
  if (const auto* linear = entity.find(properties::linear_velocity)) state.linear = linear->values[0];
  if (const auto* angular = entity.find(properties::angular_velocity)) state.angular = angular->values[0];
  return state;
}

Bounds bounds_of(const Entity& entity) {
  Bounds bounds;
  const auto* const positions = entity.find(properties::position);
  const auto* const turns = entity.find(properties::orientation);
  if (!positions || !turns) return bounds;
  const Vec3d base = positions->values[0];
  const Mat3d to_base = transpose(turns->values[0]);
  for (const collision::GroundShape& shape : collision::ground_shapes(entity.model())) {
    const auto i = static_cast<std::size_t>(shape.object);
    widen(bounds, shape, to_base * (positions->values[i] - base), to_base * turns->values[i]);
  }
  return bounds;
}

/// Upright and at rest at first, which leaves nothing of contacts before; then as wanted.
std::vector<std::string> changes_to(const Entity& entity, const EntityState& state) {
  const std::string base = fmt::format("{}.{}", entity.name(), entity.model().objects()[0].name);
  const Mat3d R = to_matrix(state.orientation);
  return {fmt::format("{}.place = [{}, {}, 0, {}]", entity.name(), state.position.x, state.position.y, heading(R)),
          fmt::format("{}.position = {}", base, numbers(state.position)),
          fmt::format("{}.orientation = [{}, {}, {}, {}, {}, {}, {}, {}, {}]", base, R.x.x, R.y.x, R.z.x, R.x.y, R.y.y,
                      R.z.y, R.x.z, R.y.z, R.z.z),
          fmt::format("{}.linear_velocity = {}", base, numbers(state.linear)),
          fmt::format("{}.angular_velocity = {}", base, numbers(state.angular))};
}

std::string trouble_with(EntityState& state) {
  Quaterniond& q = state.orientation;
  const double size = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  if (!is_finite(state.position) || !is_finite(state.linear) || !is_finite(state.angular))
    return "numbers are not finite";
  if (!(std::abs(size - 1) < 0.01)) return "the quaternion is not of length 1";
  q = {q.w / size, q.x / size, q.y / size, q.z / size};
  return state.frame.empty() || state.frame == "world" ? "" : "the frame must be world";
}

}  // namespace murosimf::ros2
