#include "murosimf/motion/servo_law.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "murosimf/model/error.h"
#include "murosimf/multibody/joint_friction.h"

namespace murosimf::motion {
namespace {

/// What is left of a motor's torque [N m] behind the gear, while it drives a load at a rate [rad/s].
double behind_gear(const Servo& servo, double torque, double qd) {
  const double load = -torque;  // nearly
  const double lost = multibody::dry_friction(servo.friction, qd, torque, load) + servo.friction.viscous * std::abs(qd);
  return std::max(0.0, torque - lost);
}

class IdealPd final : public ServoLaw {
 public:
  explicit IdealPd(const Servo& servo)
      : servo_(servo),
        by_rate_(follows_rate(servo)),
        limit_(servo.stall_torque > 0 ? servo.stall_torque : std::numeric_limits<double>::infinity()) {}

  [[nodiscard]] JointDrive drive(double target, double q, double qd, double dt) const noexcept override {
    const double kp = servo_.position_gain, kd = servo_.velocity_gain;
    JointDrive drive{by_rate_ ? kd * (target - qd) : kp * (target - q - dt * qd) - kd * qd, dt * kd + dt * dt * kp};
    if (std::abs(drive.torque) > limit_) drive = {std::copysign(limit_, drive.torque), 0};
    return drive;
  }
  [[nodiscard]] double available(double qd, double) const noexcept override { return behind_gear(servo_, limit_, qd); }

 private:
  Servo servo_;
  bool by_rate_;
  double limit_;  // [N m]
};

class DcMotor final : public ServoLaw {
 public:
  explicit DcMotor(const Servo& servo)
      : servo_(servo),
        damping_(servo.stall_torque / servo.no_load_rate),
        duty_limit_(servo.duty_limit * servo.stall_torque),
        torque_limit_(servo.torque_limit > 0 ? servo.torque_limit : std::numeric_limits<double>::infinity()) {}

  [[nodiscard]] JointDrive drive(double target, double q, double qd, double dt) const noexcept override {
    const double kp = servo_.position_gain;
    const double wanted = kp * (target - q - dt * qd);  // torque at rest, which is proportional to the duty
    const double braking = damping_ * qd;
    const double for_current = std::clamp(wanted, braking - torque_limit_, braking + torque_limit_);
    const double duty = std::clamp(for_current, -duty_limit_, duty_limit_);
    JointDrive drive{duty - braking, 0};
    if (duty == wanted) {
      drive.inertia = dt * damping_ + dt * dt * kp;
    } else if (duty != for_current) {
      drive.inertia = dt * damping_;  // full duty: the back-EMF still follows the rate
    }
    return drive;
  }
  [[nodiscard]] double available(double qd, double direction) const noexcept override {
    return behind_gear(servo_, std::min(torque_limit_, duty_limit_ - direction * damping_ * qd), qd);
  }

 private:
  Servo servo_;
  double damping_;       // [N m s/rad] back-EMF
  double duty_limit_;    // [N m] at rest
  double torque_limit_;  // [N m]
};

template <class Law>
std::unique_ptr<ServoLaw> make(const Servo& servo) {
  return std::make_unique<Law>(servo);
}

constexpr std::array entries{
    ServoLawEntry{"ideal_pd", "torque proportional to error and rate, with a limit; no motor", make<IdealPd>},
    ServoLawEntry{"dc_motor", "firmware P gain, duty and current limit, speed-torque line, friction", make<DcMotor>},
};

}  // namespace

bool follows_rate(const Servo& servo) {
  return servo.law == "ideal_pd" && servo.position_gain == 0 && servo.velocity_gain > 0;
}

std::span<const ServoLawEntry> servo_laws() { return entries; }

std::unique_ptr<ServoLaw> make_servo_law(const Servo& servo) {
  std::vector<std::string_view> names;
  for (const ServoLawEntry& entry : entries) {
    names.push_back(entry.name);
    if (entry.name != servo.law) continue;
    if (servo.law == "dc_motor" && !(servo.stall_torque > 0 && servo.no_load_rate > 0)) {
      throw SetupError(fmt::format("servo '{}' cannot be a dc_motor: it needs a positive stall_torque and no_load_rate",
                                   servo.type));
    }
    return entry.make(servo);
  }
  throw SetupError(fmt::format("servo '{}': {}", servo.type, unknown_name("servo law", servo.law, names)));
}

}  // namespace murosimf::motion
