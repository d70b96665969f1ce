/// sensor_keys.h - what the keys of a sensor's table (sensor_table.h) mean: their values as numbers, vectors and names, and
/// those that say what becomes of a sensor's true values (sensors/signal_spec.h).
///
/// What takes a value throws SetupError with the place of that value.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "murosimf/components/sensor_table.h"
#include "murosimf/math/vec3.h"

namespace murosimf::components {

[[noreturn]] void fail(std::string_view where, std::string_view message);

/// May be infinite.
[[nodiscard]] double number_of(const std::string& key, const SensorValue& value);
[[nodiscard]] double finite_number(const std::string& key, const SensorValue& value);
[[nodiscard]] bool flag_of(const std::string& key, const SensorValue& value);
[[nodiscard]] Vec3d vector_of(const std::string& key, const SensorValue& value);
[[nodiscard]] std::string name_of(const std::string& key, const SensorValue& value);
/// At least one name, and each once.
[[nodiscard]] std::vector<std::string> names_of(const std::string& key, const SensorValue& value);

/// Members of SignalSpec, and `range`, short for lowest = -range, highest = range.
[[nodiscard]] std::vector<std::string_view> signal_keys();

/// Refuses unknown keys, and numbers that are impossible by themselves. `bits` and `resolution` take each other's place.
void change_signal(sensors::SignalSpec& signal, const SensorValues& values);

/// Lines "key = number" of what is not as in a perfect signal, in the order of signal_keys.
[[nodiscard]] std::string signal_toml(const sensors::SignalSpec& signal);

}  // namespace murosimf::components
