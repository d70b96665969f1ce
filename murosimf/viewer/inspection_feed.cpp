#include "murosimf/viewer/inspection_feed.h"

#include <utility>

#include "murosimf/math/assert.h"
#include "murosimf/viewer/session_requests.h"

namespace murosimf::viewer {

bool InspectionFeed::has_answer() const { return asked_.valid() && is_ready(asked_); }

bool InspectionFeed::is_due() const { return !asked_.valid() && std::chrono::steady_clock::now() >= next_; }

void InspectionFeed::ask(session::Session& session, const session::SessionStatus& status, InspectionRequest request,
                         std::chrono::steady_clock::duration period) {
  MUROSIMF_ASSERT(!asked_.valid());
  next_ = std::chrono::steady_clock::now() + period;
  jumps_asked_ = status.jumps;
  const bool is_known = jumps_asked_ == jumps_seen_;
  if (is_known) request.events_known = events_.events_known();
  request.warnings_known = is_known ? events_.warnings_known() : 0;
  coming_ = std::make_shared<Inspection>();
  asked_ = session.visit(
      [coming = coming_, request = std::move(request)](scene::Scene& scene) { *coming = inspect(scene, request); });
}

Inspection& InspectionFeed::take(const session::SessionStatus& status) {
  MUROSIMF_ASSERT(has_answer());
  asked_.get();
  const bool jumped = jumps_asked_ != jumps_seen_ || status.jumps != jumps_asked_;
  jumps_seen_ = jumps_asked_;
  seen_ = std::move(*coming_);
  events_.take(seen_, status.branch, jumped);
  return seen_;
}

}  // namespace murosimf::viewer
