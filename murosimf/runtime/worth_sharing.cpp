#include "murosimf/runtime/worth_sharing.h"

#include <algorithm>

namespace murosimf {
namespace {

using namespace std::chrono_literals;
using Time = WorthSharing::Time;

constexpr std::uint32_t waves_between_looks = 16;  // at the clock, while resting
constexpr Time rest_after_gain = 8ms;              // of sharing that had won time altogether
constexpr Time listens_after = 64ms;               // of waves that were shared out, and so many of these:
constexpr std::uint32_t listens_after_waves = 128;
constexpr Time most_credit = 4ms;  // as long as a thread may have to wait for its core: once is no reason
constexpr Time tolerance = 300us;  // more than a single wave loses by other causes

/// Whether enough waves have been measured to contain those of a whole tick, most likely several times.
bool heard_enough(std::uint32_t waves, Time in_waves) {
  return (waves >= 64 && in_waves >= 1ms) || (waves >= 8 && in_waves >= 8ms);
}

}  // namespace

Time WorthSharing::steady_now() { return std::chrono::steady_clock::now().time_since_epoch(); }

/// Kinds are addresses, or small numbers: hashed, so that any two of a simulation most likely have places of their own.
WorthSharing::Usual& WorthSharing::usual(std::uint64_t kind) {
  constexpr std::uint64_t factor = 0x9e3779b97f4a7c15;  // 2^64 by the golden ratio
  return usual_[(kind * factor >> 32) % usual_.size()];
}

bool WorthSharing::begin_wave() {
  if (phase_ == Phase::resting) {
    if (waves_++ % waves_between_looks != 0) return false;
    const Time now = now_();
    if (waves_ == 1) began_ = now;
    if (now - began_ < rest_) return false;
    credit_ = won_ = Time{};
    begin(Phase::listening, now);
  }
  wave_began_ = now_();
  return phase_ == Phase::sharing;
}

void WorthSharing::end_wave(std::uint64_t kind) {
  if (phase_ == Phase::resting) return;
  const Time now = now_(), time = now - wave_began_;
  ++waves_;
  in_waves_ += time;
  if (phase_ == Phase::listening) {
    listen(kind, time, now);
  } else {
    share(kind, time, now);
  }
}

void WorthSharing::begin(Phase phase, Time now) {
  phase_ = phase;
  began_ = now;
  waves_ = 0;
  in_waves_ = Time{};
}

void WorthSharing::listen(std::uint64_t kind, Time time, Time now) {
  Usual& of_kind = usual(kind);
  if (of_kind.kind != kind || of_kind.alone == Time{}) {
    of_kind = {kind, time};
  } else {
    // a moving average; outliers count as twice the average at most
    of_kind.alone += (std::min(time, 2 * of_kind.alone) - of_kind.alone) / 4;
  }
  if (heard_enough(waves_, in_waves_)) begin(Phase::sharing, now);
}

void WorthSharing::share(std::uint64_t kind, Time time, Time now) {
  const Usual& of_kind = usual(kind);
  if (of_kind.kind == kind && of_kind.alone > Time{}) {
    won_ += of_kind.alone - time;
    credit_ = std::min(credit_ + of_kind.alone - time, std::max(most_credit, of_kind.alone));
    if (credit_ < -std::max(tolerance, of_kind.alone / 4)) return rest(now);
  }
  if (in_waves_ >= listens_after && waves_ >= listens_after_waves) begin(Phase::listening, now);
}

void WorthSharing::rest(Time now) {
  rest_ = won_ > Time{} ? rest_after_gain : std::clamp(2 * rest_, shortest_rest, longest_rest);
  begin(Phase::resting, now);
}

}  // namespace murosimf
