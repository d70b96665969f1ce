/// inspection_feed.h - asks a running session again and again what is to be seen of it, and keeps the last answer.
///
/// Only one inspection is on its way at a time. Between asking and answering time may jump (SessionStatus::jumps): then nothing is
/// known of the events before.
#pragma once

#include <chrono>
#include <cstdint>
#include <future>
#include <memory>

#include "murosimf/session/session.h"
#include "murosimf/viewer/event_book.h"
#include "murosimf/viewer/inspection.h"

namespace murosimf::viewer {

class InspectionFeed {
 public:
  InspectionFeed() = default;
  /// `first`: made when the scene was.
  explicit InspectionFeed(Inspection first) : seen_(std::move(first)) {}

  [[nodiscard]] const Inspection& seen() const noexcept { return seen_; }
  [[nodiscard]] const EventBook& events() const noexcept { return events_; }
  void goal(double time, int branch, std::string text) { events_.goal(time, branch, std::move(text)); }

  [[nodiscard]] bool is_asked() const noexcept { return asked_.valid(); }
  [[nodiscard]] bool has_answer() const;
  /// Whether it is time to ask again, and nothing is on its way.
  [[nodiscard]] bool is_due() const;
  /// Asks, and not again for a `period` of wall time unless asked to. What is known of events is added to the request.
  void ask(session::Session& session, const session::SessionStatus& status, InspectionRequest request,
           std::chrono::steady_clock::duration period);
  /// Once has_answer(): from now on it is seen(). Throws SetupError if there is none after all.
  Inspection& take(const session::SessionStatus& status);

 private:
  Inspection seen_;
  std::shared_ptr<Inspection> coming_;
  std::future<void> asked_;
  std::chrono::steady_clock::time_point next_;
  std::uint64_t jumps_asked_ = 0, jumps_seen_ = 0;
  EventBook events_;
};

}  // namespace murosimf::viewer
