#include "murosimf/locomotion/walk_senses.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/multibody/kinematics.h"
#include "murosimf/multibody/mass.h"
#include "murosimf/sensors/reading.h"

namespace murosimf::locomotion {
namespace {

constexpr double least_gravity = 0.1;  // [m/s^2] below, specific force does not determine up

std::span<const double> inertial(Setup& setup, const char* output) {
  return with_context("a robot that balances needs a sensor 'imu' with gyroscope and accelerometer",
                      [&] { return sensors::read_output(setup, output); });
}

ChainPose foot_of(const Leg& leg, std::span<const double> q) noexcept {
  std::array<double, most_hinges> angles{};
  for (std::size_t i = 0; i < leg.joints.size(); ++i) {
    MUROSIMF_ASSERT(static_cast<std::size_t>(leg.joints[i]) < q.size());
    angles[i] = q[leg.joints[i]];
  }
  return pose_of(leg.chain, std::span(angles).first(leg.joints.size()));
}

Vec3d ankle_of(const Leg& leg, std::span<const double> q) noexcept { return foot_of(leg, q).tip; }

}  // namespace

Mat3d level_axes(const AttitudeFilter& attitude) noexcept {
  return rotation_y(attitude.pitch()) * rotation_x(attitude.roll());
}

WalkSenses::WalkSenses(Setup& setup, const std::array<Leg, 2>& legs)
    : legs_(legs),
      model_(setup.model()),
      gyroscope_(inertial(setup, "imu.gyroscope")),
      accelerometer_(inertial(setup, "imu.accelerometer")),
      gravity_(std::max(norm(setup.world().gravity), least_gravity)),
      q_(static_cast<std::size_t>(setup.model().size())),
      r_(q_.size()),
      rest_(q_.size()),
      R_(q_.size()),
      odometry_(setup.write(properties::odometry)[0]) {
  const sensors::SensorInfo& imu = *sensors::read_reading(setup, "imu").info;
  const FixedObject place = model_.placement(imu.frame.empty() ? 0 : model_.object_index(imu.frame));
  mounting_ = model_.tree().links[place.link].object;
  turn_ = place.turn * imu.orientation;
  find_encoders(setup);
  for (int link = place.link; model_.tree().links[link].parent >= 0; link = model_.tree().links[link].parent) {
    if (model_.tree().links[link].kind == LinkKind::revolute) waist_.push_back(model_.tree().links[link]);
  }
  if (waist_.size() > most_waist)
    throw SetupError(
        fmt::format("{} hinges turn the sensor 'imu' against the base; a robot that balances has at most {}",
                    waist_.size(), most_waist));
  for (const Link& hinge : waist_) require(hinge.object);
  for (const Leg& leg : legs_) {
    for (const int joint : leg.joints) require(joint);
  }
}

void WalkSenses::find_encoders(Setup& setup) {
  for (const sensors::Reading* found : sensors::readings_of(setup.entity())) {
    if (found->info->type != "joint_position") continue;
    const sensors::Reading& reading = sensors::read_reading(setup, found->info->name);
    const sensors::Output& output = reading.info->outputs.front();
    MUROSIMF_ASSERT(output.labels.size() <= reading.values.size());
    for (std::size_t i = 0; i < output.labels.size(); ++i) {
      const int joint = model_.object_index(output.labels[i]);
      if (std::ranges::find(encoders_, joint, &Encoder::joint) != encoders_.end()) continue;
      encoders_.push_back({reading.values.data() + i, joint});
    }
  }
}

void WalkSenses::require(int joint) const {
  if (std::ranges::find(encoders_, joint, &Encoder::joint) != encoders_.end()) return;
  throw SetupError(fmt::format(
      "a robot that balances needs the position of joint '{}', which no sensor of the type joint_position reports",
      model_.objects()[joint].name));
}

void WalkSenses::initialize(std::size_t standing, GaitState& state) noexcept {
  state = {};
  odometry_ = {};
  std::ranges::fill(q_, 0.0);
  change_foot(standing, state);
}

void WalkSenses::read_joints() noexcept {
  for (const Encoder& encoder : encoders_) q_[encoder.joint] = std::isnan(*encoder.value) ? 0 : *encoder.value;
}

/// [rad/s] Rate of the inertial sensor's link against the base, axes of the base.
Vec3d WalkSenses::waist_rate(double dt, double smoothing, GaitState& state) noexcept {
  MUROSIMF_ASSERT(dt > 0 && waist_.size() <= most_waist);
  Vec3d turned;  // [rad] since the previous cycle
  for (std::size_t i = 0; i < waist_.size(); ++i) {
    const double angle = q_[waist_[i].object];
    turned += (angle - std::exchange(state.waist[i], angle)) * (R_[waist_[i].object] * waist_[i].axis);
  }
  if (state.cycles > 0) state.waist_rate += (dt / (smoothing + dt)) * ((1 / dt) * turned - state.waist_rate);
  return state.waist_rate;
}

void WalkSenses::follow(double dt, std::size_t standing, const Numbers& numbers, GaitState& state) noexcept {
  MUROSIMF_ASSERT(dt > 0 && standing < 2 && numbers.omega > 0 && numbers.smoothing >= 0);
  read_joints();
  multibody::poses<double>(model_.tree(), q_, r_, R_);
  const Mat3d to_base = R_[mounting_] * turn_;
  const Vec3d measured = to_base * sensors::vector_of(gyroscope_), force = to_base * sensors::vector_of(accelerometer_);
  if (state.cycles == 0) state.attitude.start(force);
  const Vec3d gyroscope = measured - waist_rate(dt, numbers.smoothing, state);
  const bool quiet = norm(measured - state.attitude.bias) < numbers.still_rate;
  state.still = quiet ? state.still + dt : 0;
  constexpr double settled = 0.3;  // [s]
  state.attitude.follow(dt, gyroscope, force, gravity_, {}, state.still > settled);
  rate_ = gyroscope - state.attitude.bias;

  const Vec3d center = multibody::common_body<double>(model_.tree(), r_, R_, rest_, rest_).center;
  const double share = dt / (numbers.smoothing + dt);
  for (std::size_t side = 0; side < 2; ++side) {
    // Differences of forward kinematics: they see motion of the joints alone, and w x c adds that of the base.
    const Vec3d from_ankle = center - ankle_of(legs_[side], q_);
    if (state.cycles > 0)
      state.center_rate[side] += share * ((1 / dt) * (from_ankle - state.center[side]) - state.center_rate[side]);
    state.center[side] = from_ankle;
  }
  const Mat3d R = level_axes(state.attitude);
  const Vec3d& c = state.center[standing];
  const Vec3d xi = R * (c + (1 / numbers.omega) * (cross(rate_, c) + state.center_rate[standing]));
  const double outward = standing == 0 ? 1 : -1;
  state.signals = {xi.x,   outward * xi.y, state.attitude.pitch(), outward * state.attitude.roll(), outward * rate_.x,
                   rate_.y};
  state.foot.z += dt * (R * rate_).z;
  if (state.cycles == 0) change_foot(standing, state);  // the first cycle that has positions of the joints
  const Vec3d step = flat_step(standing, state);
  odometry_ = {state.foot.x - step.x, state.foot.y - step.y, state.foot.z};
  state.cycles = std::min(state.cycles + 1, 2.0);
}

double WalkSenses::sole_pitch(std::size_t side, const GaitState& state) const noexcept {
  MUROSIMF_ASSERT(side < 2);
  const Vec3d forward = level_axes(state.attitude) * (foot_of(legs_[side], q_).sole * Vec3d{1, 0, 0});
  return std::atan2(-forward.z, std::hypot(forward.x, forward.y));
}

/// [m] From the base to the ankle, axes of the odometry.
Vec3d WalkSenses::flat_step(std::size_t standing, const GaitState& state) const noexcept {
  MUROSIMF_ASSERT(standing < 2);
  return rotation_z(state.foot.z) * (level_axes(state.attitude) * ankle_of(legs_[standing], q_));
}

void WalkSenses::change_foot(std::size_t standing, GaitState& state) const noexcept {
  const Vec3d step = flat_step(standing, state);
  state.foot = {odometry_.x + step.x, odometry_.y + step.y, state.foot.z};
}

}  // namespace murosimf::locomotion
