#include "murosimf/runtime/timed_calls.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/model/error.h"
#include "murosimf/world/state_archive.h"

namespace murosimf {

void TimedCalls::insert(std::vector<TimedCall>& calls, TimedCall call) {
  const auto is_later = [&](const TimedCall& other) { return other.time > call.time; };
  calls.insert(std::find_if(calls.begin(), calls.end(), is_later), std::move(call));
}

void TimedCalls::go_back_to_start() noexcept {
  later_.clear();
  scheduled_done_ = 0;
}

void TimedCalls::state(StateArchive& archive) {
  std::size_t scheduled = schedule_.size();
  archive(scheduled);
  if (scheduled != schedule_.size()) {
    throw SetupError(fmt::format("it has {} calls at given times, not {}", scheduled, schedule_.size()));
  }
  archive(scheduled_done_);
  if (scheduled_done_ > schedule_.size()) throw SetupError("it has made more calls than there are");
}

}  // namespace murosimf
