#include "murosimf/runtime/event_log.h"

#include <utility>

#include "murosimf/math/assert.h"
#include "murosimf/world/state_archive.h"

namespace murosimf {

void state(StateArchive& archive, Event& event) { archive(event.time, event.text); }

void EventLog::record(Duration now, std::string text) {
  MUROSIMF_ASSERT(events_.empty() || events_.back().time <= now);
  events_.push_back({now, std::move(text)});
}

void EventLog::assign(std::span<const Event> events, std::span<const std::string> warnings) {
  events_.assign(events.begin(), events.end());
  warnings_.assign(warnings.begin(), warnings.end());
}

void EventLog::go_back_to_start() {
  warnings_.clear();
  events_.resize(events_before_start_);
}

void EventLog::state(StateArchive& archive) { archive(events_, warnings_); }

}  // namespace murosimf
