#include "murosimf/robot_formats/urdf/urdf_noise.h"

#include <array>

#include <fmt/format.h>

#include "murosimf/robot_formats/urdf/urdf_sensor.h"
#include "murosimf/robot_formats/urdf/urdf_value.h"

namespace murosimf::robot_formats::urdf {
namespace {

double number(const files::XmlElement& noise, const char* tag) {
  const auto child = only_child(noise, tag);
  return child ? text_number(*child) : 0;
}

double deviation(const files::XmlElement& noise, const char* tag) {
  const double value = number(noise, tag);
  if (value < 0) noise.fail("a deviation of noise is negative; it must be at least 0");
  return value;
}

/// The type of noise: an attribute in new files, an element in old ones.
std::string type_of(const files::XmlElement& noise) {
  if (const auto type = noise.attribute("type")) return *type;
  const auto type = only_child(noise, "type");
  return type ? type->text() : "gaussian";
}

}  // namespace

sensors::SignalSpec read_noise(const files::XmlElement& noise, UrdfLog& log) {
  sensors::SignalSpec signal;
  const std::string type = type_of(noise);
  if (type == "none") return signal;
  const bool quantized = type == "gaussian_quantized";
  if (type != "gaussian" && !quantized) log.warn(noise, fmt::format("type '{}' of noise is taken for gaussian", type));
  signal.mean = number(noise, "mean");
  signal.noise = deviation(noise, "stddev");
  signal.bias_mean = number(noise, "bias_mean");
  signal.bias = deviation(noise, "bias_stddev");
  const double walk = deviation(noise, "dynamic_bias_stddev");
  const double time = deviation(noise, "dynamic_bias_correlation_time");
  // A first-order Gauss-Markov process: without a time it would be a random walk, which the format does not mean.
  if (walk > 0 && time > 0) {
    signal.bias_random_walk = walk;
    signal.bias_correlation_time = time;
  } else if (walk > 0 || time > 0) {
    log.unused(noise, "noise/dynamic_bias", "a dynamic bias needs both its deviation and its correlation time");
  }
  const double precision = deviation(noise, "precision");
  if (quantized) {
    signal.resolution = precision;
  } else if (precision > 0) {
    log.unused(noise, "noise/precision", "precision is that of noise of type gaussian_quantized only");
  }
  return signal;
}

void read_axes(const files::XmlElement& parent, const char* quantity, const std::string& output,
               robot_formats::SensorDescription& description, UrdfLog& log) {
  const auto inside = only_child(parent, quantity);
  if (!inside) return;
  constexpr std::array names{"x", "y", "z"};
  std::array<sensors::SignalSpec, 3> axes;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const auto axis = only_child(*inside, names[i]);
    const auto noise = axis ? only_child(*axis, "noise") : std::nullopt;
    if (noise) axes[i] = read_noise(*noise, log);
  }
  // One for all axes where they agree, so that reports show one line instead of three.
  if (axes[0] == axes[1] && axes[0] == axes[2]) {
    if (axes[0] != sensors::SignalSpec{}) description.signals[output] = axes[0];
    return;
  }
  for (std::size_t i = 0; i < axes.size(); ++i) description.signals[output + "." + names[i]] = axes[i];
}

}  // namespace murosimf::robot_formats::urdf
