#include "murosimf/component_files/sensor_keys.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/math/roll_pitch_yaw.h"
#include "murosimf/model/error.h"

namespace murosimf::component_files {
namespace {

using sensors::SensorSpec;
using sensors::SignalSpec;

constexpr double degree = std::numbers::pi / 180;
constexpr double farthest_place = 1e4;  // [m]
constexpr double latest_phase = 0.999;
constexpr double lowest_rate = 1e-3, highest_rate = 1e6;  // [Hz] nanoseconds count them exactly
constexpr double longest_delay = 10;                      // [s]

/// A value in the type of an option; lists that are not vectors are refused.
OptionValue option_value(const OptionInfo& option, const SensorValue& value) {
  if (const double* number = std::get_if<double>(&value.is)) return *number;
  if (const bool* truth = std::get_if<bool>(&value.is)) return *truth;
  if (const auto* text = std::get_if<std::string>(&value.is)) return *text;
  const auto* numbers = std::get_if<std::vector<double>>(&value.is);
  if (numbers && numbers->size() == 3) return Vec3d{(*numbers)[0], (*numbers)[1], (*numbers)[2]};
  const bool vector = std::holds_alternative<Vec3d>(option.fallback);
  fail(value.where, fmt::format("'{}' is a list; it must be {}", option.name,
                                vector ? "three numbers in brackets" : fmt::format("a {}", type_name(option))));
}

const OptionInfo& range_key() {
  static const OptionInfo key{"range", any_number, "unit", "saturation from -range to range", above(0)};
  return key;
}

void take_range(SignalSpec& signal, const SensorValues& values) {
  const SensorValue& value = values.at("range");
  if (values.contains("lowest") || values.contains("highest")) {
    fail(value.where, "'range' says the same as 'lowest' and 'highest'; keep one");
  }
  const double range = std::get<double>(checked_value(range_key(), value));
  signal.lowest = -range;
  signal.highest = range;
}

}  // namespace

void fail(std::string_view where, std::string_view message) { throw SetupError(fmt::format("{}: {}", where, message)); }

OptionValue checked_value(const OptionInfo& option, const SensorValue& value) {
  const OptionValue typed = option_value(option, value);
  const auto* text = std::get_if<std::string>(&typed);
  if (text && text->empty())
    fail(value.where, fmt::format("'{}' is empty: leave it out, or name something", option.name));
  with_context(value.where, [&] { check_option(option, typed); });
  return typed;
}

double finite_number(const std::string& key, const SensorValue& value) {
  const double* number = std::get_if<double>(&value.is);
  if (!number || !std::isfinite(*number)) fail(value.where, fmt::format("'{}' must be a finite number", key));
  return *number;
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
  // A name twice would give two outputs for one object.
  for (auto name = names->begin(); name != names->end(); ++name) {
    if (std::find(names->begin(), name, *name) != name) {
      fail(value.where, fmt::format("'{}' stands twice in '{}'", *name, key));
    }
  }
  return *names;
}

const OptionTable<SensorSpec>& sensor_keys() {
  static const OptionTable<SensorSpec> table{
      {"type", &SensorSpec::type, "", "murosimf list sensors; with it the table is a sensor of its own"},
      {"part", &SensorSpec::part, "", "murosimf list parts, or a file: where its numbers start from"},
      {"frame", &SensorSpec::frame, "", "body, joint, site or frame that it is mounted on; without it the base"},
      {"position", &SensorSpec::position, "m", "of the sensor in that frame", 0, farthest_place},
      {"rpy_deg", [](const SensorSpec& of) { return OptionValue((1 / degree) * roll_pitch_yaw(of.orientation)); },
       [](const OptionValue& value, SensorSpec& of) {
         of.orientation = from_roll_pitch_yaw(degree * std::get<Vec3d>(value));
       },
       "deg", "roll, pitch, yaw of its axes about the fixed axes of that frame"},
      {"mounting_error_deg", [](const SensorSpec& of) { return OptionValue((1 / degree) * of.mounting_error); },
       [](const OptionValue& value, SensorSpec& of) { of.mounting_error = degree * std::get<Vec3d>(value); }, "deg",
       "roll, pitch, yaw by which its true axes are turned from these"},
      {"rate", &SensorSpec::rate, "Hz", "of samples; without it one in every step", lowest_rate, highest_rate},
      {"phase", &SensorSpec::phase, "1", "of the time between two samples, when the first one is taken", 0,
       latest_phase},
      {"delay", &SensorSpec::delay, "s", "from the sample until control software can read it", 0, longest_delay},
  };
  return table;
}

const std::vector<OptionInfo>& signal_keys() {
  static const std::vector<OptionInfo> keys = [] {
    std::vector<OptionInfo> all = sensors::signal_options().infos();
    all.push_back(range_key());
    return all;
  }();
  return keys;
}

void change_signal(SignalSpec& signal, const SensorValues& values) {
  if (values.contains("range")) take_range(signal, values);
  // A part may give one of both; the table's own key replaces it.
  if (values.contains("bits") && !values.contains("resolution")) signal.resolution = 0;
  if (values.contains("resolution") && !values.contains("bits")) signal.bits = 0;
  OptionValues given;
  for (const auto& [name, value] : values) {
    const OptionInfo* key = find_option(signal_keys(), name);
    if (!key) fail(value.where, unknown_name("key of a sensor's output", name, option_names(signal_keys())));
    if (name != "range") given.emplace(name, checked_value(*key, value));
  }
  sensors::signal_options().apply(given, signal);
}

std::string signal_toml(const SignalSpec& signal) {
  const std::vector<OptionInfo>& keys = sensors::signal_options().infos();
  const std::vector<OptionValue> values = sensors::signal_options().values(signal);
  MUROSIMF_ASSERT(keys.size() == values.size());
  const bool symmetric = signal.lowest == -signal.highest && std::isfinite(signal.highest);
  std::string text;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const bool bound = keys[i].name == "lowest" || keys[i].name == "highest";
    const double number = std::get<double>(values[i]);
    // `range` stands for both bounds where they are symmetric.
    if (number != std::get<double>(keys[i].fallback) && !(bound && symmetric)) {
      text += fmt::format("{} = {}\n", keys[i].name, number);
    }
  }
  return text + (symmetric ? fmt::format("range = {}\n", signal.highest) : "");
}

}  // namespace murosimf::component_files
