#include "murosimf/io/sensor_sections.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "murosimf/io/registry.h"
#include "murosimf/io/sensor_signal.h"
#include "murosimf/io/sensor_types.h"
#include "murosimf/io/servo_sections.h"

namespace murosimf::io {
namespace {

using sensors::SensorSpec;

/// [rad] Angles r, p, y with R_z(y) R_y(p) R_x(r) = turn.
Vec3d roll_pitch_yaw(const Mat3d& turn) {
  const Vec3d &x = turn.x, &y = turn.y, &z = turn.z;  // columns
  const double level = std::hypot(x.x, x.y);
  const double pitch = std::atan2(-x.z, level);
  if (level < 1e-9) return {std::atan2(-z.y, y.y), pitch, 0};  // only the sum of roll and yaw matters
  return {std::atan2(y.z, z.z), pitch, std::atan2(x.y, x.x)};
}

std::string place_of(const SensorSpec& spec) {
  std::string text;
  if (!spec.frame.empty()) text += fmt::format("frame = {}\n", quoted(spec.frame));
  const Vec3d& p = spec.position;
  if (!is_zero(p)) text += fmt::format("position = [{}, {}, {}]\n", p.x, p.y, p.z);
  if (is_identity(spec.orientation)) return text;
  const Vec3d rpy = (180 / std::numbers::pi) * roll_pitch_yaw(spec.orientation);
  return text + fmt::format("rpy_deg = [{:.13g}, {:.13g}, {:.13g}]\n", rpy.x, rpy.y, rpy.z);
}

std::string objects_of(const SensorSpec& spec) {
  if (spec.objects.empty()) return {};
  std::string names;
  for (const std::string& object : spec.objects) names += (names.empty() ? "" : ", ") + quoted(object);
  const SensorType& type = find_entry(sensor_types(), "sensor type", spec.type);
  return fmt::format("{} = [{}]\n", type.objects, names);
}

std::string section(const SensorSpec& spec) {
  std::string text = fmt::format("\n[sensors.{}]\ntype = {}\n", spec.name, quoted(spec.type)) + place_of(spec);
  if (spec.rate > 0) text += fmt::format("rate = {}\n", spec.rate);
  if (spec.delay > 0) text += fmt::format("delay = {}\n", spec.delay);
  text += objects_of(spec);
  for (const auto& [key, number] : spec.numbers) text += fmt::format("{} = {}\n", key, number);
  if (const auto all = spec.signals.find(""); all != spec.signals.end()) text += signal_toml(all->second);
  for (const auto& [output, signal] : spec.signals) {
    if (output.empty()) continue;
    text += fmt::format("[sensors.{}.{}]\n{}", spec.name, output, signal_toml(signal));
  }
  return text;
}

}  // namespace

std::string sensor_sections(const std::vector<SensorSpec>& sensors) {
  std::string text;
  for (const SensorSpec& spec : sensors) text += section(spec);
  return text;
}

}  // namespace murosimf::io
