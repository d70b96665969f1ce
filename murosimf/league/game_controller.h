/// game_controller.h - a referee that is a program of its own: a GameController (game_packet.h), by datagrams.
///
/// It listens, and answers for every robot. What it cannot use it tells in one line, once for each kind of it.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "murosimf/league/datagrams.h"
#include "murosimf/league/referee.h"

namespace murosimf::league {

class GameController final : public Referee {
 public:
  /// Which must outlive it.
  explicit GameController(Datagrams& datagrams) : datagrams_(&datagrams) {}

  [[nodiscard]] std::vector<GameState> take(Duration now) override;
  void answer(const Answer& answer) override;
  void report(const RobotStatus& status) override;
  [[nodiscard]] std::vector<std::string> complaints() override;

 private:
  static constexpr std::size_t most_complaints = 10;  // so that somebody who sends noise does not fill the report

  Datagrams* datagrams_;
  std::set<std::string> told_;
  std::vector<std::string> new_complaints_;
};

}  // namespace murosimf::league
