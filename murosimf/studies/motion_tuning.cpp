#include "murosimf/studies/motion_tuning.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/files/file_access.h"
#include "murosimf/model/error.h"
#include "murosimf/recording/attached_files.h"
#include "murosimf/robot/motion_file.h"

namespace murosimf::studies {
namespace {

using locomotion::Channel;
using locomotion::KeyframeMotion;

constexpr std::size_t cases_of_a_level = 10, checks_of_a_level = 20;

constexpr std::array goal_words{"stands", "kicks", "lies"};
const char* word_of(MotionGoal goal) { return goal_words[static_cast<std::size_t>(goal)]; }

std::string what_is_tuned(const MotionTuningOptions& options, const KeyframeMotion& motion,
                          const files::FilesRead& read) {
  const MotionTask& task = options.task;
  const nlohmann::json what{{"program", options.budget.program},
                            {"search", "motion"},
                            {"motion", motion.name},
                            {"goal", word_of(task.goal)},
                            {"start", {task.roll, task.pitch}},
                            {"direction", task.direction},
                            {"fastest", task.fastest},
                            {"ball", {task.ball.x, task.ball.y, task.ball_options.radius, task.ball_options.mass}},
                            {"levels", options.levels},
                            {"seed", options.budget.seed},
                            {"lenient", options.common.lenient},
                            {"files", recording::files_now(read.list(), {read.list(), {}}).list.values}};
  return what.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::vector<TuningCheck> check(MotionTrials& trials, const MotionTuning& tuning, const std::vector<std::string>& levels,
                               std::uint64_t seed) {
  const auto cases = tuning_cases(levels, checks_of_a_level, seed, "tuning checks");
  const auto outcomes = trials.run({tuning.before, tuning.after}, cases);
  if (outcomes.empty()) return {};
  MUROSIMF_ASSERT(outcomes.size() == 2 && outcomes[0].size() == levels.size() * checks_of_a_level);
  std::vector<TuningCheck> checks;
  for (std::size_t level = 0; level < levels.size(); ++level) {
    TuningCheck& one = checks.emplace_back(TuningCheck{.level = levels[level], .runs = checks_of_a_level});
    for (std::size_t i = level * checks_of_a_level; i < (level + 1) * checks_of_a_level; ++i) {
      one.before += outcomes[0][i].good ? 1 : 0;
      one.after += outcomes[1][i].good ? 1 : 0;
    }
  }
  return checks;
}

std::string column_text(const std::vector<Channel>& channels) {
  std::vector<std::string> names;
  for (const Channel& channel : channels)
    names.push_back(fmt::format("\"{}{}\"", channel.sign < 0 ? "-" : "", channel.name));
  return names.size() == 1 ? names[0] : fmt::format("[{}]", fmt::join(names, ", "));
}

/// As the file will have it. Durations are rounded up, so that no rate grows.
KeyframeMotion rounded(KeyframeMotion motion) {
  constexpr double digit = 1e-4;
  for (locomotion::KeyFrame& frame : motion.frames) {
    frame.duration = std::ceil(frame.duration / digit) * digit;
    for (double& value : frame.values) value = std::round(value / digit) * digit;
  }
  return motion;
}

}  // namespace

const std::vector<std::string>& usual_tuning_levels() {
  static const std::vector<std::string> levels{"simplified_dynamics", "full_dynamics", "articulated_dynamics"};
  return levels;
}

void refuse_levels_that_stand(const std::vector<std::string>& levels, const std::string& so) {
  for (const std::string& level : levels) {
    if (find_entry(catalog::levels(), "level", level).traits.dynamic) continue;
    throw SetupError(fmt::format("at level '{}' robots always stand: {}", level, so));
  }
}

std::size_t population_for(std::size_t numbers) {
  MUROSIMF_ASSERT(numbers > 0);
  const auto usual = 4 + static_cast<std::size_t>(3 * std::log(static_cast<double>(numbers)));
  // A row that is not full takes as long as one that is.
  return (usual + robots_in_a_row - 1) / robots_in_a_row * robots_in_a_row;
}

MotionTuning tune_motion(const MotionTuningOptions& options) {
  refuse_levels_that_stand(options.levels, "no motion can be tuned there");
  const auto read = std::make_shared<files::FilesRead>();
  const files::FileScope noting({.noted = read});
  const auto file = robot::find_motion(options.motion);
  const KeyframeMotion motion = robot::read_motion(file);
  const VariedRobot robot(options.model, options.common.lenient);
  MotionTask task = options.task;
  task.threads = options.common.threads;
  task.stop = options.common.stop;
  const MotionSpace space =
      with_context(file.string(), [&] { return MotionSpace(robot.model(), motion, task.fastest); });
  MotionTrials trials(robot, motion, task);
  const auto cases = tuning_cases(options.levels, cases_of_a_level, options.budget.seed, "tuning");

  const CostsOf costs_of = [&](const std::vector<std::vector<double>>& points) {
    std::vector<KeyframeMotion> motions;
    for (const auto& point : points) motions.push_back(space.motion_at(point));
    std::vector<double> costs;
    for (const auto& outcomes : trials.run(motions, cases)) {
      std::vector<double> all;
      for (const MotionOutcome& one : outcomes) all.push_back(one.cost);
      costs.push_back(mean_and_worst(all, options.levels.size()));
    }
    return costs;
  };
  CostSearchOptions search{.space = space.space(), .evaluations = options.budget.evaluations};
  search.space.population = population_for(search.space.start.size());
  search.space.seed = options.budget.seed;
  search.minutes = options.budget.minutes;
  search.state = options.budget.state;
  search.what = what_is_tuned(options, motion, *read);
  search.stop = task.stop;
  search.progress = options.budget.progress;

  MotionTuning tuning{.goal = task.goal, .before = motion, .after = motion};
  tuning.search = search_cost(search, costs_of);
  tuning.after = rounded(space.motion_at(tuning.search.best));
  tuning.rate_before = space.largest_rate(tuning.before);
  tuning.rate_after = space.largest_rate(tuning.after);
  if (!tuning.search.stopped) tuning.checks = check(trials, tuning, options.levels, options.budget.seed);
  return tuning;
}

std::string search_text(const CostSearch& search) {
  return fmt::format("cost {:.4f} before, {:.4f} after {} evaluations in {} generations", search.start_cost,
                     search.best_cost, search.evaluations, search.generations);
}

std::string checks_text(const std::vector<TuningCheck>& checks, const std::string& what) {
  if (checks.empty()) return fmt::format("it was stopped: how often it {} was not tried\n", what);
  std::string text = fmt::format("{}, of {} runs that the search did not see:\n", what, checks[0].runs);
  std::size_t width = 0;
  for (const TuningCheck& one : checks) width = std::max(width, one.level.size());
  text += fmt::format("  {:{}}  before  after\n", "", width);
  for (const TuningCheck& one : checks)
    text += fmt::format("  {:{}}  {:6}  {:5}\n", one.level, width, one.before, one.after);
  return text;
}

std::string as_comment(const std::string& text) {
  std::string all;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    all += "# " + text.substr(begin, end - begin) + "\n";
    begin = end + 1;
  }
  return all;
}

std::string to_text(const MotionTuning& tuning) {
  return fmt::format("{}\nlargest rate of a target {:.1f} rad/s before, {:.1f} after\n{}", search_text(tuning.search),
                     tuning.rate_before, tuning.rate_after, checks_text(tuning.checks, word_of(tuning.goal)));
}

std::string to_toml(const MotionTuning& tuning, const std::string& how) {
  const KeyframeMotion& motion = tuning.after;
  std::string text = as_comment(how + "\n" + to_text(tuning)) + "columns = [\n";
  for (const auto& channels : motion.columns) text += fmt::format("  {},\n", column_text(channels));
  text += fmt::format("]\nstart = [{}]\n", fmt::join(motion.start, ", "));
  if (motion.kick)
    text += fmt::format("kick = {{ball = [{}, {}], direction = {}}}\n", motion.kick->ball.x, motion.kick->ball.y,
                        motion.kick->direction);
  for (const locomotion::KeyFrame& frame : motion.frames) {
    text += fmt::format("\n[[frames]]\nduration = {:.4f}   # [s]\nvalues = [{:.4f}]\n", frame.duration,
                        fmt::join(frame.values, ", "));
  }
  return text;
}

}  // namespace murosimf::studies
