/// grid.h - the runs of a sweep: every combination of values, with every seed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace murosimf::studies {

/// Values that one setting of the scene takes in turn.
struct GridAxis {
  std::string path;                 ///< as of --set: "walker.command.0"
  std::vector<std::string> values;  ///< as they were written
};

/// "PATH=A,B,C"; commas within brackets belong to a value. Throws SetupError.
[[nodiscard]] GridAxis parse_axis(const std::string& text);

/// "1..20", "3", "1,5,9..12": up to 1 000 000. Throws SetupError.
[[nodiscard]] std::vector<std::uint64_t> parse_seeds(const std::string& text);

struct GridPoint {
  std::vector<std::string> values;  ///< by axis
  std::uint64_t seed = 0;
};

/// The last axis changes before the others, the seed before all. Throws SetupError: more than 1 000 000.
[[nodiscard]] std::vector<GridPoint> points_of(const std::vector<GridAxis>& axes,
                                               const std::vector<std::uint64_t>& seeds);

}  // namespace murosimf::studies
