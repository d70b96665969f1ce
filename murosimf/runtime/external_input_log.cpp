#include "murosimf/runtime/external_input_log.h"

#include <algorithm>

namespace murosimf {

const ExternalInputLog::Channel* ExternalInputLog::find(std::string_view name) const {
  const auto found = channels_.find(name);
  return found == channels_.end() ? nullptr : &found->second;
}

std::vector<std::string> ExternalInputLog::names() const {
  std::vector<std::string> names;
  for (const auto& [name, notes] : channels_) names.push_back(name);
  return names;
}

bool ExternalInputLog::empty() const {
  return std::ranges::all_of(channels_, [](const auto& channel) { return channel.second.empty(); });
}

std::vector<std::pair<std::string, ExternalInput>> ExternalInputLog::take() {
  std::vector<std::pair<std::string, ExternalInput>> taken;
  for (auto& [name, notes] : channels_) {
    for (ExternalInput& note : notes) taken.emplace_back(name, std::move(note));
    notes.clear();
  }
  return taken;
}

}  // namespace murosimf
