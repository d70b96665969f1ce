#include "murosimf/component_files/sensor_sections.h"

#include <numbers>

#include <fmt/format.h>

#include "murosimf/component_files/sensor_keys.h"
#include "murosimf/component_files/sensor_types.h"
#include "murosimf/component_files/servo_sections.h"
#include "murosimf/math/roll_pitch_yaw.h"

namespace murosimf::component_files {
namespace {

using sensors::SensorSpec;

std::string place_of(const SensorSpec& spec) {
  std::string text;
  if (!spec.frame.empty()) text += fmt::format("frame = {}\n", toml_quoted(spec.frame));
  const Vec3d& p = spec.position;
  if (!is_zero(p)) text += fmt::format("position = [{}, {}, {}]\n", p.x, p.y, p.z);
  const auto angles = [&](const char* key, const Vec3d& rpy) {
    const Vec3d degrees = (180 / std::numbers::pi) * rpy;
    text += fmt::format("{} = [{:.13g}, {:.13g}, {:.13g}]\n", key, degrees.x, degrees.y, degrees.z);
  };
  if (!is_identity(spec.orientation)) angles("rpy_deg", roll_pitch_yaw(spec.orientation));
  if (!is_zero(spec.mounting_error)) angles("mounting_error_deg", spec.mounting_error);
  return text;
}

std::string objects_of(const SensorSpec& spec) {
  if (spec.objects.empty()) return {};
  std::string names;
  for (const std::string& object : spec.objects) names += (names.empty() ? "" : ", ") + toml_quoted(object);
  const SensorType& type = sensor_types().find(spec.type);
  return fmt::format("{} = [{}]\n", type.objects, names);
}

std::string numbers_of(const SensorSpec& spec) {
  const SensorType& type = sensor_types().find(spec.type);
  std::string text;
  for (const auto& [key, number] : spec.numbers) {
    // Flags are stored as numbers.
    const OptionInfo* option = find_option(type.options, key);
    const bool is_flag = option && std::holds_alternative<bool>(option->fallback);
    text += is_flag ? fmt::format("{} = {}\n", key, number != 0) : fmt::format("{} = {}\n", key, number);
  }
  for (const auto& [key, word] : spec.texts) text += fmt::format("{} = {}\n", key, toml_quoted(word));
  return text;
}

std::string section(const SensorSpec& spec) {
  std::string text = fmt::format("\n[sensors.{}]\ntype = {}\n", spec.name, toml_quoted(spec.type)) + place_of(spec);
  if (spec.rate > 0) text += fmt::format("rate = {}\n", spec.rate);
  if (spec.phase > 0) text += fmt::format("phase = {}\n", spec.phase);
  if (spec.delay > 0) text += fmt::format("delay = {}\n", spec.delay);
  text += objects_of(spec);
  text += numbers_of(spec);
  if (const auto all = spec.signals.find(""); all != spec.signals.end()) text += signal_toml(all->second);
  // Single outputs follow the numbers of all outputs, which they replace.
  for (const auto& [output, signal] : spec.signals) {
    if (output.empty()) continue;
    const bool of_number = output.find('.') != std::string::npos;  // in quotes, so that the dot begins no table
    text +=
        fmt::format("[sensors.{}.{}]\n{}", spec.name, of_number ? toml_quoted(output) : output, signal_toml(signal));
  }
  return text;
}

}  // namespace

std::string sensor_sections(const std::vector<SensorSpec>& sensors) {
  std::string text;
  for (const SensorSpec& spec : sensors) text += section(spec);
  return text;
}

}  // namespace murosimf::component_files
