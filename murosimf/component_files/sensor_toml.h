/// sensor_toml.h - tables of sensors from TOML (sensor_table.h).
///
/// Only for .cpp files: it brings toml++ in.
#pragma once

#include <vector>

#include "murosimf/component_files/sensor_table.h"
#include "murosimf/files/toml_reader.h"

namespace murosimf::component_files {

/// The tables of [sensors], in alphabetical order. Throws SetupError with file:line:column for other values.
[[nodiscard]] std::vector<SensorTable> read_sensor_tables(const toml::table& sensors);

/// The file of a ready-made part, as one table.
[[nodiscard]] SensorTable read_part_file(const std::filesystem::path& file);

/// Reads the key `sensors` of a robot of a scene, in addition to the `changes` of [defaults]: false (none), true (all of its
/// files), or tables. Null: no such key.
void read_sensor_changes(const toml::node* node, SensorChanges& changes);

}  // namespace murosimf::component_files
