/// four_bar.h - a planar four-bar linkage, and its closed forms.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/multibody/loops.h"
#include "tests/fixtures.h"
#include "tests/physics/rig.h"

namespace murosimf::test {

// A planar four-bar in the plane y = 0: ground a from (0, 0, 0) to (0.3, 0, 0), crank b, coupler c, rocker d.
inline constexpr double ground = 0.3, crank = 0.1, coupler = 0.25, rocker = 0.2;  // [m]

struct FourBar {
  bool welded = false;
  double rocker_tilt = 0;  // [rad] of the rocker's hinge, about x
  bool commanded = false;  // the rocker takes targets
  std::optional<Servo> servo{};
};

/// A bar of `length` along x with its mass in the middle, behind a hinge about y (positive: down).
inline Chain bar(const std::string& name, double length, const Vec3d& axis = {0, 1, 0}) {
  const double m = length, J = m * length * length / 12;
  return Chain{}
      .revolute(name, axis)
      .with(properties::mass, m)
      .with(properties::center_of_mass, {0.5 * length, 0, 0})
      .with(properties::inertia, {1e-5, J, J, 0, 0, 0});
}

/// The angle [rad] of the rocker against x, up, for a crank at `angle`, up: where circles about the crank's end and the rocker's
/// hinge meet, the upper point.
inline double rocker_angle(double angle) {
  const double x = crank * std::cos(angle) - ground, z = crank * std::sin(angle);
  const double s2 = x * x + z * z, s = std::sqrt(s2);
  const double along = (s2 + rocker * rocker - coupler * coupler) / (2 * s);
  const double beside = std::sqrt(rocker * rocker - along * along);
  return std::atan2(along * z / s - beside * x / s, along * x / s + beside * z / s);
}
inline double coupler_angle(double angle) {
  const double phi = rocker_angle(angle);
  return std::atan2(rocker * std::sin(phi) - crank * std::sin(angle),
                    ground + rocker * std::cos(phi) - crank * std::cos(angle));
}

/// In its rest pose the crank stands at `rest`, up. Joints count from there.
inline constexpr double rest = 1.0;

inline Chain four_bar(const FourBar& options = {}) {
  Chain first = Chain{}.rotation({0, 1, 0}, -rest);
  Chain cranked = bar("crank", crank);
  if (options.servo) cranked.with(properties::servo, *options.servo);
  cranked.translation({crank, 0, 0}).rotation({0, 1, 0}, rest - coupler_angle(rest));
  Chain coupled = bar("coupler", coupler);
  coupled.translation({coupler, 0, 0});
  if (options.welded) coupled.rotation({0, 1, 0}, coupler_angle(rest) - rocker_angle(rest));
  coupled.endpoint("pin");
  Chain rocked = Chain{}.translation({ground, 0, 0}).rotation({0, 1, 0}, -rocker_angle(rest));
  const Vec3d tilted{0, std::cos(options.rocker_tilt), std::sin(options.rocker_tilt)};
  Chain rockers = bar("rocker", rocker, tilted);
  if (options.commanded) rockers.with(properties::loop_commanded, 1.0);
  rockers.translation({rocker, 0, 0});
  if (options.welded)
    rockers.revolute("end", {0, 1, 0}).with(properties::mass, 1e-3).with(properties::inertia, diagonal(1e-6));
  rockers.endpoint("end_of_rocker").with(properties::loop_closure, {"pin", options.welded});
  const auto join = [](Chain a, const Chain& b) { return a.fork(std::vector<Chain>{b}); };
  return Chain{}
      .base("frame")
      .with(properties::mass, 1.0)
      .with(properties::inertia, diagonal(0.1))
      .fork(join(first, join(cranked, coupled)), join(rocked, rockers));
}

inline double q(Entity& robot, const char* joint) { return robot.object(joint).get(properties::joint_position); }
inline Vec3d place(Entity& robot, const char* object) { return robot.object(object).get(properties::position); }

/// [m] how far the ends are apart.
inline double gap(Entity& robot) { return norm(place(robot, "pin") - place(robot, "end_of_rocker")); }

/// [rad] between where the rocker is and where the crank takes it.
inline double rocker_error(Entity& robot) {
  const double expected = rocker_angle(rest - q(robot, "crank"));
  return std::abs(rocker_angle(rest) - q(robot, "rocker") - expected);
}

inline double energy(Entity& robot) {
  const auto& model = robot.model();
  double sum = 0;
  for (const char* name : {"crank", "coupler", "rocker"}) {
    const int i = model.object_index(name);
    const Vec3d com = *model.find(properties::center_of_mass, i);
    const double m = *model.find(properties::mass, i);
    const auto object = robot.object(name);
    const Mat3d R = ObjectAccess(object).get(properties::orientation);
    const Vec3d w = ObjectAccess(object).get(properties::angular_velocity);
    const Vec3d v = ObjectAccess(object).get(properties::linear_velocity) + cross(w, R * com);
    const Vec3d height = ObjectAccess(object).get(properties::position) + R * com;
    const Vec3d local = transposed_times(R, w);
    sum += 0.5 * m * dot(v, v) + 0.5 * dot(local, *model.find(properties::inertia, i) * local) + m * g * height.z;
  }
  return sum;
}

inline Servo servo() {
  return {.law = "ideal_pd", .stall_torque = 5, .position_gain = 50, .velocity_gain = 1, .rotor_inertia = 1e-3};
}

/// [J] of the bars' weight, for a crank at `angle`, up.
inline double height_energy(double angle) {
  const double c = crank * std::sin(angle), b = coupler * std::sin(coupler_angle(angle)),
               r = rocker * std::sin(rocker_angle(angle));
  return g * (crank * 0.5 * c + coupler * (c + 0.5 * b) + rocker * 0.5 * r);
}

}  // namespace murosimf::test
