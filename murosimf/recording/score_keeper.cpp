#include "murosimf/recording/score_keeper.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/league/game_packet.h"
#include "murosimf/league/game_task.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/recording/recorded_external_input.h"
#include "murosimf/recording/run_watch.h"

namespace murosimf::recording {
namespace {

constexpr Duration period = std::chrono::milliseconds(20);  // a ball of 20 m/s comes 0.4 m far

}  // namespace

ScoreKeeper::ScoreKeeper(const scene::Scene& scene) {
  const auto& teams = scene.spec().teams;
  if (teams.size() != attacks_.size()) {
    throw SetupError(fmt::format("a score is one of two teams, but the scene has {}", teams.size()));
  }
  for (std::size_t team = 0; team < attacks_.size(); ++team) {
    attacks_[team] = teams[team].attacks;
    numbers_[team] = static_cast<int>(teams[team].number);
  }
}

void ScoreKeeper::watch(scene::Scene& scene) {
  goal_ = goal_with_ball(scene);
  scene.simulation().at(scene.simulation().now() + period, [this, &scene] { look(scene); });
}

void ScoreKeeper::look(scene::Scene& scene) {
  const int goal = goal_with_ball(scene);
  const Duration now = scene.simulation().now();
  if (goal != 0 && goal_ == 0) add(now, goal);
  goal_ = goal;
  scene.simulation().at(now + period, [this, &scene] { look(scene); });
}

void ScoreKeeper::add(Duration time, int goal) {
  MUROSIMF_ASSERT(goal != 0 && (changes_.empty() || changes_.back().time <= time));
  std::array<int, 2> goals = at(time);
  for (std::size_t team = 0; team < goals.size(); ++team) {
    if (attacks_[team] * goal > 0) ++goals[team];
  }
  changes_.push_back({time, goals});
}

void ScoreKeeper::count(const std::vector<Moment>& moments) {
  for (const Moment& moment : moments) {
    if (moment.kind == Moment::Kind::goal) add(moment.time, moment.goal);
  }
}

/// Skips packets that are damaged or of other teams.
bool ScoreKeeper::hear(const RecordedRun& run) {
  const auto input = recorded_external_input(run.file());
  const ExternalInputLog::Channel* said = input ? input->find("game") : nullptr;
  if (!said || said->empty()) return false;
  for (const ExternalInput& packet : *said) {
    if (packet.kind != ExternalInput::sent) continue;
    try {
      const league::GameState game = league::read_game_packet(packet.bytes);
      const auto places = league::places_of_teams(game, numbers_);
      if (!places) continue;
      changes_.push_back({packet.time, {game.teams[(*places)[0]].score, game.teams[(*places)[1]].score}});
    } catch (const SetupError&) {
      continue;
    }
  }
  return true;
}

std::array<int, 2> ScoreKeeper::at(Duration time) const {
  const auto later = std::ranges::upper_bound(changes_, time, {}, &Change::time);
  return later == changes_.begin() ? std::array<int, 2>{} : std::prev(later)->goals;
}

}  // namespace murosimf::recording
