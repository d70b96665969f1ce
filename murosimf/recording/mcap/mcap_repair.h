/// mcap_repair.h - a whole file from what is left of a recording that was cut off or damaged.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace murosimf::recording {

struct RepairReport {
  std::string damage;     ///< what was wrong with the file, in one line; empty: nothing
  std::string other_run;  ///< of which it holds something, too, and where; empty: of none
  std::uint64_t messages = 0;
  double last_time = 0;  ///< [s] of the last message
};

/// Writes every whole chunk, attachment and metadata of `damaged` to `whole`, which is there when all of it is; both may be the same file,
/// unless that holds two runs: of these the first is written. Throws SetupError.
RepairReport repair(const std::filesystem::path& damaged, const std::filesystem::path& whole);

}  // namespace murosimf::recording
