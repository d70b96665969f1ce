#include "murosimf/supervise/session_slot.h"

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::supervise {

void SessionSlot::put(session::Session& session) {
  const std::lock_guard lock(mutex_);
  session_ = &session;
  ++number_;
  changed_.notify_all();
}

void SessionSlot::remove() {
  std::unique_lock lock(mutex_);
  session_ = nullptr;
  changed_.wait(lock, [this] { return users_ == 0; });
  MUROSIMF_ASSERT(users_ == 0);
}

void SessionSlot::close() {
  const std::lock_guard lock(mutex_);
  closed_ = true;
  changed_.notify_all();
}

int SessionSlot::number() const {
  const std::lock_guard lock(mutex_);
  return number_;
}

/// Waits for a session that is at least as new: between two runs there is none.
session::Session* SessionSlot::take(int from) {
  std::unique_lock lock(mutex_);
  const auto is_there = [&] { return session_ && number_ >= from; };
  changed_.wait(lock, [&] { return closed_ || is_there(); });
  if (!is_there()) throw SetupError("the run has ended");
  ++users_;
  MUROSIMF_ASSERT(session_ != nullptr && users_ > 0);
  return session_;
}

void SessionSlot::give_back() {
  const std::lock_guard lock(mutex_);
  MUROSIMF_ASSERT(users_ > 0);
  --users_;
  changed_.notify_all();
}

}  // namespace murosimf::supervise
