#include "murosimf/locomotion/vehicle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "murosimf/dynamics/servo/servo_law.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"
#include "murosimf/multibody/kinematics.h"

namespace murosimf::locomotion {
namespace {

constexpr double parallel = 0.999;     // [1] cosine between axes that count as one direction
constexpr double eccentricity = 1e-3;  // [m] of a cylinder that still counts as a wheel

/// A model with all joints at zero.
struct RestPose {
  explicit RestPose(const Model& m) : model(m), r(static_cast<std::size_t>(m.size())), R(r.size(), Mat3d{}) {
    const std::vector<double> q(r.size(), 0.0);
    multibody::poses<double>(m.tree(), q, r, R);
  }
  [[nodiscard]] const Link& link_of(int object) const {
    MUROSIMF_ASSERT(object >= 0 && static_cast<std::size_t>(object) < model.tree().link_of.size());
    return model.tree().links[model.tree().link_of[object]];
  }
  [[nodiscard]] Vec3d axis(const Link& link) const { return R[link.object] * link.axis; }

  const Model& model;
  std::vector<Vec3d> r;
  std::vector<Mat3d> R;
};

bool is_endless_hinge(const RestPose& rest, const Link& link) {
  return link.kind == LinkKind::revolute && !rest.model.find(properties::joint_range, link.object);
}

/// The wheel of this shape of an object, without its steering; nothing if the shape is not a wheel.
std::optional<Wheel> wheel_of(const RestPose& rest, int object, const PlacedShape& placed) {
  const auto* cylinder = std::get_if<Cylinder>(&placed.shape);
  const Link& link = rest.link_of(object);
  if (!cylinder || !is_endless_hinge(rest, link)) return std::nullopt;
  const Vec3d axis = rest.axis(link);
  const Vec3d along = rest.R[object] * placed.orientation.z;
  const Vec3d center = rest.r[object] + rest.R[object] * placed.position;
  const Vec3d off = tangential(center - rest.r[link.object], axis);
  if (std::abs(axis.y) < parallel || std::abs(dot(axis, along)) < parallel || norm(off) > eccentricity) {
    return std::nullopt;
  }
  Wheel wheel{.joint = link.object, .sign = axis.y > 0 ? 1.0 : -1.0, .radius = cylinder->radius};
  wheel.x = center.x;
  wheel.y = center.y;
  const Servo* servo = rest.model.find(properties::servo, link.object);
  wheel.driven = servo && dynamics::follows_rate(*servo);
  return wheel;
}

/// Sets the pivot of the wheel: the last hinge about z with a range between the base and the wheel.
void find_steering(const RestPose& rest, Wheel& wheel) {
  const auto& links = rest.model.tree().links;
  for (int l = rest.link_of(wheel.joint).parent; l > 0; l = links[l].parent) {
    MUROSIMF_ASSERT(links[l].parent < l);
    const double up = rest.axis(links[l]).z;
    const bool ends = rest.model.find(properties::joint_range, links[l].object);
    if (links[l].kind != LinkKind::revolute || std::abs(up) < parallel || !ends) continue;
    const Vec3d& pivot = rest.r[links[l].object];
    wheel.steering = links[l].object;
    wheel.steering_sign = up > 0 ? 1 : -1;
    wheel.outside = wheel.y - pivot.y;
    wheel.x = pivot.x;
    wheel.y = pivot.y;
    return;
  }
}

/// Moves the origin of all places to the middle of the axle that does not steer.
void measure_from_axle(std::vector<Wheel>& wheels) {
  const bool all_steer = std::ranges::all_of(wheels, [](const Wheel& w) { return w.steering >= 0; });
  double x = 0, y = 0, count = 0;
  for (const Wheel& wheel : wheels) {
    if (wheel.steering >= 0 && !all_steer) continue;
    x += wheel.x;
    y += wheel.y;
    ++count;
  }
  MUROSIMF_ASSERT(count > 0);
  for (Wheel& wheel : wheels) {
    wheel.x -= x / count;
    wheel.y -= y / count;
  }
}

/// Limits the curvature to where tan(angle) = c x / (1 - c y) meets the ends of the steering.
void limit_curvature(const Model& model, Vehicle& vehicle) {
  vehicle.greatest_curvature = std::numeric_limits<double>::infinity();
  vehicle.least_curvature = -vehicle.greatest_curvature;
  for (const Wheel& wheel : vehicle.wheels) {
    if (wheel.steering < 0) continue;
    const Vec3d& range = *model.find(properties::joint_range, wheel.steering);
    MUROSIMF_ASSERT(std::abs(wheel.steering_sign) == 1);
    for (const double end : {range.x, range.y}) {
      const double slope = std::tan(wheel.steering_sign * end);
      const double curvature = slope / (wheel.x + wheel.y * slope);
      if (curvature >= 0) vehicle.greatest_curvature = std::min(vehicle.greatest_curvature, curvature);
      if (curvature <= 0) vehicle.least_curvature = std::max(vehicle.least_curvature, curvature);
    }
  }
}

[[noreturn]] void refuse_vehicle(const Model& model, std::string_view why) {
  throw SetupError(fmt::format("model '{}' cannot be driven: {}", model.name(), why));
}

}  // namespace

Vehicle find_vehicle(const Model& model) {
  const RestPose rest(model);
  Vehicle vehicle;
  for (const int object : model.having(properties::shapes)) {
    for (const PlacedShape& placed : *model.find(properties::shapes, object)) {
      auto wheel = wheel_of(rest, object, placed);
      const auto same = [&](const Wheel& other) { return other.joint == wheel->joint; };
      if (!wheel || std::ranges::any_of(vehicle.wheels, same)) continue;
      find_steering(rest, *wheel);
      vehicle.wheels.push_back(*wheel);
    }
  }
  if (vehicle.wheels.empty()) refuse_vehicle(model, "it has no wheel, a cylinder about an endless hinge along y");
  if (std::ranges::none_of(vehicle.wheels, &Wheel::driven)) {
    refuse_vehicle(model, "no wheel has a servo that follows a rate; give one a <velocity> actuator");
  }
  measure_from_axle(vehicle.wheels);
  MUROSIMF_ASSERT(!vehicle.wheels.empty());
  limit_curvature(model, vehicle);
  return vehicle;
}

}  // namespace murosimf::locomotion
