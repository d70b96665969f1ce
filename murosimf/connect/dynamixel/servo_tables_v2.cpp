// Servos of protocol 2.0. Addresses, sizes, ranges and initial values: ROBOTIS e-Manual, control tables of MX-28(2.0), MX-64(2.0),
// MX-106(2.0), XM430-W350, XH430-W350 and XM540-W270; data sheets ibidem. Modes, protocols and drive modes that are not
// simulated are out of range here, so that nobody waits for their effect.
#include <numbers>

#include "murosimf/connect/dynamixel/control_table.h"

namespace murosimf::connect::dynamixel {
namespace {

constexpr int firmware_v2 = 45;
constexpr int any = 0x7FFFFFFF;
constexpr int full_pwm = 885;

/// What differs between the models.
struct Servo {
  std::string name;
  int model_number;
  int current_limit;  // 0: it measures the load, no current
  int velocity_limit;
  int position_gain;
  double current_unit;                 // [A]
  double stall_torque, stall_current;  // [N m, A] at 12 V
  bool acceleration_limit;
};

const std::vector<Servo>& servos() {
  constexpr double of_mx = 0.00336, of_x = 0.00269;
  static const std::vector<Servo> all{
      {"mx28_2", 30, 0, 230, 850, 0, 2.5, 1.4, true},
      {"mx64_2", 311, 1941, 285, 850, of_mx, 6.0, 4.1, true},
      {"mx106_2", 321, 2047, 210, 850, of_mx, 8.4, 5.2, true},
      {"xm430_w350", 1020, 1193, 200, 800, of_x, 4.1, 2.3, false},
      {"xh430_w350", 1000, 648, 130, 900, of_x, 3.4, 1.3, false},
      {"xm540_w270", 1120, 2047, 128, 800, of_x, 10.6, 4.4, false},
  };
  return all;
}

void append_eeprom(std::vector<Field>& fields, const Servo& servo) {
  using enum Access;
  fields = {
      {0, 2, read_only, servo.model_number, 0, 0, Item::model_number},
      {2, 4, read_only, 0, 0, 0},  // model information
      {6, 1, read_only, firmware_v2, 0, 0, Item::firmware},
      {7, 1, eeprom, 1, 0, 252, Item::id},
      {8, 1, eeprom, 1, 0, 7},  // baud rate
      {9, 1, eeprom, 250, 0, 254, Item::return_delay},
      {10, 1, eeprom, 0, 0, 0},  // drive mode
      {11, 1, eeprom, 3, 1, servo.current_limit > 0 ? 5 : 4, Item::operating_mode},
      {12, 1, eeprom, 255, 0, 255, Item::secondary_id},
      {13, 1, eeprom, 2, 2, 2},  // protocol type
      {20, 4, eeprom, 0, -1044479, 1044479, Item::position_offset},
      {24, 4, eeprom, 10, 0, 1023, Item::moving_threshold},
      {31, 1, eeprom, 80, 0, 100, Item::temperature_limit},
      {32, 2, eeprom, 160, 95, 160, Item::highest_voltage},
      {34, 2, eeprom, 95, 95, 160, Item::lowest_voltage},
      {36, 2, eeprom, 885, 0, 885},  // PWM limit
  };
  if (servo.current_limit > 0) fields.push_back({38, 2, eeprom, servo.current_limit, 0, servo.current_limit});
  if (servo.acceleration_limit) fields.push_back({40, 4, eeprom, 32767, 0, 32767});
  fields.push_back({44, 4, eeprom, servo.velocity_limit, 0, 1023, Item::velocity_limit});
  fields.push_back({48, 4, eeprom, 4095, 0, 4095, Item::highest_position});
  fields.push_back({52, 4, eeprom, 0, 0, 4095, Item::lowest_position});
  fields.push_back({63, 1, eeprom, 52, 0, 255, Item::shutdown});
}

void append_ram(std::vector<Field>& fields, const Servo& servo) {
  using enum Access;
  const int gain = 16383;
  for (const Field& field : std::vector<Field>{
           {64, 1, ram, 0, 0, 1, Item::torque_enable},
           {65, 1, ram, 0, 0, 1, Item::led},
           {68, 1, ram, 2, 0, 2, Item::status_return_level},
           {69, 1, read_only, 0, 0, 1, Item::registered},
           {70, 1, read_only, 0, 0, 255, Item::hardware_error},
           {76, 2, ram, 1920, 0, gain},  // velocity I gain
           {78, 2, ram, 100, 0, gain},   // velocity P gain
           {80, 2, ram, 0, 0, gain, Item::position_d_gain},
           {82, 2, ram, 0, 0, gain, Item::position_i_gain},
           {84, 2, ram, servo.position_gain, 0, gain, Item::position_p_gain},
           {88, 2, ram, 0, 0, gain},  // feed forward
           {90, 2, ram, 0, 0, gain},  // feed forward
           {98, 1, ram, 0, 0, 127},   // bus watchdog
           {100, 2, ram, full_pwm, -full_pwm, full_pwm, Item::torque_limit},
       }) {
    fields.push_back(field);
  }
  const int current = servo.current_limit;
  if (current > 0) fields.push_back({102, 2, ram, current, -current, current, Item::goal_current});
  for (const Field& field : std::vector<Field>{
           {104, 4, ram, 0, -1023, 1023, Item::goal_velocity},
           {108, 4, ram, 0, 0, 32767},  // profile acceleration
           {112, 4, ram, 0, 0, 32767, Item::profile_velocity},
           {116, 4, ram, 2048, -1048575, 1048575, Item::goal_position},
           {120, 2, read_only, 0, 0, 32767, Item::realtime_tick},
           {122, 1, read_only, 0, 0, 1, Item::moving},
           {123, 1, read_only, 0, 0, 255, Item::moving_status},
           {124, 2, read_only, 0, -885, 885},  // present PWM
           {126, 2, read_only, 0, -32768, 32767, current > 0 ? Item::present_current : Item::present_load},
           {128, 4, read_only, 0, -any, any, Item::present_velocity},
           {132, 4, read_only, 2048, -any, any, Item::present_position},
           {136, 4, read_only, 0, -any, any, Item::velocity_trajectory},
           {140, 4, read_only, 2048, -any, any, Item::position_trajectory},
           {144, 2, read_only, 120, 0, 65535, Item::present_voltage},
           {146, 1, read_only, 25, 0, 255, Item::present_temperature},
       }) {
    fields.push_back(field);
  }
}

}  // namespace

std::vector<ControlTable> servo_tables_v2() {
  constexpr double velocity_unit = 0.229 * 2 * std::numbers::pi / 60;  // [rad/s]
  constexpr double p = 1 / 128.0, i = 1000 / 65536.0, d = 1e-3 / 16;   // of cycles of 1 ms
  std::vector<ControlTable> tables;
  for (const Servo& servo : servos()) {
    ControlTable table{servo.name,
                       Protocol::v2,
                       {},
                       {velocity_unit, servo.current_unit, servo.stall_torque, servo.stall_current, p, i, d, full_pwm}};
    append_eeprom(table.fields, servo);
    append_ram(table.fields, servo);
    tables.push_back(std::move(table));
  }
  return tables;
}

}  // namespace murosimf::connect::dynamixel
