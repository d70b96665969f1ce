/// session_slot.h - the session that supervisors control at present: runs come and go, supervisors stay connected.
#pragma once

#include <condition_variable>
#include <mutex>

#include "murosimf/session/session.h"

namespace murosimf::supervise {

class SessionSlot {
 public:
  /// Marks the session as used during its lifetime.
  class Lease {
   public:
    /// Of the session number `from`, or a later one: waits for it. Throws SetupError if none will follow.
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
  /// Number of the present session, or the last one; from 1 on.
  [[nodiscard]] int number() const;
  /// Later requests wait for the next session; returns when the present one is no longer used.
  void remove();
  /// There will be no further session: waiting and later requests get a SetupError.
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
