#include "murosimf/locomotion/walk_senses.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/model/error.h"
#include "murosimf/multibody/kinematics.h"
#include "murosimf/multibody/mass.h"
#include "murosimf/sensors/reading.h"

namespace murosimf::locomotion {
namespace {

constexpr double least_gravity = 0.1;  // [m/s^2] below, specific force says nothing of up
constexpr double still_rate = 0.05;    // [rad/s] of a robot that stands

std::span<const double> inertial(Setup& setup, const char* output) {
  return with_context("a robot that balances needs a sensor 'imu' with gyroscope and accelerometer",
                      [&] { return sensors::read_output(setup, output); });
}

/// The first sensor that reports positions of joints.
const sensors::Reading& encoders_of(Setup& setup) {
  for (const sensors::Reading* reading : sensors::readings_of(setup.entity())) {
    if (reading->info->type == "joint_position") return sensors::read_reading(setup, reading->info->name);
  }
  throw SetupError("a robot that balances needs a sensor of the type joint_position for the joints of its legs");
}

Vec3d ankle_of(const Leg& leg, std::span<const double> q) noexcept {
  std::array<double, most_hinges> angles{};
  for (std::size_t i = 0; i < leg.joints.size(); ++i) angles[i] = q[leg.joints[i]];
  return pose_of(leg.chain, std::span(angles).first(leg.joints.size())).tip;
}

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
  const sensors::Reading& encoders = encoders_of(setup);
  const sensors::Output& output = encoders.info->outputs.front();
  for (std::size_t i = 0; i < output.labels.size(); ++i)
    encoders_.push_back({encoders.values.data() + i, model_.object_index(output.labels[i])});
  for (const Leg& leg : legs_) {
    for (const int joint : leg.joints) {
      if (std::ranges::find(encoders_, joint, &Encoder::joint) != encoders_.end()) continue;
      throw SetupError(
          fmt::format("a robot that balances needs the position of joint '{}', which sensor '{}' does not report",
                      model_.objects()[joint].name, encoders.info->name));
    }
  }
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

void WalkSenses::follow(double dt, std::size_t standing, double smoothing, double omega, GaitState& state) noexcept {
  read_joints();
  multibody::poses<double>(model_.tree(), q_, r_, R_);
  const Mat3d to_base = R_[mounting_] * turn_;
  const Vec3d gyroscope = to_base * sensors::vector_of(gyroscope_),
              force = to_base * sensors::vector_of(accelerometer_);
  if (state.cycles == 0) state.attitude.start(force);
  const bool quiet = norm(gyroscope - state.attitude.bias) < still_rate;
  state.still = quiet ? state.still + dt : 0;
  constexpr double settled = 0.3;  // [s]
  state.attitude.follow(dt, gyroscope, force, gravity_, {}, state.still > settled);
  rate_ = gyroscope - state.attitude.bias;

  const Vec3d center = multibody::common_body<double>(model_.tree(), r_, R_, rest_, rest_).center;
  const double share = dt / (smoothing + dt);
  for (std::size_t side = 0; side < 2; ++side) {
    const Vec3d from_ankle = center - ankle_of(legs_[side], q_);
    if (state.cycles > 0)
      state.center_rate[side] += share * ((1 / dt) * (from_ankle - state.center[side]) - state.center_rate[side]);
    state.center[side] = from_ankle;
  }
  const Mat3d R = level_axes(state.attitude);
  const Vec3d& c = state.center[standing];
  const Vec3d xi = R * (c + (1 / omega) * (cross(rate_, c) + state.center_rate[standing]));
  const double outward = standing == 0 ? 1 : -1;
  state.signals = {xi.x,   outward * xi.y, state.attitude.pitch(), outward * state.attitude.roll(), outward * rate_.x,
                   rate_.y};
  state.foot.z += dt * (R * rate_).z;
  const Vec3d step = flat_step(standing, state);
  odometry_ = {state.foot.x - step.x, state.foot.y - step.y, state.foot.z};
  state.cycles = std::min(state.cycles + 1, 2.0);
}

/// [m] From the base to the ankle, axes of the odometry.
Vec3d WalkSenses::flat_step(std::size_t standing, const GaitState& state) const noexcept {
  return rotation_z(state.foot.z) * (level_axes(state.attitude) * ankle_of(legs_[standing], q_));
}

void WalkSenses::change_foot(std::size_t standing, GaitState& state) const noexcept {
  const Vec3d step = flat_step(standing, state);
  state.foot = {odometry_.x + step.x, odometry_.y + step.y, state.foot.z};
}

}  // namespace murosimf::locomotion
