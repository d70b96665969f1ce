#include "murosimf/session/own_state.h"

#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/control_software/controller_task.h"

namespace murosimf::session {

/// Names the participants whose memory is outside of the state: from there on a run cannot be the same.
std::string own_state(const World& world, const ExternalInputHistory* memory) {
  std::vector<std::string> robots, subjects;
  for (const auto& entity : world.entities()) {
    const control_software::SoftwareReport* const software = control_software::software_report(*entity);
    if (software && software->keeps_state && software->ended.empty()) robots.push_back(entity->name());
  }
  if (!robots.empty()) subjects.push_back(fmt::format("software of {}", fmt::join(robots, ", ")));
  if (memory) subjects.insert(subjects.end(), memory->others().begin(), memory->others().end());
  if (subjects.empty()) return {};
  const bool one = subjects.size() == 1 && robots.size() < 2;
  return fmt::format("{} {}", fmt::join(subjects, " and "), one ? "keeps its own state" : "keep their own state");
}

std::string own_state_from(const World& world, const ExternalInputHistory* memory, Duration time) {
  const std::string participants = own_state(world, memory);
  if (participants.empty()) return {};
  return fmt::format("{}: from {:g} s on this is not the run that was there before", participants, seconds(time));
}

}  // namespace murosimf::session
