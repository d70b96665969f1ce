/// sensor_values.h - values of a table of a sensor (sensor_table.h) as numbers, vectors and names.
///
/// All throw SetupError with the place of the value.
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

}  // namespace murosimf::components
