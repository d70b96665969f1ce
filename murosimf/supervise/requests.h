/// requests.h - what a supervisor asks, done by a session and answered.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "murosimf/logging/log_paths.h"
#include "murosimf/session/session.h"
#include "murosimf/supervise/session_slot.h"
#include "murosimf/supervise/supervision.h"

namespace murosimf::wire {
class FromSupervisor;
class Status;
class ToSupervisor;
}  // namespace murosimf::wire

namespace murosimf::supervise {

class Requests {
 public:
  /// Both must outlive it. `given_up`: whether the answer is wanted no more.
  Requests(SessionSlot& slot, const SupervisionOptions& options, std::function<bool()> given_up)
      : slot_(&slot), options_(&options), given_up_(std::move(given_up)) {}

  /// Waits until it is done. Throws SetupError if it cannot be, WireError if it is no request.
  void answer(const wire::FromSupervisor& request, wire::ToSupervisor& answer);
  /// Scene, seed, step and status.
  void welcome(wire::ToSupervisor& answer) { welcome(answer, 0); }

 private:
  using Patterns = std::vector<std::string>;

  void answer_of_session(const wire::FromSupervisor& request, wire::ToSupervisor& answer);
  void welcome(wire::ToSupervisor& answer, int session);
  void publish_scene(wire::ToSupervisor& answer);
  void write_status(wire::Status& status) const;
  void exchange(const wire::FromSupervisor& request);
  void advance(Duration duration);
  void settle();
  void change(const wire::FromSupervisor& request);
  void seek(const wire::FromSupervisor& request);
  void read(const Patterns& patterns, wire::ToSupervisor& answer);
  void describe(wire::ToSupervisor& answer);
  void publish_events(std::uint64_t first, wire::ToSupervisor& answer);
  void publish_branches(wire::ToSupervisor& answer);
  void save(wire::ToSupervisor& answer);
  void load(const wire::FromSupervisor& request);
  void visit(const std::function<void(scene::Scene&)>& look);

  SessionSlot* slot_;
  const SupervisionOptions* options_;
  session::Session* session_ = nullptr;  // while something is answered
  std::string state_;                    // that comes in parts
  std::function<bool()> given_up_;
  std::map<Patterns, std::vector<logging::LoggedNumber>> found_;  // what patterns mean
  int found_in_ = 0;                                              // in the session of this number (SessionSlot)
};

}  // namespace murosimf::supervise
