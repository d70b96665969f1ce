#include "murosimf/locomotion/gait_seed.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "murosimf/locomotion/gait_balance.h"
#include "murosimf/locomotion/gait_limits.h"
#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/locomotion/walk_options.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"

namespace murosimf::locomotion {
namespace {

constexpr double gravity = 9.81;  // [m/s^2]
/// [1] Steps are quicker than kid21's, which has soft servos that lag; so the sway does not lead either.
constexpr double quicker = 0.7;

double leg_length(const std::array<Leg, 2>& legs) { return legs[0].thigh + legs[0].shin; }

WalkParameters scaled_by_length(const std::array<Leg, 2>& legs) {
  constexpr double kid21_leg = 0.24;             // [m] thigh and shin
  constexpr double kid21_half_hip_width = 0.05;  // [m]
  constexpr double kid21_ankle_height = 0.04;    // [m]
  WalkParameters p;
  MUROSIMF_ASSERT(leg_length(legs) > 0);
  const double scale = leg_length(legs) / kid21_leg;
  const double half_hip_width = 0.5 * (legs[0].hip.y - legs[1].hip.y);
  p.hip_height = (p.hip_height - kid21_ankle_height) * scale + legs[0].ankle_height;
  p.period *= std::sqrt(scale);
  p.lift *= scale;
  p.setback *= scale;
  p.half_width = half_hip_width + (p.half_width - kid21_half_hip_width) * scale;
  p.slew.x *= scale;
  p.slew.y *= scale;
  p.fastest.x *= std::sqrt(scale);
  p.fastest.y *= std::sqrt(scale);
  return p;
}

/// [m] Sideways displacement of a pendulum of height `z` [m] that stands in turn on points at `b` [m] to either side.
double pendulum_sway(double b, double z, double period) {
  MUROSIMF_ASSERT(period > 0);
  return b * (1 - 1 / std::cosh(std::sqrt(gravity / z) * period / 4));
}

double half_distance(const Balance& balance) { return 0.5 * (balance.sole[0].y - balance.sole[1].y); }

/// [m] The center of mass relative to the middle between the soles.
Vec3d above_soles(const Balance& balance) { return balance.center - 0.5 * (balance.sole[0] + balance.sole[1]); }

/// Sway of the hips: the motion of the center of mass is a share of it, since the legs turn below.
double sway_of_masses(const Model& model, const std::array<Leg, 2>& legs, const WalkParameters& p) {
  constexpr double small = 0.01;  // [m]
  const Balance middle = balance_of(model, legs, p), aside = balance_of(model, legs, p, small);
  // A difference quotient: no closed form holds for legs of any order of hinges.
  const double share = (above_soles(aside).y - above_soles(middle).y) / small;
  return pendulum_sway(half_distance(middle), above_soles(middle).z, p.period) / share;
}

/// The servo of the first hinge of the left leg from `first` on that turns about an axis like `along`; null if there is none.
const Servo* servo_about(const Model& model, const Leg& leg, std::size_t first, const Vec3d& along) {
  constexpr double like = 0.7;  // [1]
  MUROSIMF_ASSERT(std::abs(norm(along) - 1) < 1e-6);
  const std::vector<double> zero(leg.joints.size());
  const ChainPose pose = pose_of(leg.chain, zero);
  for (std::size_t i = first; i < zero.size(); ++i) {
    if (std::abs(dot(pose.axis[i], along)) >= like) return model.find(properties::servo, leg.joints[i]);
  }
  return nullptr;
}

/// [m] Largest distance of the center of mass from the ankles, to front or back, that needs little torque there.
double reach_of_ankles(const Model& model, const std::array<Leg, 2>& legs, double mass) {
  constexpr double share = 0.2;  // [1] of the torque of one ankle; steps need the rest
  const Servo* ankle = servo_about(model, legs[0], legs[0].knee + 1, {0, 1, 0});
  if (!ankle || !(ankle->stall_torque > 0)) return std::numeric_limits<double>::infinity();
  return share * ankle->stall_torque / (mass * gravity);
}

/// Moves the center of mass over the middle of the soles, as far as the ankles hold it there.
void center(const Model& model, const std::array<Leg, 2>& legs, WalkParameters& p) {
  constexpr int rounds = 4;  // the legs have mass as well: each round moves it less
  for (int i = 0; i < rounds; ++i) {
    const Balance balance = balance_of(model, legs, p);
    const double hips = 0.5 * (rotation_y(p.pitch) * (legs[0].hip + legs[1].hip)).x;
    const double ankles = hips - p.setback;
    const double most = reach_of_ankles(model, legs, balance.mass);
    const double wanted = std::clamp(0.5 * (balance.sole[0].x + balance.sole[1].x) - ankles, -most, most);
    p.setback += wanted - (balance.center.x - ankles);
  }
}

/// [rad] Angle by which the swinging side sinks because the servo of the standing hip yields.
double droop_of(const Model& model, const std::array<Leg, 2>& legs, const Balance& balance) {
  const Servo* hip = servo_about(model, legs[0], 0, {1, 0, 0});
  if (!hip || !(hip->position_gain > 0)) return 0;
  return balance.mass * gravity * half_distance(balance) / hip->position_gain;
}

void lift_over_droop(const Model& model, const std::array<Leg, 2>& legs, WalkParameters& p) {
  constexpr double clearance = 0.045;  // [1] of the leg's length
  constexpr double most_roll = 0.06;   // [rad]
  const Balance balance = balance_of(model, legs, p);
  const double droop = droop_of(model, legs, balance);
  p.hip_roll = std::min(droop, most_roll);
  p.lift = std::min(p.lift, clearance * leg_length(legs) + 2 * half_distance(balance) * droop);
}

}  // namespace

WalkParameters seeded_parameters(const std::array<Leg, 2>& legs) {
  WalkParameters p = scaled_by_length(legs);
  fit_splay(legs, p);
  fit_to_reach(legs, p);
  p.sway = pendulum_sway(0.5 * (legs[0].hip.y - legs[1].hip.y), 1.072 * p.hip_height, p.period);
  return p;
}

WalkParameters walk_parameters(const Model& model, const OptionValues& given) {
  const std::array<Leg, 2>& legs = legs_of(model);
  OptionValues all = given;
  if (const OptionValues* own = model.find(properties::given_walk, 0)) all.insert(own->begin(), own->end());
  WalkParameters p = scaled_by_length(legs);
  p.period *= quicker;
  p.lead = 0;
  // Before and after: what is derived from the numbers uses those that are given, and does not replace them.
  apply_walk_options(all, p);
  if (!all.contains("setback")) center(model, legs, p);
  lift_over_droop(model, legs, p);
  apply_walk_options(all, p);
  if (!all.contains("splay")) fit_splay(legs, p);
  fit_to_reach(legs, p);
  const auto sway = [&](const WalkParameters& now) {
    return all.contains("sway") ? now.sway : sway_of_masses(model, legs, now);
  };
  p.sway = sway(p);
  fit_to_rates(model, legs, sway, p);
  MUROSIMF_ASSERT(p.period > 0);
  return p;
}

double hip_droop(const Model& model) {
  const std::array<Leg, 2>& legs = legs_of(model);
  return droop_of(model, legs, balance_of(model, legs, seeded_parameters(model)));
}

WalkParameters seeded_parameters(const Model& model) {
  return *model.derived().get<WalkParameters>("seeded", [&] { return walk_parameters(model, {}); });
}

}  // namespace murosimf::locomotion
