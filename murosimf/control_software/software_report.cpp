#include "murosimf/control_software/software_report.h"

#include <algorithm>

#include "murosimf/math/assert.h"

namespace murosimf::control_software {

void SoftwareReport::count(Duration took, Duration now) noexcept {
  MUROSIMF_ASSERT(took >= Duration{});
  ++calls;
  spent += took;
  if (took > worst) {
    worst = took;
    worst_at = now;
  }
  if (budget > Duration{} && took > budget) ++over_budget;
}

void SoftwareReport::note(ProcessChanges changes, Duration now) {
  if (changes.empty()) return;
  for (std::size_t i = 0; i < process_change_names.size(); ++i) {
    if (!changes.has(static_cast<ProcessChange>(i))) continue;
    const std::string what(process_change_names[i]);
    const auto known = std::ranges::find(changed, what, &Changed::what);
    if (known == changed.end()) {
      changed.push_back({what, 1, now});
    } else {
      ++known->times;
    }
  }
}

void SoftwareReport::say(Duration now, const std::string& line) {
  if (said.size() < most_messages) {
    said.push_back({now, line});
  } else {
    ++not_kept;
  }
}

}  // namespace murosimf::control_software
