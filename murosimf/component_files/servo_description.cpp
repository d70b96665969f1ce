#include "murosimf/component_files/servo_description.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/files/data_path.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::component_files {
namespace {

using Names = std::vector<std::string_view>;

struct Number {
  std::string_view key;
  double& (*of)(Servo&);
};
template <auto member>
double& of_servo(Servo& servo) {
  return servo.*member;
}
template <auto member>
double& of_friction(Servo& servo) {
  return servo.friction.*member;
}
template <auto member>
double& of_heat(Servo& servo) {
  return servo.heat.*member;
}
constexpr std::array numbers{Number{"voltage", of_servo<&Servo::voltage>},
                             Number{"stall_torque", of_servo<&Servo::stall_torque>},
                             Number{"lowest_torque_share", of_servo<&Servo::lowest_share>},
                             Number{"highest_torque_share", of_servo<&Servo::highest_share>},
                             Number{"no_load_speed", of_servo<&Servo::no_load_speed>},
                             Number{"position_gain", of_servo<&Servo::position_gain>},
                             Number{"firmware_gain", of_servo<&Servo::firmware_gain>},
                             Number{"velocity_gain", of_servo<&Servo::velocity_gain>},
                             Number{"duty_limit", of_servo<&Servo::duty_limit>},
                             Number{"torque_limit", of_servo<&Servo::torque_limit>},
                             Number{"rotor_inertia", of_servo<&Servo::rotor_inertia>},
                             Number{"coulomb_friction", of_friction<&GearFriction::coulomb>},
                             Number{"viscous_friction", of_friction<&GearFriction::viscous>},
                             Number{"stribeck_friction", of_friction<&GearFriction::stribeck>},
                             Number{"stribeck_rate", of_friction<&GearFriction::stribeck_rate>},
                             Number{"stribeck_exponent", of_friction<&GearFriction::stribeck_exponent>},
                             Number{"motor_load_friction", of_friction<&GearFriction::motor_load>},
                             Number{"external_load_friction", of_friction<&GearFriction::external_load>},
                             Number{"stribeck_motor_load_friction", of_friction<&GearFriction::stribeck_motor_load>},
                             Number{"stribeck_external_load_friction",
                                    of_friction<&GearFriction::stribeck_external_load>},
                             Number{"quadratic_motor_load_friction", of_friction<&GearFriction::quadratic_motor_load>},
                             Number{"quadratic_external_load_friction",
                                    of_friction<&GearFriction::quadratic_external_load>},
                             Number{"backlash", of_servo<&Servo::backlash>},
                             Number{"encoder_step", of_servo<&Servo::encoder_step>},
                             Number{"dead_band", of_servo<&Servo::dead_band>},
                             Number{"command_period", of_servo<&Servo::command_period>},
                             Number{"command_delay", of_servo<&Servo::command_delay>},
                             Number{"command_filter", of_servo<&Servo::command_filter>},
                             Number{"heat_capacity", of_heat<&ServoHeat::heat_capacity>},
                             Number{"thermal_resistance", of_heat<&ServoHeat::thermal_resistance>},
                             Number{"ambient_temperature", of_heat<&ServoHeat::ambient_temperature>},
                             Number{"derating_temperature", of_heat<&ServoHeat::derating_temperature>},
                             Number{"temperature_limit", of_heat<&ServoHeat::temperature_limit>}};

/// Keys that a servo law needs, and keys without meaning for it.
struct Law {
  std::string_view name;
  Names needed, useless;
};
const std::array<Law, 2>& laws() {
  static const std::array<Law, 2> all{
      Law{"dc_motor",
          {"stall_torque", "no_load_speed", "position_gain", "rotor_inertia", "coulomb_friction"},
          {"velocity_gain", "lowest_torque_share", "highest_torque_share"}},
      Law{"ideal_pd",
          {"position_gain", "rotor_inertia"},
          {"no_load_speed", "duty_limit", "torque_limit", "current_limit", "heat_capacity", "thermal_resistance",
           "ambient_temperature", "derating_temperature", "temperature_limit"}}};
  return all;
}
const Law& law_of(const Servo& servo) {
  MUROSIMF_ASSERT(std::ranges::find(laws(), servo.law, &Law::name) != laws().end());
  return *std::ranges::find(laws(), servo.law, &Law::name);
}

bool contains(const Names& names, std::string_view name) { return std::ranges::find(names, name) != names.end(); }

Names known_keys(const Names& others) {
  Names keys{"law", "current_limit", "fit"};
  for (const Number& number : numbers) keys.push_back(number.key);
  keys.insert(keys.end(), others.begin(), others.end());
  return keys;
}

/// Bounds: larger numbers were meant in another unit.
struct Largest {
  std::string_view key;
  double value;
  std::string_view meaning;
};
constexpr std::array largest{Largest{"command_delay", 1, "is in seconds; more than 1 is no delay of a bus"},
                             Largest{"command_filter", 10,
                                     "is in seconds; more than 10 is no time constant of a servo"},
                             Largest{"command_period", 1, "is in seconds; more than 1 is no rate of a bus"},
                             Largest{"backlash", 0.5, "is in radians; more than 0.5 is no play of a gear"},
                             Largest{"encoder_step", 0.5, "is in radians; more than 0.5 is no step of an encoder"},
                             Largest{"dead_band", 0.5, "is in radians; more than 0.5 is no dead band"}};

double read_temperature(std::string_view key, const toml::node& node) {
  // 1e9 stands for values that are not numbers: it fails the check below.
  const double number = node.is_number() ? node.value_or(1e9) : 1e9;
  if (!(std::abs(number) <= 200)) {  // NaN is not either
    files::fail_at(node.source(), fmt::format("'{}' must be a temperature in degrees Celsius, at most 200", key));
  }
  return number;
}

double read_share(std::string_view key, const toml::node& node) {
  const double number = node.is_number() ? node.value_or(2.0) : 2.0;
  if (!(std::abs(number) <= 1))  // NaN is not either
    files::fail_at(node.source(), fmt::format("'{}' must be a number from -1 to 1", key));
  return number;
}

double read_number(std::string_view key, const toml::node& node) {
  if (key.ends_with("torque_share")) return read_share(key, node);
  if (key.ends_with("temperature") || key == "temperature_limit") return read_temperature(key, node);
  const double number = node.is_number() ? node.value_or(-1.0) : -1.0;
  const bool finite = std::isfinite(number);
  if (key == "duty_limit" && !(finite && number > 0 && number <= 1)) {
    files::fail_at(node.source(), "'duty_limit' must be a number above 0, at most 1");
  }
  if ((key == "voltage" || key == "current_limit") && !(finite && number > 0)) {
    files::fail_at(node.source(), fmt::format("'{}' must be a finite number above 0", key));
  }
  if (!finite || number < 0)
    files::fail_at(node.source(), fmt::format("'{}' must be a finite number, at least 0", key));
  for (const Largest& most : largest) {
    if (key == most.key && number > most.value)
      files::fail_at(node.source(), fmt::format("'{}' {}", key, most.meaning));
  }
  return number;
}

/// Returns what is missing or impossible in thermal numbers; empty: nothing.
std::string complaint_about_heat(const Servo& servo) {
  const ServoHeat& heat = servo.heat;
  const bool derates = heat.derating_temperature != 0 || heat.temperature_limit != 0;
  if (heat.heat_capacity == 0 && heat.thermal_resistance == 0 && !derates) return {};
  if (heat.heat_capacity <= 0 || heat.thermal_resistance <= 0) {
    return "gets warm: it needs heat_capacity and thermal_resistance, both above 0";
  }
  if (servo.voltage <= 0) return "gets warm: it needs voltage, from which its current follows";
  if (derates && !(heat.derating_temperature > 0 && heat.derating_temperature < heat.temperature_limit)) {
    return "gets warm: derating_temperature must be above 0 and below temperature_limit";
  }
  return {};
}

}  // namespace

