/// servo_device.h - a servo on the bus: the effect of its registers.
///
/// The angle of its shaft is in [rad], counterclockwise, 0 at the middle position. The simulation of the shaft passes measured values
/// (sense) and reads the commanded position (target). Modes, profiles and limits are those of the e-Manual; duration and load of
/// an overload are ours where no register defines them. Torque, load, voltage and temperature are simulated values, or
/// nominal ones if not simulated.
#pragma once

#include <limits>

#include "murosimf/serial/dynamixel/bus_device.h"

namespace murosimf::serial::dynamixel {

struct ServoOptions {
  double lowest = -std::numeric_limits<double>::infinity();  ///< [rad] lower end stop of the shaft
  double highest = std::numeric_limits<double>::infinity();
  double stall_torque = 0;   ///< [N m] of the simulated servo; 0: that of the data sheet
  double no_load_speed = 0;  ///< [rad/s] likewise
  double full_error = 0.2;   ///< [rad] position error that yields the stall torque with factory gains
  bool torque = false;       ///< enabled at the start
};

/// Measured values of a servo. NaN: not simulated.
struct ServoSense {
  double angle = 0;         ///< [rad]
  double velocity = 0;      ///< [rad/s]
  double torque = 0;        ///< [N m]
  double voltage = 12;      ///< [V]
  double temperature = 25;  ///< [C]
  bool driven = true;       ///< torque moves the shaft; false: it follows its target exactly
};

class ServoDevice final : public BusDevice {
 public:
  ServoDevice(const ControlTable& table, std::uint8_t id, const ServoOptions& options);

  /// At the time `now` [s].
  void sense(const ServoSense& sense, double now);
  /// Advances by dt [s] towards its goal, as its profile permits.
  void advance(double dt);
  void heard() override { silent_ = 0; }

  [[nodiscard]] bool torque() const { return registers().get(Item::torque_enable) != 0; }
  [[nodiscard]] bool turns() const { return mode() == Mode::velocity; }
  [[nodiscard]] bool led() const { return registers().get(Item::led) != 0; }
  /// [1] Its P gain, relative to the factory value.
  [[nodiscard]] double gain_share() const;
  /// [s] Its D gain beyond the factory value, relative to the factory P gain.
  [[nodiscard]] double damping_time() const;
  /// [1] Its torque limit, relative to its stall torque.
  [[nodiscard]] double torque_share() const;
  /// [rad] Within its end stops; includes the contribution of its I gain.
  [[nodiscard]] double target() const;
  /// [rad/s]
  [[nodiscard]] double target_velocity() const;

  void state(StateArchive& archive) override;

  static constexpr double overload_share = 0.9;  ///< [1] of its stall torque, for overload_time: overload [assumption]
  static constexpr double overload_time = 1;     ///< [s]

 private:
  enum class Mode { torque, velocity, position, extended, pwm };

  [[nodiscard]] bool eeprom_locked() const override;
  [[nodiscard]] Refusal check(const Field& field, std::int32_t value) const override;
  void written(const Field& field) override;
  void restarted() override;
  [[nodiscard]] Refusal clear(ByteView parameters) override;
  [[nodiscard]] std::uint8_t alarm() const override;

  [[nodiscard]] const ControlTable& table() const { return registers().table(); }
  [[nodiscard]] const ServoUnits& units() const { return table().units; }
  [[nodiscard]] bool old() const { return protocol() == Protocol::v1; }
  [[nodiscard]] bool has_drive_mode(std::int32_t bit) const;
  [[nodiscard]] Mode mode() const;
  [[nodiscard]] bool pushes() const { return mode() == Mode::torque || mode() == Mode::pwm; }
  [[nodiscard]] std::int32_t offset() const;
  [[nodiscard]] double direction() const;
  [[nodiscard]] double lowest() const;
  [[nodiscard]] double highest() const;
  [[nodiscard]] double wanted_velocity() const;
  [[nodiscard]] double fastest() const;
  [[nodiscard]] double acceleration() const;
  [[nodiscard]] bool watchdog_has_fired() const { return registers().get(Item::bus_watchdog) < 0; }
  [[nodiscard]] Refusal check_goal(const Field& field, std::int32_t value) const;
  void stay();
  void change_mode();
  void turn_round();
  void count_turns();
  void take_goal();
  void switch_torque();
  void follow_profile(double dt);
  void follow_rate(double dt);
  void integrate(double dt);
  void watch_bus(double dt);
  void watch_load(double dt);
  void show_position(Item item, double pulses);
  void show_motion(double velocity);
  void show_load(double torque, double velocity);
  void look_for_errors();

  ServoOptions options_;
  double present_;           // [pulses] of the shaft, without offset and whole turns
  double turns_ = 0;         // [pulses] whole turns not contained in the position
  double goal_;              // [pulses]
  double trajectory_;        // [pulses] on its way to the goal
  double velocity_ = 0;      // [pulses/s] of the trajectory
  double timed_speed_ = 0;   // [pulses/s] of a profile that is given by times
  double timed_rise_ = 0;    // [pulses/s^2] likewise
  double integral_ = 0;      // [rad] that the I gain adds to the target
  double silent_ = 0;        // [s] since the last instruction
  double load_ = 0;          // [1] of the stall torque
  double loaded_for_ = 0;    // [s] of overload
  std::uint8_t errors_ = 0;  // bits as in protocol 1.0
  bool overloaded_ = false;
  bool driven_ = true;   // torque moves the shaft
  bool sensed_ = false;  // a position was measured
  bool was_on_ = false;  // torque before the present packet
};

}  // namespace murosimf::serial::dynamixel
