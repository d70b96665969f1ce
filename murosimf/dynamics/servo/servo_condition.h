/// servo_condition.h - conditions of a robot's motors: supply, whether torque is on, temperature.
///
/// `supply_voltage` and `torque_enabled` are inputs: a battery, a user or control software may change them at any time.
/// So are gains, torque limit, target rate and feed-forward torque, if control software that was attached earlier uses these properties.
/// Temperature is simulated for servos with thermal numbers only (multibody/servo/servo_motor.h); it is kept if another level or
/// law that has it takes over.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "murosimf/dynamics/servo/servo_law.h"
#include "murosimf/math/assert.h"
#include "murosimf/world/setup.h"

namespace murosimf::dynamics {

class ServoCondition {
 public:
  /// `law` as in JointDrives. Throws SetupError if a servo has thermal numbers but no voltage.
  ServoCondition(Setup& setup, std::string_view law);

  /// Sets all servos to the temperature of the air.
  void cool_down() noexcept;
  /// The same for servos that have no temperature yet.
  void take_over() noexcept;
  /// Fills supply, conductance, heat and switch of a servo (an object of the model).
  void fill(int object, MotorInput& input) const noexcept;
  /// Whether software may change gains, limits, target rates or feed-forward torques of its servos.
  [[nodiscard]] bool tunes() const noexcept { return tunes_; }
  /// Fills what software has set for a servo of that; nothing, if it has set none.
  void tune(int object, MotorInput& input) const noexcept;
  [[nodiscard]] bool heats(int object) const noexcept { return motors_[static_cast<std::size_t>(object)].heats; }
  /// By object, empty without servos: [V], and 0 where torque is switched off.
  [[nodiscard]] std::span<const double> supply() const noexcept { return supply_; }
  [[nodiscard]] std::span<const double> enabled() const noexcept { return enabled_; }
  /// [1/V] of the nominal voltage of a servo; 0: unknown, the supply has no effect.
  [[nodiscard]] double per_volt(std::size_t object) const noexcept {
    MUROSIMF_ASSERT(object < motors_.size());
    return motors_[object].per_volt;
  }
  /// Warms the winding for a step of `dt` [s] with this torque [N m].
  void warm(int object, double torque, double dt) noexcept;

 private:
  struct Motor {
    double per_volt = 0;  // [1/V] of the nominal voltage; 0: not known
    bool heats = false;
    multibody::ServoMotor numbers;
    double position_gain = 0, velocity_gain = 0, stall_torque = 0;  // its own
  };
  void find_tuning(Setup& setup);

  std::vector<Motor> motors_;  // by object
  std::span<const double> supply_, enabled_;
  std::span<double> temperature_;  // [C] empty if no servo heats
  // empty: no software sets it; NaN: not yet
  std::span<const double> position_gain_, velocity_gain_, torque_limit_, target_rate_, feed_forward_;
  bool tunes_ = false;
  bool fresh_ = true;  // the column of temperatures is new
};

}  // namespace murosimf::dynamics
