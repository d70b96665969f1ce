/// control_table_file.h - a control table as a TOML file.
///
///     protocol = 2                      # 1 or 2; with base = "xm430_w350" all is that of the base first
///     baud_rates = [9600, 57600, 1e6]   # or baud_clock = 2e6
///     operating_modes = [1, 3, 4]
///     [units]
///     velocity = 0.02398                # [rad/s]
///     [[indirect]]
///     addresses = 168
///     data = 224
///     count = 28
///     [table]
///     fields = [
///       [7, 1, "eeprom", 1, 0, 252, "id"],                  # address, bytes, access, value, lowest, highest, name
///       [88, 2, "ram", 0, 0, 16383, "(feedforward)"],       # in brackets: kept and read back, without effect
///       [60, 2, "read", 0, -1023, 1023, "present_load", 10],   # bit 10 is the sign
///     ]
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "murosimf/serial/dynamixel/control_table.h"

namespace murosimf::serial::dynamixel {

/// Throws SetupError with file:line:column.
[[nodiscard]] ControlTable read_control_table(const std::filesystem::path& file);
/// Finds the base that a file in the folder `beside` names: one supplied with the program, else in that folder.
[[nodiscard]] std::optional<std::filesystem::path> find_base_file(const std::string& base,
                                                                  const std::filesystem::path& beside);

}  // namespace murosimf::serial::dynamixel
