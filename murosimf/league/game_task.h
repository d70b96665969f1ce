/// game_task.h - algorithm: passes messages of a referee to the robots, at the beginning of a tick, and executes penalties.
///
/// Each message of the referee goes to all robots at once (control_software/game_view.h), relative to their teams; each is answered for every present
/// robot (version 12), or each robot sends its status once per second (version 18 to 20). A penalized robot is placed at the side line
/// before the next tick, and again if it walks off; it may leave when the penalty ends. Robots of built-in controllers stand while no robot may
/// move (`halted`); control software decides by itself. All of that is state; the messages themselves are external input (game_log.h).
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/control_software/game_view.h"
#include "murosimf/league/referee.h"
#include "murosimf/scene/robot_placement.h"
#include "murosimf/world/algorithm.h"
#include "murosimf/world/setup.h"

namespace murosimf::league {

/// Places of a scene's two teams in what a referee says. `numbers`: of these teams; 0: those of the referee, in its order. Nothing: the
/// referee has other teams.
[[nodiscard]] std::optional<std::array<std::uint8_t, 2>> places_of_teams(const GameState& game,
                                                                         const std::array<int, 2>& numbers);

/// A robot of the game.
struct Player {
  Entity* robot = nullptr;
  std::size_t team = 0;  ///< 0 or 1, of the scene
  int number = 0;        ///< from 1
};

class GameTask final : public Algorithm {
 public:
  struct Options {
    std::array<std::string, 2> team_names;
    std::array<int, 2> team_numbers{};    ///< 0: those of the referee, in its order
    std::array<double, 2> attacks{1, 1};  ///< of each team: +1, the goal at positive x; -1, the other one
    Entity* ball = nullptr;               ///< null: there is none
    bool place_penalized = true;
    /// Requests a call of between_steps() before the next tick.
    std::function<void()> ask_for_call;
  };
  /// Of the world. The referee must outlive it.
  GameTask(Setup& setup, const std::vector<Player>& players, Referee& referee, Options options);

  /// Actions that are possible between two steps only.
  struct Scene {
    virtual ~Scene() = default;
    virtual void record(std::string event) = 0;
    virtual void warn(std::string warning) = 0;
    /// Places the player at the side line, and returns the place; may throw SetupError.
    virtual scene::Placement place(const Player& player) = 0;
  };
  void between_steps(Scene& scene);

  [[nodiscard]] const GameState& game() const { return game_; }
  // Of the scene's teams, 0 and 1.
  [[nodiscard]] const std::string& team_name(std::size_t team) const { return options_.team_names[team]; }
  [[nodiscard]] const TeamState& team(std::size_t team) const { return game_.teams[place_of_team_[team]]; }
  [[nodiscard]] std::uint64_t words() const { return words_; }  ///< number of messages of the referee so far

  [[nodiscard]] Phase phase() const noexcept override { return Phase::survey; }
  void initialize() override;
  void entity_entered(const Entity& entity) override;
  void state(StateArchive& archive) override;
  void step(const Instant& instant) noexcept override;

 private:
  /// Effects of the game on a robot.
  struct Hold {
    bool penalized = false, wants_place = false, placed = false;
    Vec3d place;  ///< [m]
    void state(StateArchive& archive) { archive(penalized, wants_place, placed, place); }
  };
  struct Member {
    Player player;
    std::span<const Vec3d> r;
    std::span<const Mat3d> R;
    control_software::GameView* view = nullptr;  // null: its software does not read it
    const double* answer = nullptr;              // null: the default, alive
    const Vec3d* estimate = nullptr;             // null: it has no estimate of its pose
    double* halted = nullptr;                    // null: it does not walk, or its software decides
  };

  [[nodiscard]] Member member(Setup setup, const Player& player) const;
  [[nodiscard]] bool find_teams(const GameState& game);
  void hear(const GameState& game, Duration now);
  void show(Member& member, Duration now) const;
  void judge(std::size_t number);
  void publish_changes(const GameState& before);
  void answer() const;
  void report() const;
  [[nodiscard]] bool may_move(const Player& player) const;
  void watch_placed();
  void ask();
  [[nodiscard]] const PlayerState& state_of(const Player& player) const;

  Options options_;
  Referee* referee_;
  std::vector<Member> members_;
  std::span<const Vec3d> ball_;  // [m]; empty: no ball
  GameState game_;
  std::array<std::uint8_t, 2> place_of_team_{0, 1};  // in game_.teams
  std::uint64_t words_ = 0;
  Duration next_report_{};
  std::vector<Hold> holds_;              // of each member
  std::vector<std::string> events_;      // to be recorded as events
  std::vector<std::string> complaints_;  // to be reported
  bool told_of_teams_ = false;
};

}  // namespace murosimf::league
