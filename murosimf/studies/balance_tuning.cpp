#include "murosimf/studies/balance_tuning.h"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "murosimf/files/file_access.h"
#include "murosimf/locomotion/gait_feedback.h"
#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/locomotion/leg.h"
#include "murosimf/locomotion/walk_options.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"
#include "murosimf/recording/attached_files.h"
#include "murosimf/studies/tuned_numbers.h"

namespace murosimf::studies {
namespace {

constexpr double balance_sigma = 0.06;  // [1] of the width of each number's bounds

std::vector<TunedNumber> balance_numbers(const Model& model) {
  std::vector<TunedNumber> all =
      walk_numbers(model, locomotion::walk_option_values(locomotion::balanced_walk(model, {})));
  for (TunedNumber& one : feedback_numbers(model)) all.push_back(std::move(one));
  return all;
}

/// A share of the momentum of a pendulum as long as the leg: robots of all sizes are pushed about equally hard for their balance.
double usual_impulse(const Model& model) {
  constexpr double g = 9.81, share = 0.45;  // [m/s^2], [1]
  const auto& leg = locomotion::legs_of(model)[0];
  double mass = 0;
  for (const int object : model.having(properties::mass)) mass += *model.find(properties::mass, object);
  return share * mass * std::sqrt(g * (leg.thigh + leg.shin));
}

std::string what_balances(const BalanceTuningOptions& options, double impulse, const files::FilesRead& read) {
  const nlohmann::json what{{"program", options.budget.program},
                            {"search", "balance"},
                            {"model", options.model},
                            {"levels", options.levels},
                            {"speed", options.speed},
                            {"impulse", impulse},
                            {"duration", options.duration},
                            {"learning", {options.learning.duration, options.learning.rounds}},
                            {"cases", options.cases},
                            {"seed", options.budget.seed},
                            {"lenient", options.common.lenient},
                            {"files", recording::files_now(read.list(), {read.list(), {}}).list.values}};
  return what.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::vector<TuningCheck> check_balances(const VariedRobot& robot, const BalanceTask& task,
                                        const BalanceTuningOptions& options, const BalanceTuning& tuning) {
  const auto cases = tuning_cases(options.levels, options.checks, options.budget.seed, "tuning checks");
  const auto outcomes = balance_trials(robot, task, {tuning.before, tuning.after}, cases);
  if (outcomes.empty()) return {};
  MUROSIMF_ASSERT(outcomes.size() == 2 && options.checks > 0);
  std::vector<TuningCheck> checks;
  // Cases come level by level: every `checks` of them a new row begins.
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (i % options.checks == 0)
      checks.push_back({.level = cases[i].level, .runs = options.checks * robots_of_a_balance});
    MUROSIMF_ASSERT(!checks.empty());
    checks.back().before += outcomes[0].stood[i];
    checks.back().after += outcomes[1].stood[i];
  }
  return checks;
}

OptionValues without(OptionValues values, const OptionValues& others) {
  for (const auto& [name, value] : others) values.erase(name);
  return values;
}

}  // namespace

BalanceTuning tune_balance(const BalanceTuningOptions& options) {
  if (options.cases == 0 || options.checks == 0) throw SetupError("a walk that is pushed needs cases");
  if (!(options.speed > 0) || !(options.duration > 4) || (options.impulse && !(*options.impulse > 0)))
    throw SetupError("a walk that is pushed needs a speed and an impulse above 0, and more than 4 s");
  refuse_levels_that_stand(options.levels, "pushes move nothing");
  const auto read = std::make_shared<files::FilesRead>();
  const files::FileScope noting({.noted = read});
  const VariedRobot robot(options.model, options.common.lenient);
  const std::vector<TunedNumber> numbers = balance_numbers(robot.model());
  BalanceTuning tuning;
  tuning.impulse = options.impulse.value_or(usual_impulse(robot.model()));
  const BalanceTask task{.speed = options.speed,
                         .impulse = tuning.impulse,
                         .duration = options.duration,
                         .learning = options.learning,
                         .threads = options.common.threads,
                         .stop = options.common.stop};
  const auto cases = tuning_cases(options.levels, options.cases, options.budget.seed, "tuning");
  const CostsOf costs_of = [&](const std::vector<std::vector<double>>& points) {
    std::vector<OptionValues> candidates;
    for (const auto& point : points) candidates.push_back(values_at(numbers, point));
    std::vector<double> costs;
    for (const BalanceOutcome& one : balance_trials(robot, task, candidates, cases))
      costs.push_back(mean_and_worst(one.costs, options.levels.size()));
    return costs;
  };
  CostSearchOptions search{.space = space_of(numbers, balance_sigma), .evaluations = options.budget.evaluations};
  search.space.population = population_for(numbers.size());
  search.space.seed = options.budget.seed;
  search.minutes = options.budget.minutes;
  search.state = options.budget.state;
  search.what = what_balances(options, tuning.impulse, *read);
  search.stop = task.stop;
  search.progress = options.budget.progress;

  tuning.before = values_at(numbers, search.space.start);
  tuning.search = search_cost(search, costs_of);
  tuning.after = values_at(numbers, tuning.search.best);
  if (const OptionValues* own = robot.model().find(properties::given_balance, 0))
    tuning.kept = without(*own, tuning.after);
  tuning.steps = steps_for(robot, tuning.after, task.learning, task.threads, {}).table;
  if (!tuning.search.stopped) tuning.checks = check_balances(robot, task, options, tuning);
  return tuning;
}

std::string to_text(const BalanceTuning& tuning) {
  return fmt::format("{}\npushed with {:.3g} N s, 0.75 to 1.15 of it\n{}", search_text(tuning.search), tuning.impulse,
                     checks_text(tuning.checks, "runs without a fall"));
}

std::string to_toml(const BalanceTuning& tuning, const std::string& how, const std::string& steps) {
  std::string text = as_comment(how + "\n" + to_text(tuning)) + fmt::format("[balance]\nsteps = \"{}\"\n", steps);
  for (const auto& [name, value] : tuning.kept) text += fmt::format("{} = {:.5g}\n", name, std::get<double>(value));
  // In the order of the options, so that files of different searches can be compared line by line.
  for (const OptionInfo& info : locomotion::balanced_walk_options()) {
    const auto value = tuning.after.find(info.name);
    if (value == tuning.after.end()) continue;
    text += fmt::format("{} = {:.5g}   # [{}] {:.5g} before\n", info.name, std::get<double>(value->second), info.unit,
                        number_in(tuning.before, info.name));
  }
  return text;
}

}  // namespace murosimf::studies