ServoDescription::ServoDescription(const Servo& servo) : servo_(servo) {
  for (const Number& number : numbers) {
    if (number.of(servo_) != 0) given_.emplace(number.key);
  }
  // A complete servo has all numbers that its law needs, also those that are 0.
  for (const std::string_view key : law_of(servo_).needed) given_.emplace(key);
}

void ServoDescription::take(const toml::table& table, const Names& others) {
  take_law(table);
  // The voltage first: it scales the numbers of the ready-made servo, not those of this table.
  if (const toml::node* voltage = table.get("voltage"); voltage && !given_.empty()) {
    scale_to(read_number("voltage", *voltage), voltage->source());
  }
  const Names known = known_keys(others);
  for (const auto& [key, node] : table) {
    if (!contains(known, key.str())) files::fail_at(key.source(), unknown_name("key of a servo", key.str(), known));
    if (key == "fit" && !node.is_table())
      files::fail_at(node.source(), "[fit] says where the numbers come from: a table");
    if (key != "law" && key != "fit" && !contains(others, key.str())) take_number(key, node);
  }
  // Both limit the torque: an error in one of them would be invisible.
  if (table.contains("torque_limit") && table.contains("current_limit")) {
    files::fail_at(table.get("current_limit")->source(), "'current_limit' and 'torque_limit' limit the same; keep one");
  }
}

