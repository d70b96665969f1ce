/// sensor_toml.h - tables of sensors from TOML (sensor_table.h).
///
/// Only for .cpp files: it brings toml++ in.
#pragma once

#include <vector>

#include "murosimf/components/sensor_table.h"
#include "murosimf/files/toml_reader.h"

namespace murosimf::components {

/// The tables of [sensors], in alphabetical order. Throws SetupError with file:line:column for what is no table.
[[nodiscard]] std::vector<SensorTable> read_sensor_tables(const toml::table& sensors);

/// The file of a ready-made part, as one table.
[[nodiscard]] SensorTable read_part_file(const std::filesystem::path& file);

/// The key `sensors` of a robot of a scene, on top of what `changes` has from [defaults]: false (none), true (all of its
/// files), or tables. Null: nothing is said.
void read_sensor_changes(const toml::node* node, SensorChanges& changes);

}  // namespace murosimf::components
