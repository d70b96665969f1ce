/// servo_device.h - a servo on the bus: what its registers do.
///
/// It knows its shaft's angle [rad], counterclockwise, 0 at the position 2048. Who simulates the shaft tells it what it feels (sense)
/// and asks for where it wants the shaft (target). Position, velocity (wheel) and extended position (multi-turn) modes are those of
/// the e-Manual, and current-based position mode, whose goal current limits the torque. Torque, load, voltage and temperature are what is simulated; where nothing is, nominal values stand.
#pragma once

#include <limits>

#include "murosimf/connect/dynamixel/bus_device.h"

namespace murosimf::connect::dynamixel {

struct ServoOptions {
  double lowest = -std::numeric_limits<double>::infinity();  ///< [rad] where the shaft meets its end
  double highest = std::numeric_limits<double>::infinity();
  double stall_torque = 0;  ///< [N m] of the simulated servo; 0: that of the data sheet
  double full_error = 0.2;  ///< [rad] between goal and shaft that makes it give that, with the gains of the factory
  bool torque = false;      ///< is on at the start
};

/// What a servo measures. NaN: not simulated.
struct ServoSense {
  double angle = 0;         ///< [rad]
  double velocity = 0;      ///< [rad/s]
  double torque = 0;        ///< [N m]
  double voltage = 12;      ///< [V]
  double temperature = 25;  ///< [C]
};

class ServoDevice final : public BusDevice {
 public:
  ServoDevice(const ControlTable& table, std::uint8_t id, const ServoOptions& options);

  /// At the time `now` [s].
  void sense(const ServoSense& sense, double now);
  /// Goes on for dt [s] to its goal, as fast as its profile says.
  void advance(double dt);

  [[nodiscard]] bool torque() const { return registers().get(Item::torque_enable) != 0; }
  [[nodiscard]] bool turns() const { return mode() == Mode::velocity; }
  [[nodiscard]] bool led() const { return registers().get(Item::led) != 0; }
  /// [1] its P gain, over that from the factory.
  [[nodiscard]] double gain_share() const;
  /// [s] its D gain, over the P gain from the factory.
  [[nodiscard]] double damping_time() const;
  /// [1] the torque that it may give, over its stall torque.
  [[nodiscard]] double torque_share() const;
  /// [rad] within its ends; with what its I gain adds.
  [[nodiscard]] double target() const;
  /// [rad/s]
  [[nodiscard]] double target_velocity() const;

  void state(StateArchive& archive) override;

 private:
  enum class Mode { velocity, position, extended };

  [[nodiscard]] bool eeprom_locked() const override;
  [[nodiscard]] Refusal check(const Field& field, std::int32_t value) const override;
  void written(const Field& field) override;
  void restarted() override;
  [[nodiscard]] Refusal clear(ByteView parameters) override;
  [[nodiscard]] std::uint8_t alarm() const override;

  [[nodiscard]] bool old() const { return protocol() == Protocol::v1; }
  [[nodiscard]] Mode mode() const;
  [[nodiscard]] std::int32_t offset() const;
  [[nodiscard]] double wanted_velocity() const;
  [[nodiscard]] double fastest() const;
  void stay();
  void integrate(double dt);
  void show_position(Item item, double pulses);
  void show_motion(double velocity);
  void show_load(double torque);
  void look_for_errors();
  [[nodiscard]] std::int32_t with_direction(double counts) const;

  ServoOptions options_;
  double present_;           // [pulses] of the shaft, without offset
  double goal_;              // [pulses]
  double trajectory_;        // [pulses] on its way to the goal
  double velocity_ = 0;      // [pulses/s] of the trajectory
  double integral_ = 0;      // [rad] that the I gain adds to the target
  std::uint8_t errors_ = 0;  // bits as in protocol 1.0
  bool sensed_ = false;      // it knows where the shaft is
  bool was_on_ = false;      // the torque, before the present packet
};

}  // namespace murosimf::connect::dynamixel
