#include "murosimf/league/game_task.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "murosimf/control_software/software_report.h"
#include "murosimf/league/robot_status.h"
#include "murosimf/league/rule_names.h"
#include "murosimf/league/soccer_packet.h"
#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"
#include "murosimf/soccer/behavior_properties.h"

namespace murosimf::league {
namespace {

constexpr Duration watch_period = std::chrono::milliseconds(500);
constexpr Duration report_period = std::chrono::seconds(1);
constexpr double farthest = 0.5;  // [m] tolerated distance of a penalized robot from its place

constexpr int timeout = 3, set_play_begins = 4, ball_is_placed = 0;  // secondary states and phase

/// Penalties after which robots stay where they are.
bool stays_there(int penalty) {
  return penalty == static_cast<int>(SoccerPenalty::motion_in_set) ||
         penalty == static_cast<int>(SoccerPenalty::motion_in_stop);
}

double seen_from(int own, int team) { return team == no_team ? -1 : team == own ? 1 : 0; }

}  // namespace

/// Member by member: padding bytes are indeterminate.
static void state(StateArchive& archive, GameState& game) {
  archive(game.protocol, game.state, game.first_half, game.stopped, game.phase, game.kick_off_team);
  archive(game.secondary_state, game.secondary_team, game.secondary_phase, game.seconds_left,
          game.secondary_seconds_left, game.teams);
}

GameTask::GameTask(Setup& setup, const std::vector<Player>& players, Referee& referee, Options options)
    : options_(std::move(options)), referee_(&referee), holds_(players.size()) {
  MUROSIMF_ASSERT(std::ranges::all_of(players, [](const Player& player) {
    return player.robot != nullptr && player.team < 2 && player.number >= 1 &&
           static_cast<std::size_t>(player.number) <= most_players;
  }));
  for (const Player& player : players) members_.push_back(member(setup.of(*player.robot), player));
  if (options_.ball) ball_ = setup.of(*options_.ball).read(properties::position);
}

GameTask::Member GameTask::member(Setup setup, const Player& player) const {
  Member member{.player = player, .r = setup.read(properties::position), .R = setup.read(properties::orientation)};
  const Entity& robot = setup.entity();
  if (robot.find(control_software::game_view)) member.view = &setup.write(control_software::game_view)[0];
  if (robot.find(control_software::game_answer)) member.answer = &setup.read(control_software::game_answer)[0];
  if (robot.find(properties::pose_estimate)) member.estimate = &setup.read(properties::pose_estimate)[0];
  if (robot.find(properties::halted) && !robot.find(control_software::software_interface)) {
    member.halted = &setup.write(properties::halted)[0];
  }
  return member;
}

/// A run that begins anew waits for the first word of the referee again.
void GameTask::initialize() {
  game_ = {};
  words_ = 0;
  next_report_ = {};
  holds_.assign(members_.size(), {});
  events_.clear();
  for (Member& member : members_) {
    if (member.view) *member.view = {};
    if (member.halted) *member.halted = 0;
  }
}

/// A robot that enters has no penalty until the next word of the referee.
void GameTask::entity_entered(const Entity& entity) {
  for (std::size_t i = 0; i < members_.size(); ++i) {
    if (members_[i].player.robot != &entity) continue;
    holds_[i] = {};
    if (members_[i].view) *members_[i].view = {};
  }
}

const PlayerState& GameTask::state_of(const Player& player) const {
  MUROSIMF_ASSERT(player.team < place_of_team_.size() && place_of_team_[player.team] < game_.teams.size());
  return game_.teams[place_of_team_[player.team]].players[static_cast<std::size_t>(player.number - 1)];
}

void GameTask::step(const Instant& instant) noexcept {
  MUROSIMF_ASSERT(holds_.size() == members_.size());
  for (const GameState& game : referee_->take(instant.now)) {
    if (find_teams(game)) hear(game, instant.now);
  }
  if (words_ > 0 && game_.protocol >= first_soccer_version && instant.now >= next_report_) {
    report();
    next_report_ = instant.now + report_period;
  }
  for (std::string& line : referee_->complaints()) complaints_.push_back(std::move(line));
  if (instant.now % watch_period == Duration{}) watch_placed();
  ask();
}

std::optional<std::array<std::uint8_t, 2>> places_of_teams(const GameState& game, const std::array<int, 2>& numbers) {
  std::array<std::uint8_t, 2> places{0, 1};
  for (std::size_t team = 0; team < 2; ++team) {
    const auto found = std::ranges::find(game.teams, numbers[team], &TeamState::number);
    if (numbers[team] != 0) places[team] = static_cast<std::uint8_t>(found - game.teams.begin());
  }
  if (numbers[0] == 0 && numbers[1] != 0) places[0] = static_cast<std::uint8_t>(1 - places[1]);
  if (numbers[1] == 0 && numbers[0] != 0) places[1] = static_cast<std::uint8_t>(1 - places[0]);
  // 0 + 1: both were found, and are different
  return places[0] + places[1] == 1 ? std::optional(places) : std::nullopt;
}

/// Assigns the referee's teams to those of the scene. False if they are others.
bool GameTask::find_teams(const GameState& game) {
  if (const auto places = places_of_teams(game, options_.team_numbers)) {
    place_of_team_ = *places;
    return true;
  }
  if (!std::exchange(told_of_teams_, true)) {
    complaints_.push_back(
        fmt::format("the referee has the teams {} and {}, the scene has {} (number {}) and {} (number {}); "
                    "what it says is ignored",
                    game.teams[0].number, game.teams[1].number, options_.team_names[0], options_.team_numbers[0],
                    options_.team_names[1], options_.team_numbers[1]));
  }
  return false;
}

void GameTask::hear(const GameState& game, Duration now) {
  const GameState before = std::exchange(game_, game);
  if (words_++ == 0) events_.push_back("game: the referee is there");
  publish_changes(before);
  for (std::size_t i = 0; i < members_.size(); ++i) {
    show(members_[i], now);
    judge(i);
    if (members_[i].halted) *members_[i].halted = may_move(members_[i].player) ? 0 : 1;
  }
  if (game_.protocol < first_soccer_version) answer();
}

bool GameTask::may_move(const Player& player) const {
  const bool plays = game_.state == 3 && !game_.stopped && game_.phase != timeout;
  const bool places_ball = game_.secondary_state >= set_play_begins && game_.secondary_phase == ball_is_placed;
  return plays && !places_ball && state_of(player).penalty == 0;
}

void GameTask::show(Member& member, Duration now) const {
  if (!member.view) return;
  const TeamState& own = game_.teams[place_of_team_[member.player.team]];
  const TeamState& other = game_.teams[1 - place_of_team_[member.player.team]];
  const PlayerState& player = state_of(member.player);
  control_software::GameView& view = *member.view;
  view.time = now.count();
  view.samples = words_;
  view.state = game_.state;
  view.secondary_state = game_.secondary_state;
  view.secondary_team = seen_from(own.number, game_.secondary_team);
  view.secondary_phase = game_.secondary_phase;
  view.half = game_.first_half ? 1 : 2;
  view.kick_off = seen_from(own.number, game_.kick_off_team);
  view.remaining = game_.seconds_left;
  view.secondary_remaining = game_.secondary_seconds_left;
  view.stopped = game_.stopped ? 1 : 0;
  view.phase = game_.phase;
  view.message_budget = own.message_budget;
  view.version = game_.protocol;
  view.penalty = player.penalty;
  view.penalty_remaining = player.seconds_left;
  view.team = own.number;
  view.number = member.player.number;
  view.score = {static_cast<double>(own.score), static_cast<double>(other.score)};
  view.cards = {static_cast<double>(player.warnings), static_cast<double>(player.yellow_cards),
                static_cast<double>(player.red_cards)};
}

/// Only changes count. Some penalties take the robot off the field, others leave it where it stands.
void GameTask::judge(std::size_t number) {
  MUROSIMF_ASSERT(number < members_.size() && number < holds_.size());
  const Player& player = members_[number].player;
  const bool penalized = state_of(player).penalty != 0;
  Hold& hold = holds_[number];
  if (penalized == hold.penalized) return;
  const bool leaves = penalized && !stays_there(state_of(player).penalty);
  hold = {.penalized = penalized, .wants_place = leaves && options_.place_penalized};
  events_.push_back(penalized
                        ? fmt::format("game: {}: {}", player.robot->name(), penalty_name(state_of(player).penalty))
                        : fmt::format("game: {}: the penalty has ended", player.robot->name()));
}

/// Only what differs from the word before: referees repeat their state twice per second.
void GameTask::publish_changes(const GameState& before) {
  if (words_ == 1 || game_.state != before.state) events_.push_back(fmt::format("game: {}", state_name(game_.state)));
  if (game_.secondary_state != before.secondary_state) {
    events_.push_back(fmt::format("game: {}", secondary_state_name(game_.secondary_state)));
  }
  std::array<int, 2> scores{}, scores_before{};
  for (std::size_t team = 0; team < 2; ++team) {
    scores[team] = game_.teams[place_of_team_[team]].score;
    scores_before[team] = before.teams[place_of_team_[team]].score;
  }
  if (scores == scores_before) return;
  events_.push_back(
      fmt::format("game: {} {}, {} {}", options_.team_names[0], scores[0], options_.team_names[1], scores[1]));
}

/// Robots that are absent do not answer, as if they were switched off.
void GameTask::answer() const {
  for (const Member& member : members_) {
    if (member.player.robot->idle()) continue;
    const int message = static_cast<int>(std::lround(member.answer ? *member.answer : control_software::answer_alive));
    referee_->answer({game_.teams[place_of_team_[member.player.team]].number, member.player.number, message});
  }
}

/// Units are those of the protocol.
void GameTask::report() const {
  for (const Member& member : members_) {
    const std::size_t team = member.player.team;
    if (member.player.robot->idle()) continue;
    const bool sees_ball = !ball_.empty() && options_.ball->present();
    RobotStatus status = status_of({.position = member.r[0],
                                    .axes = member.R[0],
                                    .estimate = member.estimate,
                                    .ball = sees_ball ? &ball_[0] : nullptr,
                                    .attacks = options_.attacks[team]});
    status.team = game_.teams[place_of_team_[team]].number;
    status.player = member.player.number;
    referee_->report(status);
  }
}

void GameTask::watch_placed() {
  for (std::size_t i = 0; i < members_.size(); ++i) {
    const Vec3d way = members_[i].r[0] - holds_[i].place;
    if (holds_[i].placed && std::hypot(way.x, way.y) > farthest) holds_[i].wants_place = true;
  }
}

void GameTask::ask() {
  const bool any_place = std::ranges::any_of(holds_, &Hold::wants_place);
  if (!any_place && events_.empty() && complaints_.empty()) return;
  MUROSIMF_ASSERT(options_.ask_for_call != nullptr);
  options_.ask_for_call();
}

void GameTask::between_steps(Scene& scene) {
  for (std::string& event : std::exchange(events_, {})) scene.record(std::move(event));
  for (std::string& line : std::exchange(complaints_, {})) scene.warn(std::move(line));
  for (std::size_t i = 0; i < members_.size(); ++i) {
    Hold& hold = holds_[i];
    if (!std::exchange(hold.wants_place, false) || members_[i].player.robot->idle()) continue;
    try {
      hold.place = scene.place(members_[i].player).position;
      hold.placed = true;
    } catch (const SetupError& error) {
      scene.warn(error.what());
    }
  }
}

void GameTask::state(StateArchive& archive) {
  archive(game_, place_of_team_, words_, next_report_);
  archive.elements(std::span(holds_));
  archive(events_);
  if (archive.loads()) ask();
}

}  // namespace murosimf::league
