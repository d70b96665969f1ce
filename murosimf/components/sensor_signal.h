/// sensor_signal.h - keys of what becomes of a sensor's true values (sensors/signal_spec.h).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "murosimf/components/sensor_table.h"

namespace murosimf::components {

/// Members of SignalSpec, and `range`, short for lowest = -range, highest = range.
[[nodiscard]] std::vector<std::string_view> signal_keys();

/// Throws SetupError with the place of the value for unknown keys and for numbers that are impossible by themselves.
/// `bits` and `resolution` take each other's place.
void change_signal(sensors::SignalSpec& signal, const SensorValues& values);

/// Lines "key = number" of what is not as in a perfect signal, in the order of signal_keys.
[[nodiscard]] std::string signal_toml(const sensors::SignalSpec& signal);

}  // namespace murosimf::components
