#include "murosimf/studies/walk_tuning.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "murosimf/files/file_access.h"
#include "murosimf/locomotion/gait_seed.h"
#include "murosimf/locomotion/walk_options.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/recording/attached_files.h"
#include "murosimf/studies/tuned_numbers.h"
#include "murosimf/studies/walk_trials.h"

namespace murosimf::studies {
namespace {

constexpr std::array around{0.7, 1.0, 1.5};      // [1] of the lift
constexpr std::array quickness{0.8, 1.0, 1.25};  // [1] of the period
constexpr std::array rolls{0.0, 0.025, 0.05};    // [rad]
constexpr std::size_t walks_of_a_level = 8, checked_walks = 20;
constexpr double walk_sigma = 0.1;  // [1] of the width of each number's bounds

/// Every combination of three lifts, periods and rolls.
std::vector<std::vector<double>> grid_around(const std::vector<TunedNumber>& numbers,
                                             const std::vector<double>& start) {
  const auto index = [&](std::string_view name) {
    return static_cast<std::size_t>(std::ranges::find(numbers, name, &TunedNumber::name) - numbers.begin());
  };
  const std::size_t lift = index("lift"), roll = index("hip_roll"), period = index("period");
  MUROSIMF_ASSERT(lift < numbers.size() && roll < numbers.size() && period < numbers.size());
  MUROSIMF_ASSERT(start.size() == numbers.size());
  std::vector<std::vector<double>> points;
  for (const double lifted : around) {
    for (const double rolled : rolls) {
      for (const double quick : quickness) {
        std::vector<double>& point = points.emplace_back(start);
        point[lift] = place_of(numbers[lift], lifted * numbers[lift].value);
        point[roll] = place_of(numbers[roll], rolled);
        point[period] = place_of(numbers[period], quick * numbers[period].value);
      }
    }
  }
  return points;
}

/// Forward, faster, sideways, turning.
std::array<Vec3d, 4> commands_for(const Model& model, double speed) {
  constexpr double share = 0.6;  // [1] of the largest
  const Vec3d fastest = locomotion::seeded_parameters(model).fastest;
  const double faster = fastest.x > speed ? fastest.x : 1.5 * speed;
  return {Vec3d{speed, 0, 0}, Vec3d{faster, 0, 0}, Vec3d{0, share * fastest.y, 0}, Vec3d{0, 0, share * fastest.z}};
}

std::string what_walks(const WalkTuningOptions& options, const files::FilesRead& read) {
  const nlohmann::json what{{"program", options.budget.program},
                            {"search", "walk"},
                            {"model", options.model},
                            {"levels", options.levels},
                            {"speed", options.speed},
                            {"duration", options.duration},
                            {"seed", options.budget.seed},
                            {"lenient", options.common.lenient},
                            {"files", recording::files_now(read.list(), {read.list(), {}}).list.values}};
  return what.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::vector<TuningCheck> check_walks(const VariedRobot& robot, const WalkTask& task, const WalkTuningOptions& options,
                                     const WalkTuning& tuning) {
  const auto cases = tuning_cases(options.levels, checked_walks, options.budget.seed, "tuning checks");
  const auto outcomes = walk_trials(robot, task, {tuning.before, tuning.after}, cases);
  if (outcomes.empty()) return {};
  MUROSIMF_ASSERT(outcomes.size() == 2 && outcomes[0].size() == cases.size());
  std::vector<TuningCheck> checks;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (i % checked_walks == 0) checks.push_back({.level = cases[i].level, .runs = checked_walks});
    MUROSIMF_ASSERT(!checks.empty());
    checks.back().before += outcomes[0][i].fell ? 0 : 1;
    checks.back().after += outcomes[1][i].fell ? 0 : 1;
  }
  return checks;
}

}  // namespace

WalkTuning tune_walk(const WalkTuningOptions& options) {
  if (!(options.speed > 0) || !(options.duration > 0)) throw SetupError("a walk needs a speed and a duration above 0");
  const auto read = std::make_shared<files::FilesRead>();
  const files::FileScope noting({.noted = read});
  const VariedRobot robot(options.model, options.common.lenient);
  const std::vector<TunedNumber> numbers =
      walk_numbers(robot.model(), locomotion::walk_option_values(locomotion::seeded_parameters(robot.model())));
  const WalkTask task{.commands = commands_for(robot.model(), options.speed),
                      .duration = options.duration,
                      .threads = options.common.threads,
                      .stop = options.common.stop};
  const auto cases = tuning_cases(options.levels, walks_of_a_level, options.budget.seed, "tuning");
  const CostsOf costs_of = [&](const std::vector<std::vector<double>>& points) {
    std::vector<OptionValues> candidates;
    for (const auto& point : points) candidates.push_back(values_at(numbers, point));
    std::vector<double> costs;
    for (const auto& outcomes : walk_trials(robot, task, candidates, cases)) {
      std::vector<double> all;
      for (const WalkOutcome& one : outcomes) all.push_back(one.cost);
      costs.push_back(mean_and_worst(all, options.levels.size()));
    }
    return costs;
  };
  CostSearchOptions search{.space = space_of(numbers, walk_sigma), .evaluations = options.budget.evaluations};
  search.space.population = population_for(numbers.size());
  search.space.seed = options.budget.seed;
  search.first = grid_around(numbers, search.space.start);
  search.minutes = options.budget.minutes;
  search.state = options.budget.state;
  search.what = what_walks(options, *read);
  search.stop = task.stop;
  search.progress = options.budget.progress;

  WalkTuning tuning;
  tuning.before = values_at(numbers, search.space.start);
  tuning.search = search_cost(search, costs_of);
  tuning.after = values_at(numbers, tuning.search.best);
  if (!tuning.search.stopped) tuning.checks = check_walks(robot, task, options, tuning);
  return tuning;
}

std::string to_text(const WalkTuning& tuning) {
  return search_text(tuning.search) + "\n" + checks_text(tuning.checks, "walks without a fall");
}

std::string to_toml(const WalkTuning& tuning, const std::string& how) {
  std::string text = as_comment(how + "\n" + to_text(tuning)) + "[walk]\n";
  for (const OptionInfo& info : locomotion::walk_options()) {
    const auto value = tuning.after.find(info.name);
    if (value == tuning.after.end()) continue;
    const double before = number_in(tuning.before, info.name);
    text += fmt::format("{} = {:.5g}   # [{}] {:.5g} before\n", info.name, std::get<double>(value->second), info.unit,
                        before);
  }
  return text;
}

}  // namespace murosimf::studies
