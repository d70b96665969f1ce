/// team_forwarder.h - connects messages of one or more teams to real sockets (control_software/team_gateway.h).
#pragma once

#include <map>
#include <string>
#include <vector>

#include "murosimf/control_software/team_gateway.h"
#include "murosimf/league/datagrams.h"

namespace murosimf::league {

class TeamForwarder final : public control_software::TeamGateway {
 public:
  /// Messages of `team` are datagrams there; these must outlive it.
  void add(const std::string& team, Datagrams& datagrams) { teams_.emplace(team, &datagrams); }
  [[nodiscard]] bool empty() const { return teams_.empty(); }

  [[nodiscard]] std::vector<control_software::ExternalMessage> take(Duration now) override;
  void give(const std::string& team, const control_software::TeamMessage& message) override;

 private:
  std::map<std::string, Datagrams*> teams_;
};

}  // namespace murosimf::league
