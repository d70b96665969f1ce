/// session_slot.h - the session that supervisors steer now: runs come and go, supervisors stay.
#pragma once

#include <condition_variable>
#include <mutex>

#include "murosimf/session/session.h"

namespace murosimf::supervise {

class SessionSlot {
 public:
  /// Somebody uses the session as long as this lives.
  class Lease {
   public:
    /// Of the session number `from`, or a later one: waits for it. Throws SetupError if none will come.
    explicit Lease(SessionSlot& slot, int from = 0) : slot_(&slot), session_(slot.take(from)) {}
    ~Lease() { slot_->give_back(); }
    Lease(const Lease&) = delete;
    Lease& operator=(const Lease&) = delete;
    [[nodiscard]] session::Session& session() const { return *session_; }

   private:
    SessionSlot* slot_;
    session::Session* session_;
  };

  void put(session::Session& session);
  /// Of the present one, or the last one; from 1 on.
  [[nodiscard]] int number() const;
  /// Whoever asks from now on waits for the next one; comes back when nobody uses this one any more.
  void remove();
  /// There will be none any more: who waits, or asks, is told so by SetupError.
  void close();

 private:
  [[nodiscard]] session::Session* take(int from);
  void give_back();

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  session::Session* session_ = nullptr;
  int number_ = 0, users_ = 0;
  bool closed_ = false;
};

}  // namespace murosimf::supervise
