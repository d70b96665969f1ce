/// control_table.h - the memory of a device as data: where each number stands, how long it is, who may write it, its range and the
/// value that it has when the device leaves the factory.
#pragma once

#include <string>
#include <vector>

#include "murosimf/connect/dynamixel/protocol.h"

namespace murosimf::connect::dynamixel {

enum class Access : std::uint8_t {
  read_only,
  ram,     ///< may be written; has its first value again when the device starts
  eeprom,  ///< may be written while the torque is off; stays
};

/// What a number means to the device. `stored`: it is kept and read back, and acts on nothing here.
enum class Item : std::uint8_t {
  stored,
  model_number,
  firmware,
  id,
  secondary_id,
  return_delay,  // [2 us]
  status_return_level,
  registered,
  // of servos
  operating_mode,
  position_offset,   // homing offset (2.0), multi turn offset (1.0)
  moving_threshold,  // [velocity units]
  temperature_limit,
  lowest_voltage,
  highest_voltage,
  velocity_limit,
  lowest_position,   // CW angle limit (1.0)
  highest_position,  // CCW angle limit (1.0)
  shutdown,
  lock,
  torque_enable,
  led,
  hardware_error,
  position_p_gain,
  position_i_gain,
  position_d_gain,
  torque_limit,  // of 1.0; goal PWM (2.0): shares of what the servo can give
  goal_current,
  goal_velocity,  // moving speed (1.0)
  profile_velocity,
  goal_position,
  realtime_tick,  // [ms]
  moving,
  moving_status,
  present_load,
  present_current,
  present_velocity,
  present_position,
  velocity_trajectory,
  position_trajectory,
  present_voltage,  // [0.1 V]
  present_temperature,
  // of the IMU board
  sample,
  sample_time,  // [ms]
  gyroscope_x,
  gyroscope_y,
  gyroscope_z,
  accelerometer_x,
  accelerometer_y,
  accelerometer_z,
  last,  // none: how many there are
};

struct Field {
  std::uint16_t address = 0;
  std::uint8_t size = 1;  ///< [bytes] 1, 2 or 4, the lowest first
  Access access = Access::read_only;
  std::int32_t initial = 0;
  std::int32_t lowest = 0, highest = 0;  ///< that may be written; two's complement if one is negative
  Item item = Item::stored;

  [[nodiscard]] std::size_t end() const { return std::size_t{address} + size; }
};

/// What the numbers of a servo mean.
struct ServoUnits {
  double velocity = 0;       ///< [rad/s] of one
  double current = 0;        ///< [A] of one; 0: it measures none
  double stall_torque = 0;   ///< [N m] at 12 V
  double stall_current = 0;  ///< [A] then
  double p_gain = 0;         ///< [1] of one
  double i_gain = 0;         ///< [1/s]
  double d_gain = 0;         ///< [s]
  double full_torque = 0;    ///< [1] of Item::torque_limit: no limit
};

struct ControlTable {
  std::string name;  ///< "mx28"
  Protocol protocol = Protocol::v2;
  std::vector<Field> fields;  ///< by address, none over another
  ServoUnits units;

  /// Null if it has none.
  [[nodiscard]] const Field* find(Item item) const;
  /// That has the byte at an address; null: none.
  [[nodiscard]] const Field* at(std::size_t address) const;
  /// Bytes from 0 to the end of the last field.
  [[nodiscard]] std::size_t size() const { return fields.back().end(); }
};

/// Of all servos.
[[nodiscard]] const std::vector<ControlTable>& servo_tables();
/// Null if there is none of that name.
[[nodiscard]] const ControlTable* find_servo_table(std::string_view name);

/// For the lists of tables: servos of protocol 1.0, and those of 2.0.
[[nodiscard]] std::vector<ControlTable> servo_tables_v1();
[[nodiscard]] std::vector<ControlTable> servo_tables_v2();

/// [pulses per turn] of every encoder here, and where a servo stands at the angle 0.
inline constexpr double pulses_per_turn = 4096;
inline constexpr double middle_pulse = 2048;

}  // namespace murosimf::connect::dynamixel