void ServoDescription::take_law(const toml::table& table) {
  const toml::node* node = table.get("law");
  if (!node) return;
  const auto name = node->value_exact<std::string>();
  if (!name) files::fail_at(node->source(), "'law' must be a name in quotes");
  Names known;
  for (const Law& law : laws()) known.push_back(law.name);
  if (!contains(known, *name)) files::fail_at(node->source(), unknown_name("servo law", *name, known));
  servo_.law = *name;
}

void ServoDescription::scale_to(double voltage, const toml::source_region& source) {
  if (!given_.contains("voltage")) {
    files::fail_at(source,
                   fmt::format("servo type '{}' does not say at which voltage its numbers hold; remove 'voltage', or "
                               "add it there",
                               servo_.type));
  }
  MUROSIMF_ASSERT(servo_.voltage > 0);
  const double ratio = voltage / servo_.voltage;
  servo_.stall_torque *= ratio;
  servo_.no_load_speed *= ratio;
  servo_.position_gain *= ratio;
}

void ServoDescription::take_number(const toml::key& key, const toml::node& node) {
  // A key without effect is an error: its user expects one.
  if (contains(law_of(servo_).useless, key.str())) {
    files::fail_at(key.source(), fmt::format("'{}' means nothing to servo law '{}'; remove it", key.str(), servo_.law));
  }
  const double value = read_number(key.str(), node);
  if (key == "current_limit") {
    current_limit_ = value;
  } else {
    MUROSIMF_ASSERT(std::ranges::find(numbers, key.str(), &Number::key) != numbers.end());
    std::ranges::find(numbers, key.str(), &Number::key)->of(servo_) = value;
    if (key == "torque_limit") current_limit_.reset();
  }
  given_.emplace(key.str());
}

Servo ServoDescription::finish(std::string_view name, const toml::source_region& source) const {
  Names missing = law_of(servo_).needed;
  std::erase_if(missing, [&](std::string_view key) { return given_.contains(key); });
  if (!missing.empty()) files::fail_at(source, fmt::format("servo '{}' needs {}", name, fmt::join(missing, ", ")));
  Servo servo = servo_;
  if (servo.lowest_share > servo.highest_share) {
    files::fail_at(source, fmt::format("servo '{}': lowest_torque_share is above highest_torque_share", name));
  }
  if (servo.law != "dc_motor") return servo;
  if (!(servo.stall_torque > 0 && servo.no_load_speed > 0)) {
    files::fail_at(source,
                   fmt::format("servo '{}' cannot move: stall_torque and no_load_speed must be positive", name));
  }
  if (current_limit_) {
    if (servo.voltage <= 0)
      files::fail_at(source, fmt::format("servo '{}' needs voltage, because of current_limit", name));
    // Torque per current is the torque constant, voltage / no_load_speed.
    servo.torque_limit = *current_limit_ * servo.voltage / servo.no_load_speed;
  }
  if (const std::string complaint = complaint_about_heat(servo); !complaint.empty()) {
    files::fail_at(source, fmt::format("servo '{}' {}", name, complaint));
  }
  // Products of finite numbers may overflow.
  for (const Number& number : numbers) {
    if (!std::isfinite(number.of(servo))) {
      files::fail_at(source,
                     fmt::format("{} of servo '{}' is not finite; voltage or current is too large", number.key, name));
    }
  }
  return servo;
}

ServoDescription read_servo_description(std::string_view type, const std::filesystem::path& beside) {
  const auto file = files::look_for_data_file(type, "servos", ".toml", beside);
  if (!file) {
    const auto names = files::data_file_names("servos", ".toml");
    throw SetupError(unknown_name("servo type", type, Names(names.begin(), names.end())));
  }
  const toml::table table = files::parse_toml_file(*file);
  ServoDescription description{file->stem().string()};
  description.take(table);
  (void)description.finish(file->stem().string(), table.source());
  return description;
}

}  // namespace murosimf::component_files
