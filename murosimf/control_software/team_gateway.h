/// team_gateway.h - interface that carries team messages into and out of the simulation.
#pragma once

#include <string>
#include <vector>

#include "murosimf/control_software/message_box.h"

namespace murosimf::control_software {

struct ExternalMessage {
  std::string team, bytes;
};

class TeamGateway {
 public:
  virtual ~TeamGateway() = default;

  /// At the beginning of the tick at `now`: external messages since the last call; every robot of the team receives them.
  [[nodiscard]] virtual std::vector<ExternalMessage> take(Duration now) = 0;
  /// Receives a message that a robot of the team has sent, before the radio model is applied.
  virtual void give(const std::string& team, const TeamMessage& message) = 0;
};

}  // namespace murosimf::control_software
