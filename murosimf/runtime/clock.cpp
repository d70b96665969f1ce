#include "murosimf/runtime/clock.h"

#include <algorithm>
#include <cmath>
#include <thread>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf {
namespace {

constexpr Duration patience = std::chrono::milliseconds(100);   // a longer delay shifts the schedule
constexpr Duration longest_silence = std::chrono::seconds(64);  // between two reports of lateness
constexpr Duration nap = std::chrono::milliseconds(20);         // until the request to stop is tested again

class SteadyTime final : public WallTime {
 public:
  Duration now() override { return std::chrono::steady_clock::now().time_since_epoch(); }
  void sleep_until(Duration time) override {
    std::this_thread::sleep_until(std::chrono::steady_clock::time_point(time));
  }
};

}  // namespace

Clock::Clock(std::optional<double> speed, std::unique_ptr<WallTime> wall) : speed_(speed), wall_(std::move(wall)) {
  constexpr double slowest = 1e-6, fastest = 1e9;
  if (speed_ && !(*speed_ >= slowest && *speed_ <= fastest)) {
    throw SetupError(
        fmt::format("speed {} is not a number between {} and {} (1 is real time)", *speed_, slowest, fastest));
  }
  if (!wall_) wall_ = std::make_unique<SteadyTime>();
}

void Clock::start(Duration simulated) {
  simulated_start_ = simulated;
  wall_start_ = told_at_ = wall_->now();
}

void Clock::sleep_until(Duration due, const StopRequest& stop) {
  for (Duration now = wall_->now(); now < due && !(stop && stop()); now = wall_->now()) {
    wall_->sleep_until(std::min(due, now + nap));
  }
}

void Clock::count(Duration behind) {
  for (Lateness* lateness : {&lateness_, &untold_}) {
    ++lateness->steps;
    if (behind <= tolerance) continue;
    ++lateness->late_steps;
    lateness->worst = std::max(lateness->worst, behind);
  }
}

void Clock::tell_of(Duration simulated, Duration wall) {
  if (!publish_ || wall - told_at_ < silence_) return;
  if (untold_.late_steps > 0) {
    publish_({simulated, untold_});
    silence_ = std::min(2 * silence_, longest_silence);
  }
  told_at_ = wall;
  untold_ = {};
}

Duration Clock::due(Duration simulated) const {
  MUROSIMF_ASSERT(speed_ && *speed_ > 0);
  return wall_start_ + from_seconds(seconds(simulated - simulated_start_) / *speed_);
}

void Clock::wait_until(Duration simulated, const StopRequest& stop) {
  if (!speed_) return;
  const Duration now = wall_->now(), behind = now - due(simulated);
  count(behind);
  tell_of(simulated, now);
  if (behind <= Duration{}) return sleep_until(due(simulated), stop);
  // after a long pause the clock goes on from here: catching up would run too fast for seconds
  if (behind > patience) wall_start_ += behind;
}

}  // namespace murosimf
