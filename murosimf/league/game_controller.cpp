#include "murosimf/league/game_controller.h"

#include <utility>

#include <fmt/format.h>

#include "murosimf/league/game_packet.h"
#include "murosimf/league/humanoid_packet.h"
#include "murosimf/league/soccer_packet.h"
#include "murosimf/model/error.h"

namespace murosimf::league {

std::vector<GameState> GameController::take(Duration now) {
  std::vector<GameState> all;
  for (const std::string& packet : datagrams_->take(now)) {
    // invalid packets must not end a run: the network is open to others
    try {
      all.push_back(read_game_packet(packet));
    } catch (const SetupError& error) {
      std::string line = fmt::format("GameController: {}; ignored", error.what());
      if (told_.size() < most_complaints && told_.insert(line).second) new_complaints_.push_back(std::move(line));
    }
  }
  return all;
}

void GameController::answer(const Answer& answer) { datagrams_->give(to_bytes(answer)); }
void GameController::report(const RobotStatus& status) { datagrams_->give(to_bytes(status)); }

std::vector<std::string> GameController::complaints() { return std::exchange(new_complaints_, {}); }

}  // namespace murosimf::league
