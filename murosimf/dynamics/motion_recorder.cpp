#include "murosimf/dynamics/motion_recorder.h"

#include <algorithm>
#include <cmath>

#include "murosimf/math/assert.h"
#include "murosimf/multibody/mass.h"

namespace murosimf::dynamics {
namespace {

/// The law finds its points anew in every step; 32 per foot are more than a box has.
constexpr std::size_t most_grips = 32;

}  // namespace

static void state(StateArchive& archive, MotionSample& sample) {
  auto& [time, base, center, pitch, roll, rate, clearance, slip, full_duty] = sample;
  archive(time, base, center, pitch, roll, rate, clearance, slip, full_duty);
}

std::int64_t steps_per_sample(Duration period) {
  const double steps = 1 / (MotionRecorder::samples_per_second * seconds(period));
  MUROSIMF_ASSERT(period > Duration{});
  return std::max<std::int64_t>(1, std::llround(steps));
}

MotionRecorder::MotionRecorder(Setup& setup, const MotionRecorderOptions& options)
    : model_(setup.model()),
      stride_(steps_per_sample(setup.period())),
      start_(from_seconds(options.start)),
      r_(setup.read(properties::position)),
      v_(setup.read(properties::linear_velocity)),
      w_(setup.read(properties::angular_velocity)),
      R_(setup.read(properties::orientation)) {
  feet_ = feet_of(model_);
  if (feet_.size() > 2) feet_.resize(2);
  record_.soles = feet_.size();
  if (setup.entity().find(collision::contacts)) contacts_ = &setup.read(collision::contacts)[0];
  if (setup.entity().find(properties::joint_torque)) {
    torque_ = setup.read(properties::joint_torque);
    for (const int joint : model_.joints()) record_.joints.push_back(model_.objects()[joint].name);
    torque_sum_.resize(record_.joints.size());
  }
  if (options.servos) {
    q_ = setup.read(properties::joint_position);
    target_ = setup.input(properties::joint_target, 0);
    find_servos(model_);
  }
  const auto samples = static_cast<std::size_t>(options.longest * samples_per_second) + 2;
  // memory is reserved here: step() must not allocate in the middle of a run
  record_.samples.reserve(samples);
  record_.torques.reserve(samples * record_.joints.size());
  for (std::size_t i = 0; i < 2; ++i) {
    grips_[i].reserve(most_grips);
    new_grips_[i].reserve(most_grips);
  }
}

void MotionRecorder::find_servos(const Model& model) {
  for (const int object : model.having(properties::servo)) {
    const Servo& servo = *model.find(properties::servo, object);
    const bool can_saturate = servo.stall_torque > 0 && servo.position_gain > 0;
    // the error at which a P controller requests its whole duty
    const double full_at = can_saturate ? servo.duty_limit * servo.stall_torque / servo.position_gain : 1e300;
    servos_.push_back({object, full_at, servo.torque_limit});
  }
}

void MotionRecorder::initialize() { take_sample(start_); }

void MotionRecorder::state(StateArchive& archive) {
  archive(record_.samples, record_.torques, record_.full_duty);
  archive(grips_[0], grips_[1], torque_sum_, steps_, full_steps_, slip_, full_);
}

void MotionRecorder::step(const Instant& instant) noexcept {
  ++steps_;
  MUROSIMF_ASSERT(stride_ >= 1);
  watch_servos();
  for (std::size_t i = 0; i < torque_sum_.size(); ++i) torque_sum_[i] += torque_[model_.joints()[i]];
  if (steps_ % stride_ == 0) take_sample(instant.now + instant.period);
}

void MotionRecorder::take_sample(Duration now) noexcept {
  MotionSample sample;
  sample.time = seconds(now);
  sample.base = r_[0];
  sample.center = multibody::common_body<double>(model_.tree(), r_, R_, v_, w_).center;
  const Vec3d up = transposed_times(R_[0], Vec3d{0, 0, 1});
  sample.pitch = std::atan2(-up.x, up.z);
  sample.roll = std::asin(std::clamp(up.y, -1.0, 1.0));
  sample.rate = transposed_times(R_[0], w_[0]);
  for (std::size_t i = 0; i < feet_.size(); ++i) {
    sample.clearance[i] = clearance(feet_[i]);
    MUROSIMF_ASSERT(i < sample.clearance.size());
    slip_ += slip(i);
  }
  sample.slip = slip_;
  sample.full_duty = full_;
  full_ = false;
  record_.samples.push_back(sample);
  take_torques();
  MUROSIMF_ASSERT(record_.torques.size() == record_.samples.size() * record_.joints.size());
}

void MotionRecorder::take_torques() noexcept {
  const double steps = steps_ > 0 ? static_cast<double>(stride_) : 1;  // at the start there is no step to average over
  for (double& sum : torque_sum_) {
    record_.torques.push_back(sum / steps);
    sum = 0;
  }
}

void MotionRecorder::watch_servos() noexcept {
  const bool full = std::any_of(servos_.begin(), servos_.end(), [&](const Servoed& servo) {
    return std::abs(target_[servo.object] - q_[servo.object]) >= servo.full_at ||
           (servo.limit > 0 && std::abs(torque_[servo.object]) >= 0.999 * servo.limit);
  });
  full_ = full_ || full;
  full_steps_ += full ? 1 : 0;
  record_.full_duty = static_cast<double>(full_steps_) / static_cast<double>(steps_);
}

double MotionRecorder::clearance(const Foot& foot) const noexcept {
  return lowest_corner(foot.sole, r_[foot.object], R_[foot.object]);
}

double MotionRecorder::slip(std::size_t foot) noexcept {
  MUROSIMF_ASSERT(foot < feet_.size());
  if (!contacts_) return 0;
  auto& now = new_grips_[foot];
  now.clear();
  for (const collision::ContactPoint& point : contacts_->points) {
    const double load = dot(point.force, point.normal);
    const bool of_this_foot = belongs_to(model_, feet_[foot], point.object);
    if (of_this_foot && load > 0 && now.size() < most_grips) now.push_back({point.feature, point.point, load});
  }
  double way = 0, load = 0;
  for (const Grip& grip : now) {
    for (const Grip& before : grips_[foot]) {
      // the same point of the same shape: its motion is slip
      if (before.feature != grip.feature) continue;
      const Vec3d moved = grip.point - before.point;
      way += grip.load * std::hypot(moved.x, moved.y);
      load += grip.load;
    }
  }
  std::swap(grips_[foot], now);
  return load > 0 ? way / load : 0;
}

}  // namespace murosimf::dynamics
