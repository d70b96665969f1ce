/// team_gateway.h - a way for messages of teams out of the simulation and into it.
#pragma once

#include <string>
#include <vector>

#include "murosimf/connect/message_box.h"

namespace murosimf::connect {

struct ExternalMessage {
  std::string team, bytes;
};

class TeamGateway {
 public:
  virtual ~TeamGateway() = default;

  /// At the beginning of the tick at `now`: what has come from outside meanwhile; every robot of the team gets it.
  [[nodiscard]] virtual std::vector<ExternalMessage> take(Duration now) = 0;
  /// What a robot of the team has sent, before the radio has done anything to it.
  virtual void give(const std::string& team, const TeamMessage& message) = 0;
};

}  // namespace murosimf::connect
