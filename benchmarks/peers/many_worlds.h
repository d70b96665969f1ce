/// many_worlds.h - what the programs that step many worlds of one scene have in common: settings, clocks and the line that they print.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "benchmarks/peers/options.h"

namespace peers {

class ManyWorlds {
 public:
  virtual ~ManyWorlds() = default;
  /// Returns how many steps that were, of all worlds together; at least one each.
  virtual double run(double seconds) = 0;
  /// What the worlds did since they were made, and what they take.
  [[nodiscard]] virtual nlohmann::json observed() = 0;
};

using WorldsMaker = std::function<std::unique_ptr<ManyWorlds>(const Options&)>;

/// main() of such a program: settings are levels of robots. Prints one line of JSON: `us_per_step` (processor time of the process) and
/// `wall_us_per_step`, both of one world, and `observed`.
int race_worlds(int count, char** arguments, const WorldsMaker& make);

}  // namespace peers
