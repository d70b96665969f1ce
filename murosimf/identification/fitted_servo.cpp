#include "murosimf/identification/fitted_servo.h"

#include <fmt/format.h>

#include "murosimf/component_files/servo_table.h"
#include "murosimf/files/data_path.h"
#include "murosimf/files/toml_reader.h"
#include "murosimf/identification/fit_report.h"

namespace murosimf::identification {
namespace {

void read_fit(const toml::table& table, FittedServo& fitted) {
  const files::TomlTable fit(table, {"model", "encoder_offset", "base", "prior", "mean_error"});
  fit.read("model", fitted.friction_model);
  fit.read("encoder_offset", fitted.encoder_offset);
}

std::string head(const FittedServo& fitted) {
  std::string text = fmt::format(
      "# Fitted by murosimf fit-servo (docs/servos.md): friction model {}, firmware of '{}',\n"
      "# prior '{}', to these logs (mean absolute error of position, whole log open loop):\n",
      fitted.friction_model, fitted.base, fitted.prior);
  for (const LogError& log : fitted.fitted) {
    text += fmt::format("#   {}  {}, gain {:g}: {:.1f} mrad\n", log.log, log.trajectory, log.firmware_gain,
                        1e3 * log.error);
  }
  return text + "# Motor and friction are one set; do not combine one with another's other.\n";
}

void line(std::string& text, std::string_view key, double value, std::string_view meaning) {
  text += fmt::format("{:<50}# {}\n", fmt::format("{} = {}", key, value), meaning);
}

void unless_zero(std::string& text, std::string_view key, double value, std::string_view meaning) {
  if (value != 0) line(text, key, value, meaning);
}

std::string motor(const Servo& s) {
  const double k_t = s.voltage / s.no_load_speed;
  std::string text = "law = \"dc_motor\"\n";
  line(text, "voltage", s.voltage, "[V]");
  line(text, "stall_torque", s.stall_torque, fmt::format("[N m] R = {:.4g} ohm", k_t * s.voltage / s.stall_torque));
  line(text, "no_load_speed", s.no_load_speed, fmt::format("[rad/s] k_t = {:.4g} N m/A", k_t));
  line(text, "position_gain", s.position_gain, "[N m/rad] at the firmware gain below");
  line(text, "firmware_gain", s.firmware_gain, "[1] register of the P gain");
  line(text, "duty_limit", s.duty_limit, "[1]");
  unless_zero(text, "torque_limit", s.torque_limit, "[N m] of the current limit");
  line(text, "rotor_inertia", s.rotor_inertia, "[kg m^2]");
  return text;
}

std::string friction(const GearFriction& k) {
  std::string text;
  line(text, "coulomb_friction", k.coulomb, "[N m] K_c");
  line(text, "viscous_friction", k.viscous, "[N m s/rad] K_v");
  unless_zero(text, "motor_load_friction", k.motor_load, "[1] K_m");
  unless_zero(text, "external_load_friction", k.external_load, "[1] K_e");
  if (k.stribeck_rate == 0) return text;
  line(text, "stribeck_rate", k.stribeck_rate, "[rad/s] v_s");
  line(text, "stribeck_exponent", k.stribeck_exponent, "[1] alpha");
  unless_zero(text, "stribeck_friction", k.stribeck, "[N m] K_cs");
  unless_zero(text, "stribeck_motor_load_friction", k.stribeck_motor_load, "[1] K_ms");
  unless_zero(text, "stribeck_external_load_friction", k.stribeck_external_load, "[1] K_es");
  unless_zero(text, "quadratic_motor_load_friction", k.quadratic_motor_load, "[1/(N m)] K_mq");
  unless_zero(text, "quadratic_external_load_friction", k.quadratic_external_load, "[1/(N m)] K_eq");
  return text;
}

std::string fit(const FittedServo& fitted) {
  return fmt::format("\n[fit]  # of the bench, not of the servo\nmodel = \"{}\"\nbase = \"{}\"\nprior = \"{}\"\n",
                     fitted.friction_model, fitted.base, fitted.prior) +
         fmt::format("encoder_offset = {}  # [rad]\nmean_error = {:.6g}  # [rad]\n", fitted.encoder_offset,
                     mean_error(fitted.fitted));
}

}  // namespace

FittedServo read_fitted_servo(std::string_view type) {
  FittedServo fitted{.servo = component_files::read_servo(type)};
  const toml::table content = files::parse_toml_file(files::find_data_file(type, "servos", ".toml"));
  if (const toml::table* table = content["fit"].as_table()) read_fit(*table, fitted);
  return fitted;
}

std::string to_toml(const FittedServo& fitted) {
  return head(fitted) + motor(fitted.servo) + friction(fitted.servo.friction) + fit(fitted);
}

}  // namespace murosimf::identification
