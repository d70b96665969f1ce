#include "murosimf/league/team_forwarder.h"

#include <utility>

namespace murosimf::league {

std::vector<control_software::ExternalMessage> TeamForwarder::take(Duration now) {
  std::vector<control_software::ExternalMessage> all;
  for (const auto& [team, datagrams] : teams_) {
    for (std::string& bytes : datagrams->take(now)) all.push_back({team, std::move(bytes)});
  }
  return all;
}

void TeamForwarder::give(const std::string& team, const control_software::TeamMessage& message) {
  const auto found = teams_.find(team);
  if (found != teams_.end()) found->second->give(message.bytes);
}

}  // namespace murosimf::league
