/// servo_device.h - a servo on the bus: what its registers do.
///
/// It knows its shaft's angle [rad], counterclockwise, 0 at the middle position. Who simulates the shaft tells it what it feels
/// (sense) and asks for where it wants the shaft (target). Modes, profiles and limits are those of the e-Manual; the time and the load of
/// an overload are ours where no register says them. Torque, load, voltage and temperature are what is simulated; where nothing
/// is, nominal values stand.
#pragma once

#include <limits>

#include "murosimf/serial/dynamixel/bus_device.h"

namespace murosimf::serial::dynamixel {

struct ServoOptions {
  double lowest = -std::numeric_limits<double>::infinity();  ///< [rad] where the shaft meets its end
  double highest = std::numeric_limits<double>::infinity();
  double stall_torque = 0;   ///< [N m] of the simulated servo; 0: that of the data sheet
  double no_load_speed = 0;  ///< [rad/s] likewise
  double full_error = 0.2;   ///< [rad] between goal and shaft that makes it give that, with the gains of the factory
  bool torque = false;       ///< is on at the start
};

/// What a servo measures. NaN: not simulated.
struct ServoSense {
  double angle = 0;         ///< [rad]
  double velocity = 0;      ///< [rad/s]
  double torque = 0;        ///< [N m]
  double voltage = 12;      ///< [V]
  double temperature = 25;  ///< [C]
  bool driven = true;       ///< torque moves the shaft; false: it goes where it is told
};

class ServoDevice final : public BusDevice {
 public:
  ServoDevice(const ControlTable& table, std::uint8_t id, const ServoOptions& options);

  /// At the time `now` [s].
  void sense(const ServoSense& sense, double now);
  /// Goes on for dt [s] to its goal, as fast as its profile says.
  void advance(double dt);
  void heard() override { silent_ = 0; }

  [[nodiscard]] bool torque() const { return registers().get(Item::torque_enable) != 0; }
  [[nodiscard]] bool turns() const { return mode() == Mode::velocity; }
  [[nodiscard]] bool led() const { return registers().get(Item::led) != 0; }
  /// [1] its P gain, over that from the factory.
  [[nodiscard]] double gain_share() const;
  /// [s] its D gain beyond that from the factory, over the P gain from the factory.
  [[nodiscard]] double damping_time() const;
  /// [1] the torque that it may give, over its stall torque.
  [[nodiscard]] double torque_share() const;
  /// [rad] within its ends; with what its I gain adds.
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
  double present_;           // [pulses] of the shaft, without offset, since turns were counted last
  double turns_ = 0;         // [pulses] whole turns that are left out
  double goal_;              // [pulses]
  double trajectory_;        // [pulses] on its way to the goal
  double velocity_ = 0;      // [pulses/s] of the trajectory
  double timed_speed_ = 0;   // [pulses/s] of a profile that is given by times
  double timed_rise_ = 0;    // [pulses/s^2] likewise
  double integral_ = 0;      // [rad] that the I gain adds to the target
  double silent_ = 0;        // [s] since an instruction has come
  double load_ = 0;          // [1] of the stall torque
  double loaded_for_ = 0;    // [s] with too much of it
  std::uint8_t errors_ = 0;  // bits as in protocol 1.0
  bool overloaded_ = false;
  bool driven_ = true;   // torque moves the shaft
  bool sensed_ = false;  // it knows where the shaft is
  bool was_on_ = false;  // the torque, before the present packet
};

}  // namespace murosimf::serial::dynamixel
