#include "benchmarks/peers/many_worlds.h"

#include <cstdio>
#include <exception>

#include <nlohmann/json.hpp>

namespace peers {
namespace {

nlohmann::json measure(const Options& options, const WorldsMaker& make) {
  const auto worlds = make(options);
  worlds->run(options.warm);
  const double processor = processor_seconds(), wall = wall_seconds();
  const double steps = worlds->run(options.seconds);
  const double wall_us = 1e6 * (wall_seconds() - wall) / steps;
  const double processor_us = 1e6 * (processor_seconds() - processor) / steps;
  return {{"engine", "MuRoSimF"},
          {"setting", options.setting},
          {"wall_us_per_step", wall_us},
          {"us_per_step", processor_us},
          {"observed", worlds->observed()}};
}

}  // namespace

int race_worlds(int count, char** arguments, const WorldsMaker& make) {
  try {
    const Options options =
        read_options({arguments, static_cast<std::size_t>(count)},
                     {"articulated_dynamics", "full_dynamics", "simplified_dynamics", "kinematic_walking"});
    std::printf("%s\n", measure(options, make).dump().c_str());
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", std::filesystem::path(arguments[0]).filename().c_str(), error.what());
    return 1;
  }
}

}  // namespace peers
