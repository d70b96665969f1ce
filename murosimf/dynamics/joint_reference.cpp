#include "murosimf/dynamics/joint_reference.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"

namespace murosimf::dynamics {
namespace {

constexpr double offset_fading_time = 0.1;  // [s] time constant of a joint's offset from its reference after a takeover
constexpr double catch_up_time = 1.0;       // [s] during which joints with an offset are no faster than their servos
constexpr double slowest_share = 0.1;       // [1] of a servo's no-load rate, at any load

constexpr ReferenceEntry reference_entries[] = {
    {"filter", "a critically damped filter follows the target", ReferenceKind::filter},
    {"linear", "at constant rate, in one control cycle (paper 4.3)", ReferenceKind::linear},
    {"exact", "the target is the position (paper 4.1, 4.2)", ReferenceKind::exact},
};

/// Value of properties::joint_reference_kind; 0 and NaN are none.
double number_of(ReferenceKind kind) { return 1 + static_cast<int>(kind); }

/// Ranges of targets, by object: ranges of joints, and the target ranges of those that follow positions.
std::vector<MimicJoints::Range> target_ranges(const Model& model, const MimicJoints& coupled,
                                              const VelocityJoints& turning) {
  std::vector<MimicJoints::Range> ranges;
  for (int i = 0; i < model.size(); ++i) {
    ranges.push_back(coupled.range(i));
    const Vec3d* held = model.find(properties::joint_target_range, i);
    if (!held || turning.contains(i)) continue;
    auto& [lowest, highest] = ranges.back();
    lowest = std::clamp(held->x, lowest, highest);
    highest = std::clamp(held->y, lowest, highest);
  }
  return ranges;
}

/// The rest of an offset [rad | m] after dt [s]; implicit Euler.
double faded(double offset, double dt) {
  constexpr double nothing = 1e-9;  // below it the offset is exactly 0, so that it leaves the state hash
  return std::abs(offset) > nothing ? offset / (1 + dt / offset_fading_time) : 0;
}

}  // namespace

std::span<const ReferenceEntry> joint_references() { return reference_entries; }

JointReference::JointReference(Setup& setup, const JointReferenceOptions& options)
    : options_(options),
      turning_(setup),
      coupled_(setup.model()),
      of_loops_(joints_of_loops(setup.model())),
      target_(setup.input(properties::joint_target, 0.0)),
      offset_(setup.write(properties::joint_offset)),
      kind_(setup.write(properties::joint_reference_kind)[0]),
      catch_up_time_(setup.write(properties::catch_up_time)[0]),
      target_range_(target_ranges(setup.model(), coupled_, turning_)),
      leader_(target_.size()),
      ratio_(target_.size()) {
  // a joint that follows none is its own leader
  std::iota(leader_.begin(), leader_.end(), 0);
  for (const auto& pair : coupled_.pairs()) {
    leader_[pair.follower] = pair.leader;
    ratio_[pair.follower] = pair.ratio;
  }
  for (int i = 0; i < setup.model().size(); ++i) motors_.push_back(motor_of(setup.model(), i));
  limited_ = std::ranges::any_of(setup.model().joints(), [&](int i) { return std::isfinite(coupled_.rate_limit(i)); });
  if (options_.kind == ReferenceKind::linear) cycle_target_ = setup.write(properties::cycle_target);
}

void JointReference::initialize(PoseColumns& columns) noexcept {
  std::fill(offset_.begin(), offset_.end(), 0.0);
  catch_up_time_ = 0;
  kind_ = number_of(options_.kind);
  for (std::size_t i = 0; i < target_.size(); ++i) {
    const auto& [lowest, highest] = coupled_.range(static_cast<int>(i));
    columns.q[i] = std::clamp(target_[i], lowest, highest) + offset_[i];
    columns.qd[i] = 0;
    if (!cycle_target_.empty()) cycle_target_[i] = target_[i];
  }
  coupled_.follow(columns.q, columns.qd);
  of_loops_.assemble(columns.q);
}

void JointReference::take_over(const PoseColumns& columns) noexcept {
  const double before = std::exchange(kind_, number_of(options_.kind));
  if (before == kind_) return;
  std::fill(offset_.begin(), offset_.end(), 0.0);
  // servos let joints sag under load: catching up at once would throw the robot up
  const bool after_servos = !(before >= 1);  // a new column may hold NaN
  catch_up_time_ = after_servos && options_.carries ? catch_up_time : 0;
  for (const int i : turning_.others()) {
    if (leader_[i] == i) offset_[i] = offset_of(columns, i);
    if (!std::isfinite(offset_[i])) offset_[i] = 0;
    if (!cycle_target_.empty()) cycle_target_[i] = limited_target(i);
  }
}

MUROSIMF_INLINE double JointReference::limited_target(int joint) const noexcept {
  MUROSIMF_ASSERT(joint >= 0 && static_cast<std::size_t>(joint) < target_range_.size());
  const auto& [lowest, highest] = target_range_[static_cast<std::size_t>(joint)];
  return std::clamp(target_[joint], lowest, highest);
}

double JointReference::offset_of(const PoseColumns& columns, int joint) const noexcept {
  const double lag = options_.kind == ReferenceKind::filter ? 2 / options_.filter_frequency : 0;  // [s]
  // with this lag the filter's acceleration is 0 at the takeover
  return columns.q[joint] + lag * columns.qd[joint] - limited_target(joint);
}

MUROSIMF_INLINE double JointReference::limited_rate(int joint, double rate) const noexcept {
  if (!limited_) return rate;
  const double most = coupled_.rate_limit(joint);
  MUROSIMF_ASSERT(most >= 0);
  return std::clamp(rate, -most, most);
}

JointReference::Motor JointReference::motor_of(const Model& model, int joint) {
  Motor motor;
  const Servo* servo = model.find(properties::servo, joint);
  if (servo && servo->no_load_speed > 0) motor.no_load_rate = servo->duty_limit * servo->no_load_speed;
  if (servo && servo->stall_torque > 0) motor.stall_torque = servo->duty_limit * servo->stall_torque;
  return motor;
}

/// `now`: the joint's rate at the beginning of the step.
MUROSIMF_INLINE double JointReference::largest_rate(int joint, double now) const noexcept {
  const double most = coupled_.rate_limit(joint);
  if (!catches_up()) return most;
  const Motor& motor = motors_[static_cast<std::size_t>(joint)];
  const double torque = torque_need_.empty() ? 0 : torque_need_[joint];
  const double load = std::max(0.0, torque * (now < 0 ? -1 : 1)) / motor.stall_torque;
  return std::min(most, std::max(motor.no_load_rate * std::max(slowest_share, 1 - load), std::abs(now)));
}

/// The same for a joint that may be catching up with its reference.
MUROSIMF_INLINE double JointReference::limited_rate(int joint, double rate, double now) const noexcept {
  if (!catches_up()) return limited_rate(joint, rate);
  const double most = largest_rate(joint, now);
  return std::clamp(rate, -most, most);
}

MUROSIMF_INLINE double JointReference::target(int joint) const noexcept {
  return limited_target(joint) + offset_[joint];
}

void JointReference::count_down(double dt) noexcept {
  MUROSIMF_ASSERT(dt > 0);
  if (catch_up_time_ > 0) catch_up_time_ = std::max(0.0, catch_up_time_ - dt);
}

void JointReference::fade_offsets(double dt) noexcept {
  count_down(dt);
  for (const int i : turning_.others()) {
    if (offset_[i] != 0) offset_[i] = faded(offset_[i], dt);
  }
}

void JointReference::stop_at_limits(PoseColumns& columns) const noexcept {
  for (const int i : columns.model.joints()) {
    const auto& [lowest, highest] = coupled_.range(i);
    MUROSIMF_ASSERT(lowest <= highest);
    if (limited_) columns.qd[i] = limited_rate(i, columns.qd[i]);
    if (columns.q[i] >= lowest && columns.q[i] <= highest) continue;
    columns.q[i] = std::clamp(columns.q[i], lowest, highest);
    columns.qd[i] = 0;
  }
  coupled_.follow(columns.q, columns.qd);  // last: leaders may have been stopped
}

bool JointReference::is_sane(const PoseColumns& columns) const noexcept {
  constexpr double largest = 1e4;  // [rad | m] beyond it sines lose their precision
  double sum = 0;
  for (const int i : columns.model.joints()) sum += std::abs(target_[i]) + std::abs(columns.q[i]);
  for (const int i : turning_.joints()) sum += std::abs(turning_.target(i));
  return sum < largest;  // false for NaN
}

bool JointReference::advance(PoseColumns& columns, double dt) noexcept {
  MUROSIMF_ASSERT(dt > 0 && columns.q.size() == target_.size());
  if (!is_sane(columns)) return false;
  // before anything moves: passive joints continue on their present branch
  of_loops_.keep(columns.q);
  switch (options_.kind) {
    case ReferenceKind::filter:
      fade_offsets(dt);
      filter(columns, dt);
      break;
    case ReferenceKind::linear:
      count_down(dt);
      linear(columns, dt);
      break;
    case ReferenceKind::exact:
      fade_offsets(dt);
      follow_exactly(columns, dt);
      break;
  }
  turn(columns, dt);
  stop_at_limits(columns);
  of_loops_.follow(columns.q, columns.qd);
  return true;
}

double JointReference::acceleration(const PoseColumns& columns, int joint) const noexcept {
  const double wf = options_.filter_frequency;
  MUROSIMF_ASSERT(joint >= 0 && static_cast<std::size_t>(joint) < leader_.size());
  const int leader = leader_[joint];
  if (leader != joint) return ratio_[joint] * acceleration(columns, leader);
  const double qd = columns.qd[joint];
  const double qdd = turning_.contains(joint) ? wf * (turning_.target(joint) - qd)
                                              : wf * wf * (target(joint) - columns.q[joint]) - 2 * wf * qd;
  return std::abs(qd) >= largest_rate(joint, 0) && qd * qdd > 0 ? 0 : qdd;
}

/// Explicit methods need a right side without jumps.
void JointReference::check(Integrator integrator) const {
  if (integrator == Integrator::rk4 && !of_loops_.empty()) {
    throw SetupError("integrator 'rk4' does not go with loops: their joints follow at the end of a step");
  }
  if (integrator == Integrator::rk4 && options_.kind != ReferenceKind::filter) {
    throw SetupError("integrator 'rk4' needs the joint reference 'filter': the others jump from rate to rate");
  }
}

void JointReference::filter(PoseColumns& columns, double dt) noexcept {
  const double wf = options_.filter_frequency;
  // implicit in q and qd: stable for any product of step and frequency
  const double inverse = 1.0 / (1 + 2 * wf * dt + wf * wf * dt * dt);
  for (const int i : turning_.others()) {
    double& q = columns.q[i];
    double& qd = columns.qd[i];
    const double rate = qd + dt * (wf * wf * (target(i) - q - dt * qd) - 2 * wf * qd) * inverse;
    qd = limited_rate(i, rate, qd);
    q += dt * qd;
    if (qd != rate) fall_behind(columns, i);
  }
}

void JointReference::follow_exactly(PoseColumns& columns, double dt) noexcept {
  for (const int i : turning_.others()) {
    const double goal = target(i);
    const double rate = (goal - columns.q[i]) / dt, limited = limited_rate(i, rate, columns.qd[i]);
    columns.qd[i] = limited;
    columns.q[i] = limited == rate ? goal : columns.q[i] + dt * limited;
    if (limited != rate) fall_behind(columns, i);
  }
}

/// Adds the distance that a joint with limited rate falls behind to its offset: it needs more time.
void JointReference::fall_behind(const PoseColumns& columns, int joint) noexcept {
  if (catches_up()) offset_[joint] = offset_of(columns, joint);
}

void JointReference::turn(PoseColumns& columns, double dt) const noexcept {
  // implicit Euler of the first-order lag
  const double gain = dt * options_.filter_frequency / (1 + options_.filter_frequency * dt);
  for (const int i : turning_.joints()) {
    columns.qd[i] = limited_rate(i, columns.qd[i] + gain * (turning_.target(i) - columns.qd[i]));
    columns.q[i] += dt * columns.qd[i];
  }
  turning_.wrap(columns.q);
}

void JointReference::linear(PoseColumns& columns, double dt) noexcept {
  for (const int i : turning_.others()) {
    const double goal = limited_target(i);
    double q = columns.q[i] - offset_[i];
    double qd = columns.qd[i] + offset_[i] / offset_fading_time;
    offset_[i] = faded(offset_[i], dt);
    if (goal != cycle_target_[i]) {
      cycle_target_[i] = goal;
      qd = limited_rate(i, (goal - q) / options_.control_period);
    } else if (std::abs(goal - q) < 1e-12) {  // arrived, up to rounding
      qd = 0;
    }
    const double rest = goal - q;
    // the last step of a cycle ends exactly at the goal, not one rounding beside it
    q = std::abs(rest) <= std::abs(qd) * dt * (1 + 1e-9) ? goal : q + dt * qd;
    qd -= offset_[i] / offset_fading_time;
    if (const double limited = limited_rate(i, qd, columns.qd[i]); limited != qd && catches_up()) {
      offset_[i] = columns.q[i] + dt * limited - q;
      qd = limited;
    }
    columns.q[i] = q + offset_[i];
    columns.qd[i] = qd;
  }
}

}  // namespace murosimf::dynamics
