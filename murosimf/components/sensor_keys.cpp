#include "murosimf/components/sensor_keys.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf::components {
namespace {

using sensors::SignalSpec;

struct Key {
  std::string_view name;
  double SignalSpec::*member;
  bool bound = false;  ///< of the range: may be negative or infinite
};

constexpr std::array keys{Key{"scale_error", &SignalSpec::scale_error},
                          Key{"misalignment", &SignalSpec::misalignment},
                          Key{"bias", &SignalSpec::bias},
                          Key{"bias_random_walk", &SignalSpec::bias_random_walk},
                          Key{"noise_density", &SignalSpec::noise_density},
                          Key{"noise", &SignalSpec::noise},
                          Key{"low_pass", &SignalSpec::low_pass},
                          Key{"lowest", &SignalSpec::lowest, true},
                          Key{"highest", &SignalSpec::highest, true},
                          Key{"resolution", &SignalSpec::resolution}};

void take_range(SignalSpec& signal, const SensorValues& values) {
  const SensorValue& value = values.at("range");
  if (values.contains("lowest") || values.contains("highest")) {
    fail(value.where, "'range' says the same as 'lowest' and 'highest'; keep one");
  }
  const double range = number_of("range", value);
  if (!(range > 0)) fail(value.where, "'range' must be a number above 0: from -range to range");
  signal.lowest = -range;
  signal.highest = range;
}

void take_bits(SignalSpec& signal, const SensorValue& value) {
  const double bits = number_of("bits", value);
  if (!(bits >= 0 && bits <= 32 && bits == std::floor(bits))) {
    fail(value.where, "'bits' must be a whole number from 0 to 32");
  }
  signal.bits = static_cast<int>(bits);
}

void take_number(SignalSpec& signal, const Key& key, const SensorValue& value) {
  const double number = number_of(std::string(key.name), value);
  if (!key.bound && !(number >= 0 && std::isfinite(number))) {
    fail(value.where, fmt::format("'{}' must be a finite number, at least 0", key.name));
  }
  signal.*key.member = number;
}

}  // namespace

void fail(std::string_view where, std::string_view message) { throw SetupError(fmt::format("{}: {}", where, message)); }

double number_of(const std::string& key, const SensorValue& value) {
  const double* number = std::get_if<double>(&value.is);
  if (!number || std::isnan(*number)) fail(value.where, fmt::format("'{}' must be a number", key));
  return *number;
}

double finite_number(const std::string& key, const SensorValue& value) {
  const double number = number_of(key, value);
  if (!std::isfinite(number)) fail(value.where, fmt::format("'{}' must be a finite number", key));
  return number;
}

bool flag_of(const std::string& key, const SensorValue& value) {
  const bool* truth = std::get_if<bool>(&value.is);
  if (!truth) fail(value.where, fmt::format("'{}' must be true or false", key));
  return *truth;
}

Vec3d vector_of(const std::string& key, const SensorValue& value) {
  const auto* numbers = std::get_if<std::vector<double>>(&value.is);
  const auto finite = [](double number) { return std::isfinite(number); };
  if (!numbers || numbers->size() != 3 || !std::ranges::all_of(*numbers, finite)) {
    fail(value.where, fmt::format("'{}' must be three finite numbers in brackets", key));
  }
  return {(*numbers)[0], (*numbers)[1], (*numbers)[2]};
}

std::string name_of(const std::string& key, const SensorValue& value) {
  const auto* text = std::get_if<std::string>(&value.is);
  if (!text || text->empty()) fail(value.where, fmt::format("'{}' must be a name in quotes", key));
  return *text;
}

std::vector<std::string> names_of(const std::string& key, const SensorValue& value) {
  if (std::holds_alternative<std::string>(value.is)) return {name_of(key, value)};
  const auto* names = std::get_if<std::vector<std::string>>(&value.is);
  if (!names) fail(value.where, fmt::format("'{}' must be a list of names, like [\"a\", \"b\"]", key));
  if (names->empty()) fail(value.where, fmt::format("'{}' names nothing; leave it out for all there are", key));
  for (auto name = names->begin(); name != names->end(); ++name) {
    if (std::find(names->begin(), name, *name) != name) {
      fail(value.where, fmt::format("'{}' stands twice in '{}'", *name, key));
    }
  }
  return *names;
}

std::vector<std::string_view> signal_keys() {
  std::vector<std::string_view> names;
  for (const Key& key : keys) names.push_back(key.name);
  names.insert(names.end(), {"range", "bits"});
  return names;
}

void change_signal(SignalSpec& signal, const SensorValues& values) {
  if (values.contains("range")) take_range(signal, values);
  if (values.contains("bits") && !values.contains("resolution")) signal.resolution = 0;
  if (values.contains("resolution") && !values.contains("bits")) signal.bits = 0;
  for (const auto& [name, value] : values) {
    if (name == "range") continue;
    if (name == "bits") {
      take_bits(signal, value);
      continue;
    }
    const auto key = std::ranges::find(keys, name, &Key::name);
    if (key == keys.end()) fail(value.where, unknown_name("key of a sensor's output", name, signal_keys()));
    take_number(signal, *key, value);
  }
}

std::string signal_toml(const SignalSpec& signal) {
  const SignalSpec perfect;
  std::string text;
  const bool symmetric = signal.lowest == -signal.highest && std::isfinite(signal.highest);
  for (const Key& key : keys) {
    if (signal.*key.member == perfect.*key.member || (key.bound && symmetric)) continue;
    text += fmt::format("{} = {}\n", key.name, signal.*key.member);
  }
  if (symmetric) text += fmt::format("range = {}\n", signal.highest);
  if (signal.bits != 0) text += fmt::format("bits = {}\n", signal.bits);
  return text;
}

}  // namespace murosimf::components
