#include "murosimf/runtime/command_queue.h"

#include <exception>
#include <utility>

#include "murosimf/math/assert.h"

namespace murosimf {

std::future<void> CommandQueue::post(std::string text, std::function<void()> call, std::function<void()> check) {
  MUROSIMF_ASSERT(call);
  Posted posted{std::move(text), std::move(call), std::move(check), {}};
  std::future<void> done = posted.done.get_future();
  const std::lock_guard lock(mutex_);
  posted_.push_back(std::move(posted));
  waiting_.store(true, std::memory_order_release);
  return done;
}

void CommandQueue::carry_out_all(Duration now) {
  std::vector<Posted> all;
  {
    const std::lock_guard lock(mutex_);
    all.swap(posted_);
    waiting_.store(false, std::memory_order_release);
  }
  // without the lock: a command may post others
  for (Posted& posted : all) {
    try {
      if (posted.check) posted.check();
      history_.push_back({now, std::move(posted.text)});
      posted.call();
      posted.done.set_value();
    } catch (...) {
      posted.done.set_exception(std::current_exception());
    }
  }
}

}  // namespace murosimf
