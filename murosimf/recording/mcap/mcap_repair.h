/// mcap_repair.h - restores a complete file from a recording that was cut off or damaged.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace murosimf::recording {

struct RepairReport {
  std::string damage;     ///< error in the file, in one line; empty: nothing
  std::string other_run;  ///< another run with data in the file, and their place; empty: none
  std::uint64_t messages = 0;
  double last_time = 0;  ///< [s] of the last message
};

/// Writes every complete chunk, attachment and metadata of `damaged` to `whole`, which appears when it is complete; both may be the same file,
/// unless that contains two runs: then the first is written. Throws SetupError.
RepairReport repair(const std::filesystem::path& damaged, const std::filesystem::path& whole);

}  // namespace murosimf::recording
