/// event_log.h - what happened on the way: exchanges, commands, and what went wrong.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "murosimf/world/time.h"

namespace murosimf {

class StateArchive;

/// Something that happened once: a level was exchanged, or refused.
struct Event {
  Duration time{};
  std::string text;
};

/// Events and warnings are part of the state: they go back in time with it.
class EventLog {
 public:
  /// In the order of time.
  [[nodiscard]] const std::vector<Event>& events() const noexcept { return events_; }
  /// One line each.
  [[nodiscard]] const std::vector<std::string>& warnings() const noexcept { return warnings_; }

  /// `now` is not before the last event.
  void record(Duration now, std::string text);
  void warn(std::string text) { warnings_.push_back(std::move(text)); }

  /// Instead of what it has.
  void assign(std::span<const Event> events, std::span<const std::string> warnings);

  /// What has been recorded so far stays at every go_back_to_start().
  void keep_start() noexcept { events_before_start_ = events_.size(); }
  void go_back_to_start();

  void state(StateArchive& archive);

 private:
  std::vector<Event> events_;
  std::vector<std::string> warnings_;
  std::size_t events_before_start_ = 0;
};

}  // namespace murosimf
