#include "murosimf/runtime/outside_notes.h"

#include <algorithm>

namespace murosimf {

const OutsideNotes::Channel* OutsideNotes::find(std::string_view name) const {
  const auto found = channels_.find(name);
  return found == channels_.end() ? nullptr : &found->second;
}

std::vector<std::string> OutsideNotes::names() const {
  std::vector<std::string> names;
  for (const auto& [name, notes] : channels_) names.push_back(name);
  return names;
}

bool OutsideNotes::empty() const {
  return std::ranges::all_of(channels_, [](const auto& channel) { return channel.second.empty(); });
}

std::vector<std::pair<std::string, OutsideNote>> OutsideNotes::take() {
  std::vector<std::pair<std::string, OutsideNote>> taken;
  for (auto& [name, notes] : channels_) {
    for (OutsideNote& note : notes) taken.emplace_back(name, std::move(note));
    notes.clear();
  }
  return taken;
}

}  // namespace murosimf
