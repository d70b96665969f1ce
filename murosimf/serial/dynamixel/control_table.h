/// control_table.h - the memory of a device as data: address, size, access, range and
/// factory value of each number.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/serial/dynamixel/protocol.h"

namespace murosimf::serial::dynamixel {

enum class Access : std::uint8_t {
  read_only,
  ram,     ///< writable; reset when the device starts
  eeprom,  ///< writable while the torque is off; permanent
};

/// Meaning of a number for the device. `stored`: kept and read back, without effect.
enum class Item : std::uint8_t {
  stored,
  model_number,
  firmware,
  id,
  secondary_id,
  baud_rate,
  return_delay,  // [2 us]
  status_return_level,
  registered,
  // of servos
  drive_mode,
  operating_mode,
  position_offset,   // homing offset (2.0), multi turn offset (1.0)
  moving_threshold,  // [velocity units]
  temperature_limit,
  lowest_voltage,
  highest_voltage,
  pwm_limit,
  current_limit,
  velocity_limit,
  lowest_position,   // CW angle limit (1.0)
  highest_position,  // CCW angle limit (1.0)
  overload_torque,   // [%]
  overload_time,     // [10 ms]
  shutdown,
  lock,
  torque_enable,
  led,
  hardware_error,
  position_p_gain,
  position_i_gain,
  position_d_gain,
  bus_watchdog,  // [20 ms]
  torque_limit,  // of 1.0: share of what the servo can give
  goal_pwm,
  goal_current,
  goal_velocity,         // moving speed (1.0)
  profile_acceleration,  // goal acceleration (1.0)
  profile_velocity,
  goal_position,
  realtime_tick,  // [ms]
  moving,
  moving_status,
  present_pwm,
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
  last,  // no item: their number
};

struct Field {
  std::uint16_t address = 0;
  std::uint8_t size = 1;  ///< [bytes] 1, 2 or 4, the lowest first
  Access access = Access::read_only;
  std::int32_t initial = 0;
  std::int32_t lowest = 0, highest = 0;  ///< writable range; two's complement if negative
  Item item = Item::stored;
  std::uint8_t sign_bit = 0;  ///< if not 0: this bit is the sign of a number, not two's complement

  [[nodiscard]] std::size_t end() const { return std::size_t{address} + size; }
};

/// Units of a servo's numbers.
struct ServoUnits {
  double velocity = 0;       ///< [rad/s] per count
  double acceleration = 0;   ///< [rad/s^2] per count; 0: not supported
  double current = 0;        ///< [A] per count; 0: not measured
  double stall_torque = 0;   ///< [N m] at its nominal voltage
  double stall_current = 0;  ///< [A] at stall_torque
  double no_load_speed = 0;  ///< [rad/s] without load
  double p_gain = 0;         ///< [1] per count
  double i_gain = 0;         ///< [1/s]
  double d_gain = 0;         ///< [s]
  double full_torque = 0;    ///< [1] of Item::torque_limit or Item::goal_pwm: no limit
};

/// Bytes `data`, `data` + 1, ... refer to the addresses stored at `addresses`, two bytes each.
struct IndirectBlock {
  std::uint16_t addresses = 0, data = 0, count = 0;

  [[nodiscard]] bool has_data(std::size_t address) const { return address >= data && address < data + count; }
};

struct ControlTable {
  std::string name;  ///< "mx28"
  std::string base;  ///< name of its base table; empty: none
  Protocol protocol = Protocol::v2;
  std::vector<Field> fields;  ///< by address, without overlap
  ServoUnits units;
  bool feetech = false;                       ///< protocol 1.0 in the variant of Feetech
  std::vector<std::int32_t> operating_modes;  ///< supported modes
  std::vector<double> baud_rates;             ///< [bit/s] of the values from 0 on
  double baud_clock = 0;                      ///< [bit/s] if not 0: rate of values up to 249: baud_clock / (value + 1)
  std::vector<double> fast_baud_rates;        ///< [bit/s] with baud_clock, of the values from 250 on
  std::vector<IndirectBlock> indirect;
  double pulses_per_turn = 4096;
  double middle_pulse = 2048;  ///< position at the angle 0

  /// Null if it has no such item.
  [[nodiscard]] const Field* find(Item item) const;
  /// The field that contains the byte at an address; null: none.
  [[nodiscard]] const Field* at(std::size_t address) const;
  /// Number of bytes from 0 to the end of the last field.
  [[nodiscard]] std::size_t size() const { return fields.back().end(); }
  /// [bit/s] of a value of Item::baud_rate; 0: no such value.
  [[nodiscard]] double baud_rate(std::int32_t value) const;
  /// The value for a rate [bit/s]; nothing if none is near enough.
  [[nodiscard]] std::optional<std::int32_t> baud_value(double rate) const;

  [[nodiscard]] double pulses_per_radian() const;
  [[nodiscard]] double pulses_of(double angle) const { return middle_pulse + angle * pulses_per_radian(); }
  [[nodiscard]] double angle_of(double pulses) const { return (pulses - middle_pulse) / pulses_per_radian(); }
};

/// Whether a receiver at one rate [bit/s] understands bytes of the other: clocks of UARTs may differ by some 3 %.
[[nodiscard]] bool same_rate(double first, double second);

/// From a file: "servos/tables/NAME.toml" of those supplied with the program, or, if it ends with ".toml", a file of the user's,
/// here or in `beside`. Its address is stable. Null if there is none. Throws SetupError with file:line:column (control_table_file.h).
[[nodiscard]] const ControlTable* find_servo_table(std::string_view name, const std::filesystem::path& beside = {});
/// Names of those supplied with the program, in alphabetical order.
[[nodiscard]] std::vector<std::string> servo_table_names();

}  // namespace murosimf::serial::dynamixel
