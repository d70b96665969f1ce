/// league.h - a scene as a game with external participants: a GameController as referee, sockets of teams, and a log of their input.
///
///     scene::Scene scene("three_on_three");
///     league::League game(scene, {.game_controller = league::UdpAddress{"127.0.0.1", 3838}});
///     scene.simulation().run(60s, clock);
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/league/game_log.h"
#include "murosimf/league/game_task.h"
#include "murosimf/league/team_forwarder.h"
#include "murosimf/league/udp_port.h"
#include "murosimf/scene/scene.h"

namespace murosimf::league {

/// Messages of a team go to a socket and come from one.
struct TeamLink {
  std::string team;
  UdpAddress listen, send_to;

  /// "TEAM=LISTEN,SEND", both as UdpAddress::parse. Throws SetupError with the expected form.
  [[nodiscard]] static TeamLink parse(std::string_view text);
};

struct LeagueOptions {
  std::optional<UdpAddress> game_controller{};  ///< address to listen at
  std::vector<TeamLink> team_links{};
  std::filesystem::path repeat{};  ///< a game log that replaces all sockets; empty: none
  ExternalInputOptions outside{};  ///< options of the scene: the log, and a recording that replaces all sockets
  Referee* referee = nullptr;      ///< replaces the GameController; must outlive the League
};

class League {
 public:
  /// Before the scene is initialized; must be destroyed after its last step. Throws SetupError: the scene lacks the teams, an
  /// address is in use, the log cannot be read.
  League(scene::Scene& scene, const LeagueOptions& options);
  ~League();
  League(const League&) = delete;
  League& operator=(const League&) = delete;

  /// All input so far.
  [[nodiscard]] const GameLog& log() const { return log_; }
  /// Null if there is no referee.
  [[nodiscard]] const GameTask* game() const { return task_; }
  /// Port for GameController packets, as chosen by the system if port 0 was requested; 0: none.
  [[nodiscard]] std::uint16_t game_controller_port() const { return game_port_; }

 private:
  class BetweenSteps;

  /// The source of a channel: a socket that is logged, or the log that is repeated.
  Datagrams& open(const std::string& channel, const UdpPort::Options& options);
  void referee_by(Referee& referee);
  void forward(const TeamLink& link);

  scene::Scene* scene_;
  ExternalInputOptions outside_;
  std::optional<GameLog> repeated_;
  GameLog log_;
  std::vector<std::unique_ptr<Datagrams>> datagrams_;
  TeamForwarder forwarder_;
  std::unique_ptr<Referee> referee_;
  std::unique_ptr<BetweenSteps> between_steps_;
  GameTask* task_ = nullptr;
  std::uint16_t game_port_ = 0;
};

}  // namespace murosimf::league
