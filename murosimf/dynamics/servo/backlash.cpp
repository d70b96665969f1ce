#include "murosimf/dynamics/servo/backlash.h"

#include <algorithm>
#include <cmath>

#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/dynamics/servo/torque_watch.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"
#include "murosimf/multibody/servo/gear_friction.h"

namespace murosimf::dynamics {

Backlash::Backlash(Setup& setup) : gears_(static_cast<std::size_t>(setup.model().size())) {
  const Model& model = setup.model();
  bool any = false;
  for (const int i : model.having(properties::servo)) {
    const Servo& servo = *model.find(properties::servo, i);
    if (servo.backlash <= 0) continue;
    gears_[i] = {servo.backlash / 2, rotor_inertia(model, i), &servo.friction};
    MUROSIMF_ASSERT(gears_[i].half_play > 0);
    any = true;
  }
  if (!any) return;
  play_ = setup.write(properties::backlash_play);
  rate_ = setup.write(properties::rotor_rate);
  side_ = setup.write(properties::backlash_side);
}

void Backlash::start(std::span<const double> qd) noexcept {
  MUROSIMF_ASSERT(side_.empty() || qd.size() == side_.size());
  for (std::size_t i = 0; i < side_.size(); ++i) {
    play_[i] = side_[i] = 0;
    rate_[i] = gears_[i].half_play > 0 ? qd[i] : 0;
  }
}

void Backlash::follow(int i, double torque, double qd, double dt) noexcept {
  MUROSIMF_ASSERT(at(i) && dt > 0);
  // the torque that the side has transmitted, with the part of the impact that arrived in this step; a pulling side separates
  const double given = torque + gears_[i].inertia * (rate_[i] - qd) / dt;
  rate_[i] = qd;
  if (side_[i] * given < 0) side_[i] = 0;
}

void Backlash::turn(int i, const MotorTorque& motor, double qd, double dt) noexcept {
  MUROSIMF_ASSERT(at(i) && gears_[i].friction && dt > 0);
  const Gear& gear = gears_[i];
  const double viscous = gear.friction->viscous, w = rate_[i];
  const double most = dt * multibody::dry_friction(*gear.friction, w, motor.now, 0.0);
  const auto inertia = [&](const multibody::TorqueLine<double>& line) {
    return gear.inertia + line.inertia + dt * viscous;
  };
  // [kg m^2/s] after the step; dry friction takes up to `most` of it
  const auto momentum = [&](const multibody::TorqueLine<double>& line) {
    const double push = (gear.inertia + line.inertia) * w + dt * line.torque;
    return std::abs(push) <= most ? 0 : push - std::copysign(most, push);
  };
  multibody::TorqueLine<double> line = motor.free;
  // the first line is the free one, so lines_in_turn - 1 changes are left
  for (int turn = 1; turn < multibody::lines_in_turn; ++turn) {
    const double D = inertia(line);
    line = multibody::followed_line(motor, line, D, (momentum(line) - D * w) / dt);
  }
  rate_[i] = momentum(line) / inertia(line);
  play_[i] += dt * (rate_[i] - qd);
  if (std::abs(play_[i]) < gear.half_play) return;
  side_[i] = std::copysign(1.0, play_[i]);
  play_[i] = std::copysign(gear.half_play, play_[i]);
}

}  // namespace murosimf::dynamics
