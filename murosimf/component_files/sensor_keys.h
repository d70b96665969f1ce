/// sensor_keys.h - the keys of a sensor's table (sensor_table.h) that all types have: of the sensor, and of the errors that are applied
/// to its true values (sensors/signal_spec.h).
///
/// Functions that read a value throw SetupError with the place of that value.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "murosimf/component_files/sensor_table.h"
#include "murosimf/model/option.h"

namespace murosimf::component_files {

[[noreturn]] void fail(std::string_view where, std::string_view message);

/// A value within the bounds of the option, in its type. Texts are not empty.
[[nodiscard]] OptionValue checked_value(const OptionInfo& option, const SensorValue& value);
[[nodiscard]] double finite_number(const std::string& key, const SensorValue& value);
[[nodiscard]] std::string name_of(const std::string& key, const SensorValue& value);
/// At least one name, and each once.
[[nodiscard]] std::vector<std::string> names_of(const std::string& key, const SensorValue& value);

/// Keys of every sensor: its type, place and time.
[[nodiscard]] const OptionTable<sensors::SensorSpec>& sensor_keys();

/// Keys of an output: those of sensors::signal_options, and `range`, short for lowest = -range, highest = range.
[[nodiscard]] const std::vector<OptionInfo>& signal_keys();

/// Applies the keys of a signal. Refuses unknown keys, and impossible numbers. `bits` and `resolution` replace each other.
void change_signal(sensors::SignalSpec& signal, const SensorValues& values);

/// Lines "key = number" of numbers that differ from a perfect signal, in the order of signal_keys.
[[nodiscard]] std::string signal_toml(const sensors::SignalSpec& signal);

}  // namespace murosimf::component_files
