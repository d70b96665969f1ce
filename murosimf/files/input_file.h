/// input_file.h - opens files for all readers: ordinary files only, and none that is larger than the reader accepts.
///
/// Devices and pipes are refused: /dev/zero has no end, and a pipe without a writer never begins.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace murosimf::files {

// The largest files that are read [byte].
constexpr std::uintmax_t most_toml_bytes = 16'000'000;      ///< scenes, motions, tables
constexpr std::uintmax_t most_yaml_bytes = 1'000'000;       ///< calibrations
constexpr std::uintmax_t most_xml_bytes = 256'000'000;      ///< robots, meshes (COLLADA)
constexpr std::uintmax_t most_record_bytes = 256'000'000;   ///< recordings of servos
constexpr std::uintmax_t most_mesh_bytes = 512'000'000;     ///< STL, OBJ
constexpr std::uintmax_t most_state_bytes = 1'000'000'000;  ///< states of simulations
constexpr std::uintmax_t most_table_bytes = 1'000'000'000;  ///< numbers over time (CSV)

/// The size of the file [byte]. Throws SetupError, one line that begins with the file's name: there is no such file, it is
/// a folder, a device or a pipe, cannot be read, is larger than `most`, or is none that may be read (file_access.h).
std::uintmax_t check_input_file(const std::filesystem::path& file, std::uintmax_t most);

/// Its bytes. Throws SetupError likewise.
[[nodiscard]] std::string read_input_file(const std::filesystem::path& file, std::uintmax_t most);

}  // namespace murosimf::files
