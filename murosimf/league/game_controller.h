/// game_controller.h - a referee in a program of its own: a GameController (game_packet.h), by datagrams.
///
/// It listens, and answers for every robot. Each kind of invalid packet is reported once.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "murosimf/league/datagrams.h"
#include "murosimf/league/referee.h"

namespace murosimf::league {

class GameController final : public Referee {
 public:
  /// `datagrams` must outlive it.
  explicit GameController(Datagrams& datagrams) : datagrams_(&datagrams) {}

  [[nodiscard]] std::vector<GameState> take(Duration now) override;
  void answer(const Answer& answer) override;
  void report(const RobotStatus& status) override;
  [[nodiscard]] std::vector<std::string> complaints() override;

 private:
  static constexpr std::size_t most_complaints = 10;  // so that noise does not fill the report

  Datagrams* datagrams_;
  std::set<std::string> told_;
  std::vector<std::string> new_complaints_;
};

}  // namespace murosimf::league
