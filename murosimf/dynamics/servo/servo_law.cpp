#include "murosimf/dynamics/servo/servo_law.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/math/lanes.h"
#include "murosimf/model/error.h"
#include "murosimf/multibody/servo/gear_friction.h"

namespace murosimf::dynamics {
namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();  // [N m]

/// Rest of a motor's torque [N m] behind the gear, while it drives a load at a rate [rad/s].
double behind_gear(const Servo& servo, double torque, double qd) {
  // friction depends on the load, which is the torque less the friction: the first iteration is near enough for a report
  const double load = -torque;
  const double lost = multibody::dry_friction(servo.friction, qd, torque, load) + servo.friction.viscous * std::abs(qd);
  return std::max(0.0, torque - lost);
}

class IdealPd final : public ServoLaw {
 public:
  explicit IdealPd(const Servo& servo)
      : servo_(servo),
        by_rate_(follows_rate(servo)),
        lowest_(servo.stall_torque > 0 ? servo.lowest_share * servo.stall_torque : -no_limit),
        highest_(servo.stall_torque > 0 ? servo.highest_share * servo.stall_torque : no_limit) {}

  [[nodiscard]] MotorTorque torque(const MotorInput& in, double dt) const noexcept override {
    MUROSIMF_ASSERT(dt >= 0);
    if (in.enabled == 0) return {};
    const double kp = servo_.position_gain * in.gain, kd = servo_.velocity_gain + in.damping;
    const double low = std::max(lowest_, -in.limit), high = std::max(low, std::min(highest_, in.limit));
    // the software's limit narrows the servo's own; `high` is at least `low`, as std::clamp requires
    const double error = by_rate_ ? 0 : position_error(in);
    // within the dead band the spring is slack
    const double stiffness = error == 0 && servo_.dead_band > 0 ? 0 : kp;
    const double pd = by_rate_ ? kd * (in.target - in.rate) : kp * error - kd * (in.rate - in.target_rate);
    const double wanted = pd + in.feed_forward;
    const multibody::TorqueLine<double> free{wanted - dt * stiffness * in.rate, dt * kd + dt * dt * stiffness};
    return {std::clamp(wanted, low, high), free, {high}, {low}};
  }
  [[nodiscard]] double available(double qd, double direction) const noexcept override {
    return behind_gear(servo_, std::max(0.0, direction > 0 ? highest_ : -lowest_), qd);
  }

 private:
  [[nodiscard]] double position_error(const MotorInput& in) const noexcept {
    return multibody::position_error(servo_.encoder_step, servo_.dead_band, in.target, in.q);
  }

  Servo servo_;
  bool by_rate_;
  double lowest_, highest_;  // [N m]
};

class DcMotor final : public ServoLaw {
 public:
  explicit DcMotor(const Servo& servo) : servo_(servo), motor_(servo) {}

  [[nodiscard]] MotorTorque torque(const MotorInput& in, double dt) const noexcept override {
    MUROSIMF_ASSERT(dt >= 0);
    return multibody::motor_torque(motor_, in, dt);
  }
  [[nodiscard]] multibody::MotorTorque<Pack8> torque_in_lanes(const multibody::MotorInput<Pack8>& in,
                                                              double dt) const noexcept override {
    return multibody::motor_torque(motor_, in, dt);
  }
  [[nodiscard]] double available(double qd, double direction) const noexcept override {
    MUROSIMF_ASSERT(direction == 1.0 || direction == -1.0);
    return behind_gear(servo_, std::min(motor_.torque_limit, motor_.most - direction * motor_.line * qd), qd);
  }

 private:
  Servo servo_;
  multibody::ServoMotor motor_;
};

template <class Law>
std::unique_ptr<ServoLaw> make(const Servo& servo) {
  return std::make_unique<Law>(servo);
}

constexpr std::array entries{
    ServoLawEntry{"ideal_pd", "torque proportional to error and rate, with a limit; no motor", make<IdealPd>},
    ServoLawEntry{"dc_motor", "firmware P gain, duty and current limit, speed-torque line, supply and heat",
                  make<DcMotor>},
};

}  // namespace

multibody::MotorTorque<Pack8> ServoLaw::torque_in_lanes(const multibody::MotorInput<Pack8>& input,
                                                        double dt) const noexcept {
  multibody::MotorTorque<Pack8> result;
  MUROSIMF_ASSERT(dt >= 0);
  for (int lane = 0; lane < Pack8::lanes; ++lane) {
    set_lane(result, lane, torque(lane_of(input, lane), dt));
  }
  return result;
}

bool follows_rate(const Servo& servo) {
  return servo.law == "ideal_pd" && servo.position_gain == 0 && servo.velocity_gain > 0;
}

Servo with_law(const Servo& servo, std::string_view law) {
  Servo other = servo;
  if (law.empty() || law == servo.law) return other;
  other.law = law;
  if (law == "ideal_pd" && servo.velocity_gain == 0 && servo.no_load_speed > 0) {
    // the slope of the speed-torque line
    other.velocity_gain = servo.stall_torque / servo.no_load_speed;
  }
  return other;
}

std::span<const ServoLawEntry> servo_laws() { return entries; }

std::unique_ptr<ServoLaw> make_servo_law(const Servo& servo) {
  std::vector<std::string_view> names;
  for (const ServoLawEntry& entry : entries) {
    names.push_back(entry.name);
    if (entry.name != servo.law) continue;
    if (servo.law == "dc_motor" && !(servo.stall_torque > 0 && servo.no_load_speed > 0)) {
      throw SetupError(
          fmt::format("servo '{}' cannot be a dc_motor: it needs a positive stall_torque and no_load_speed",
                      servo.type));
    }
    return entry.make(servo);
  }
  throw SetupError(fmt::format("servo '{}': {}", servo.type, unknown_name("servo law", servo.law, names)));
}

}  // namespace murosimf::dynamics
