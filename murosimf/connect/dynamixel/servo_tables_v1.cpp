// Servos of protocol 1.0. Addresses, sizes and initial values: ROBOTIS e-Manual, control tables of MX-28, MX-64 and MX-106; data
// sheets ibidem. Ranges are narrower where more would have no effect here.
#include <numbers>

#include "murosimf/connect/dynamixel/control_table.h"

namespace murosimf::connect::dynamixel {
namespace {

constexpr int firmware_v1 = 41;

struct Mx {
  std::string name;
  int model_number;
  double stall_torque, stall_current;  // [N m, A] at 12 V
  bool measures_current;
  bool drive_mode;
};

std::vector<Field> fields_of(const Mx& servo) {
  using enum Access;
  std::vector<Field> fields{
      {0, 2, read_only, servo.model_number, 0, 0, Item::model_number},
      {2, 1, read_only, firmware_v1, 0, 0, Item::firmware},
      {3, 1, eeprom, 1, 0, 253, Item::id},
      {4, 1, eeprom, 34, 0, 254},  // baud rate
      {5, 1, eeprom, 250, 0, 254, Item::return_delay},
      {6, 2, eeprom, 0, 0, 4095, Item::lowest_position},
      {8, 2, eeprom, 4095, 0, 4095, Item::highest_position},
      {11, 1, eeprom, 80, 0, 100, Item::temperature_limit},
      {12, 1, eeprom, 60, 50, 160, Item::lowest_voltage},
      {13, 1, eeprom, 160, 50, 160, Item::highest_voltage},
      {14, 2, eeprom, 1023, 0, 1023},  // max torque
      {16, 1, eeprom, 2, 0, 2, Item::status_return_level},
      {17, 1, eeprom, 36, 0, 127},  // alarm LED
      {18, 1, eeprom, 36, 0, 127, Item::shutdown},
      {20, 2, eeprom, 0, -24576, 24576, Item::position_offset},
      {22, 1, eeprom, 1, 1, 1},  // resolution divider
      {24, 1, ram, 0, 0, 1, Item::torque_enable},
      {25, 1, ram, 0, 0, 1, Item::led},
      {26, 1, ram, 0, 0, 254, Item::position_d_gain},
      {27, 1, ram, 0, 0, 254, Item::position_i_gain},
      {28, 1, ram, 32, 0, 254, Item::position_p_gain},
      {30, 2, ram, 2048, -28672, 28672, Item::goal_position},
      {32, 2, ram, 0, 0, 2047, Item::goal_velocity},
      {34, 2, ram, 1023, 0, 1023, Item::torque_limit},
      {36, 2, read_only, 2048, -28672, 28672, Item::present_position},
      {38, 2, read_only, 0, 0, 2047, Item::present_velocity},
      {40, 2, read_only, 0, 0, 2047, Item::present_load},
      {42, 1, read_only, 120, 0, 255, Item::present_voltage},
      {43, 1, read_only, 25, 0, 255, Item::present_temperature},
      {44, 1, read_only, 0, 0, 1, Item::registered},
      {46, 1, read_only, 0, 0, 1, Item::moving},
      {47, 1, ram, 0, 0, 1, Item::lock},
      {48, 2, ram, 0, 0, 1023},  // punch
      {50, 2, read_only, 0, 0, 32767, Item::realtime_tick},
  };
  if (servo.drive_mode) fields.insert(fields.begin() + 7, {10, 1, eeprom, 0, 0, 0});
  if (servo.measures_current) {
    fields.push_back({68, 2, read_only, 2048, 0, 4095, Item::present_current});
    fields.push_back({70, 1, ram, 0, 0, 0});     // torque control mode
    fields.push_back({71, 2, ram, 0, 0, 2047});  // goal torque
  }
  fields.push_back({73, 1, ram, 0, 0, 254});  // goal acceleration
  return fields;
}

}  // namespace

std::vector<ControlTable> servo_tables_v1() {
  constexpr double velocity_unit = 0.114 * 2 * std::numbers::pi / 60;  // [rad/s]
  constexpr double current_unit = 0.0045;                              // [A]
  constexpr double p = 1 / 8.0, i = 1000 / 2048.0, d = 4 / 1000.0, all = 1023;
  std::vector<ControlTable> tables;
  for (const Mx& servo : {Mx{"mx28", 29, 2.5, 1.4, false, false}, Mx{"mx64", 310, 6.0, 4.1, true, false},
                          Mx{"mx106", 320, 8.4, 5.2, true, true}}) {
    tables.push_back({servo.name,
                      Protocol::v1,
                      fields_of(servo),
                      {velocity_unit, servo.measures_current ? current_unit : 0.0, servo.stall_torque,
                       servo.stall_current, p, i, d, all}});
  }
  return tables;
}

}  // namespace murosimf::connect::dynamixel
