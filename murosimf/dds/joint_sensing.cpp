#include "murosimf/dds/joint_sensing.h"

#include <algorithm>
#include <cmath>

namespace murosimf::dds {
namespace {

float single(double value) { return static_cast<float>(value); }
/// Levels without torques have none: NaN.
float single_or_zero(double value) { return std::isfinite(value) ? single(value) : 0.0F; }

}  // namespace

JointSensing::JointSensing(double period, control_software::RobotPort& port, std::vector<std::size_t> places)
    : period_(period),
      places_(std::move(places)),
      position_(port.signal("joint.position")),
      velocity_(port.signal("joint.velocity")),
      torque_(port.signal("joint.torque")),
      motors_(places_.size()),
      rates_(places_.size()) {}

void JointSensing::restart() { std::ranges::fill(rates_, 0.0); }

void JointSensing::follow() {
  constexpr std::uint8_t cool = 25;  // [C] of servos whose heat is not simulated
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const std::size_t place = places_[i];
    const double rate = velocity_->values[place];
    motors_[i] = {.q = single(position_->values[place]),
                  .dq = single(rate),
                  .ddq = single((rate - rates_[i]) / period_),
                  .tau = single_or_zero(torque_->values[place]),
                  .temperature = cool};
    rates_[i] = rate;
  }
}

}  // namespace murosimf::dds
