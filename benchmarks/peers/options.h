/// options.h - the command line of the programs of a race, and their clocks.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace peers {

struct Options {
  std::filesystem::path folder;  ///< of scene.toml and description.json
  std::string setting;
  double warm = 1, seconds = 3;  ///< [s] simulated before the time counts, and while it does
  int threads = 1;
  int worlds = 1;
  bool observe = false;
};

/// `settings` that the program knows, the first of which is the usual one. Throws std::runtime_error with one line.
[[nodiscard]] Options read_options(std::span<char*> arguments, const std::vector<std::string>& settings);

[[nodiscard]] double processor_seconds();  ///< [s] of all threads of this process
[[nodiscard]] double wall_seconds();       ///< [s] since some instant

}  // namespace peers
