#include "benchmarks/peers/peer.h"

#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "benchmarks/peers/observation.h"

namespace peers {

namespace {

/// Control cycles from `begin` to before `end`; `after` each.
void run(Engine& engine, const Description& description, std::size_t begin, std::size_t end,
         const std::function<void(std::span<const double>)>& after = {}) {
  for (std::size_t cycle = begin; cycle < end; ++cycle) {
    const auto& targets = description.targets[std::min(cycle, description.targets.size() - 1)];
    engine.set_targets(targets);
    for (int i = 0; i < description.steps_per_cycle; ++i) engine.step();
    if (after) after(targets);
  }
}

nlohmann::json measure(const std::string& name, const Options& options, const Maker& make) {
  const Description description = read_description(options.folder / "description.json");
  const double cycle = description.step * description.steps_per_cycle;
  const auto warm = static_cast<std::size_t>(options.warm / cycle + 0.5);
  const std::size_t end = warm + std::max<std::size_t>(1, static_cast<std::size_t>(options.seconds / cycle + 0.5));
  const auto timed = make(description, options);
  run(*timed, description, 0, warm);
  const double processor = processor_seconds(), wall = wall_seconds();
  run(*timed, description, warm, end);
  const double per_step = 1e6 / (static_cast<double>(end - warm) * description.steps_per_cycle);
  nlohmann::json result{{"engine", name},
                        {"setting", options.setting},
                        {"us_per_step", per_step * (processor_seconds() - processor)},
                        {"wall_us_per_step", per_step * (wall_seconds() - wall)}};
  if (options.observe) {
    Observation observation;
    const auto watched = make(description, options);
    run(*watched, description, 0, warm);
    run(*watched, description, warm, end, [&](auto targets) { observation.add(watched->view(), targets); });
    result["observed"] = observation.result(cycle);
  }
  return result;
}

}  // namespace

int race(int count, char** arguments, const std::string& name, const std::vector<std::string>& settings,
         const Maker& make) {
  try {
    const Options options = read_options({arguments, static_cast<std::size_t>(count)}, settings);
    std::printf("%s\n", measure(name, options, make).dump().c_str());
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", std::filesystem::path(arguments[0]).filename().c_str(), error.what());
    return 1;
  }
}

}  // namespace peers
