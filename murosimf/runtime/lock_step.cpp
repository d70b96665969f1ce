#include "murosimf/runtime/lock_step.h"

#include "murosimf/math/assert.h"

namespace murosimf {
namespace {

constexpr auto stop_period = std::chrono::milliseconds(20);  // until the request to stop is tested again

}  // namespace

bool LockStep::advance(Duration by) {
  MUROSIMF_ASSERT(by >= Duration{});
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return started_ || finished_; });
  MUROSIMF_ASSERT(by >= Duration{} && "a simulation does not run backwards");
  const Duration goal = now_ + by;
  allowed_ = goal;
  changed_.notify_all();
  changed_.wait(lock, [&] { return now_ >= goal || finished_; });
  return now_ >= goal;
}

void LockStep::finish() {
  const std::lock_guard lock(mutex_);
  finished_ = true;
  changed_.notify_all();
}

void LockStep::start(Duration now) {
  const std::lock_guard lock(mutex_);
  now_ = allowed_ = now;
  started_ = true;
  changed_.notify_all();
}

void LockStep::before_step(Duration now, const StopRequest& stop) {
  std::unique_lock lock(mutex_);
  while (!(now < allowed_) && !finished_ && !(stop && stop())) changed_.wait_for(lock, stop_period);
}

void LockStep::after_step(Duration now, const StopRequest&) {
  const std::lock_guard lock(mutex_);
  now_ = now;
  if (now_ >= allowed_) changed_.notify_all();
}

}  // namespace murosimf
