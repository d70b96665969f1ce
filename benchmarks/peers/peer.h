/// peer.h - what all engines in a race have in common: the command line, the clock, and what is looked at while nobody counts time.
///
///     murosimf_peer_ode FOLDER --warm 1 --seconds 3 --setting quickstep --observe
///
/// FOLDER has scene.toml, which our own program runs, and description.json, which the others are built of. Prints one line of JSON:
/// `engine`, `setting`, `us_per_step` (processor time of the process) and with --observe what it did, under `observed`.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "benchmarks/peers/description.h"
#include "benchmarks/peers/options.h"

namespace peers {

/// What an engine shows of its state.
struct View {
  struct Robot {
    Vector position{};           ///< [m] of the base, world
    double upright = 0;          ///< [1] cosine of the angle between the base's z axis and the vertical
    std::vector<double> joints;  ///< [rad]
  };
  std::vector<Robot> robots;
  int contacts = 0;  ///< points with a depth above 0, or that the engine counts as touching
  double depth = 0;  ///< [m] of the deepest
  double gap = 0;    ///< [m] by which the widest joint has come apart; engines in joint coordinates have none
};

class Engine {
 public:
  virtual ~Engine() = default;
  /// Targets of all joints of all robots [rad], held from now on.
  virtual void set_targets(std::span<const double> targets) = 0;
  virtual void step() = 0;  ///< by Description::step
  [[nodiscard]] virtual View view() = 0;
};

using Maker = std::function<std::unique_ptr<Engine>(const Description&, const Options&)>;

/// main() of an engine: `name` with its version; `settings` that it knows, the first of which is the usual one.
int race(int count, char** arguments, const std::string& name, const std::vector<std::string>& settings,
         const Maker& make);

}  // namespace peers
