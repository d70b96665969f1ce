#include "murosimf/series/walk_tuning.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/files/data_path.h"
#include "murosimf/locomotion/gait_seed.h"
#include "murosimf/model/error.h"
#include "murosimf/robot/robot_reader.h"
#include "murosimf/series/sweep.h"
#include "murosimf/series/text_table.h"

namespace murosimf::series {
namespace {

constexpr std::array around{0.7, 1.0, 1.5};      // [1] of the lift
constexpr std::array quickness{0.8, 1.0, 1.25};  // [1] of the period
constexpr std::array rolls{0.0, 0.025, 0.05};    // [rad]
constexpr std::size_t shown = 10;

ModelPtr read_model(const WalkTuningOptions& options) {
  const auto file = files::find_data_file(options.model, "models", ".xml");
  return robot::read_robot(file, {.lenient = options.common.lenient}).model;
}

std::vector<std::string> texts(const auto& factors, double of) {
  std::vector<std::string> values;
  for (const double factor : factors) values.push_back(fmt::format("{:.4g}", factor * of));
  return values;
}

/// Levels change last, so that the walks of a combination stand together.
SweepOptions sweep_of(const WalkTuningOptions& options, const Model& model) {
  const locomotion::WalkParameters seed = locomotion::seeded_parameters(model);
  const std::string base = model.objects()[0].name;
  SweepOptions sweep{.scene = "walk",
                     .axes = {{"walker.options.lift", texts(around, seed.lift)},
                              {"walker.options.hip_roll", texts(rolls, 1)},
                              {"walker.options.period", texts(quickness, seed.period)},
                              {"walker.level", options.levels}},
                     .duration = options.duration,
                     .results = {"walker.falls", fmt::format("walker.{}.position", base)},
                     .common = options.common,
                     .progress = options.progress};
  auto& overrides = sweep.common.overrides;
  overrides.push_back("walker.model=" + options.model);
  overrides.push_back("walker.position=[0,0]");
  overrides.push_back(fmt::format("walker.command=[{},0,0]", options.speed));
  return sweep;
}

void rate(const WalkTuningOptions& options, WalkTrial& trial) {
  const double way = options.speed * options.duration;
  for (std::size_t i = 0; i < trial.falls.size(); ++i) {
    if (trial.falls[i] > 0 || std::isnan(trial.forward[i])) ++trial.failed;
    trial.miss += std::abs(trial.forward[i] / way - 1) + std::abs(trial.sideways[i]) / way;
  }
  trial.miss /= static_cast<double>(trial.falls.size());
}

std::string numbers(const std::vector<double>& values) { return fmt::format("{:.2f}", fmt::join(values, " ")); }

}  // namespace

WalkTuning tune_walk(const WalkTuningOptions& options) {
  if (!(options.speed > 0) || !(options.duration > 0)) throw SetupError("a walk needs a speed and a duration above 0");
  if (options.levels.empty()) throw SetupError("no level to walk at");
  const Sweep done = sweep(sweep_of(options, *read_model(options)));
  WalkTuning tuning{.levels = options.levels, .stopped = done.stopped};
  const std::size_t levels = options.levels.size();
  for (std::size_t first = 0; first + levels <= done.runs.size(); first += levels) {
    const auto& values = done.runs[first].point.values;
    WalkTrial trial{.lift = std::stod(values[0]), .hip_roll = std::stod(values[1]), .period = std::stod(values[2])};
    for (std::size_t i = first; i < first + levels && done.runs[i].values.size() >= 3; ++i) {
      trial.falls.push_back(done.runs[i].values[0]);
      trial.forward.push_back(done.runs[i].values[1]);
      trial.sideways.push_back(done.runs[i].values[2]);
    }
    if (trial.falls.size() < levels) continue;  // it was stopped
    rate(options, trial);
    tuning.trials.push_back(std::move(trial));
  }
  std::ranges::stable_sort(tuning.trials, [](const WalkTrial& a, const WalkTrial& b) {
    return a.failed != b.failed ? a.failed < b.failed : a.miss < b.miss;
  });
  return tuning;
}

std::string to_text(const WalkTuning& tuning) {
  TextTable table;
  table.add({"lift [m]", "hip_roll [rad]", "period [s]", "falls", "forward [m]", "sideways [m]"});
  for (std::size_t i = 0; i < std::min(shown, tuning.trials.size()); ++i) {
    const WalkTrial& trial = tuning.trials[i];
    table.add({fmt::format("{:.4g}", trial.lift), fmt::format("{:.4g}", trial.hip_roll),
               fmt::format("{:.4g}", trial.period), fmt::format("{}", fmt::join(trial.falls, " ")),
               numbers(trial.forward), numbers(trial.sideways)});
  }
  return fmt::format("at {}:\n{}", fmt::join(tuning.levels, ", "), table.text());
}

std::string to_toml(const WalkTuning& tuning) {
  if (tuning.trials.empty()) return {};
  const WalkTrial& best = tuning.trials.front();
  return fmt::format(
      "[walk]  # murosimf tune walk: falls at {} of {} levels\nlift = {:.4g}      # [m]\nhip_roll = {:.4g}  # [rad]\n"
      "period = {:.4g}    # [s]\n",
      best.failed, tuning.levels.size(), best.lift, best.hip_roll, best.period);
}

}  // namespace murosimf::series
