#include "murosimf/viewer/event_book.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/math/assert.h"

namespace murosimf::viewer {
namespace {

bool begins_with(const std::string& text, std::string_view begin) { return text.compare(0, begin.size(), begin) == 0; }

}  // namespace

/// Marks that are reported again after a jump are known already.
void EventBook::add(TimeMark mark) {
  const auto same = [&](const TimeMark& other) {
    return other.time == mark.time && other.text == mark.text && other.kind == mark.kind;
  };
  if (std::ranges::any_of(marks_, same)) return;
  const auto place = std::ranges::upper_bound(marks_, mark.time, {}, &TimeMark::time);
  marks_.insert(place, std::move(mark));
}

void EventBook::take(const Inspection& seen, int branch, bool jumped) {
  for (const Event& event : seen.events) {
    const auto kind = begins_with(event.text, "push on ") ? TimeMark::Kind::touch : TimeMark::Kind::event;
    add({seconds(event.time), branch, kind, event.text});
  }
  events_known_ = seen.first_event + seen.events.size();
  // shorter after a jump: later warnings of the old branch are gone
  if (seen.first_warning <= warnings_.size()) warnings_.resize(seen.first_warning);
  warnings_.insert(warnings_.end(), seen.warnings.begin(), seen.warnings.end());
  for (std::size_t i = 0; i < seen.entities.size(); ++i) {
    const EntityState& entity = seen.entities[i];
    if (!jumped && i < falls_.size() && entity.falls > falls_[i]) {
      add({seconds(seen.time), branch, TimeMark::Kind::fall, fmt::format("{} has fallen", entity.name)});
    }
  }
  falls_.clear();
  for (const EntityState& entity : seen.entities) falls_.push_back(entity.falls);
  MUROSIMF_ASSERT(falls_.size() == seen.entities.size());
}

void EventBook::goal(double time, int branch, std::string text) {
  add({time, branch, TimeMark::Kind::goal, std::move(text)});
}

}  // namespace murosimf::viewer
