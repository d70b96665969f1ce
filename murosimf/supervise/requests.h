/// requests.h - requests of a supervisor, executed by a session and answered.
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
  /// Both must outlive it. `given_up`: whether the answer is no longer expected.
  Requests(SessionSlot& slot, const SupervisionOptions& options, std::function<bool()> given_up)
      : slot_(&slot), options_(&options), given_up_(std::move(given_up)) {}

  /// Waits for completion. Throws SetupError if the request fails, NetworkError if it is invalid.
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
  session::Session* session_ = nullptr;  // during a request
  std::string state_;                    // received in parts
  std::function<bool()> given_up_;
  std::map<Patterns, std::vector<logging::LoggedNumber>> found_;  // numbers of known patterns
  int found_in_ = 0;                                              // in the session of this number (SessionSlot)
};

}  // namespace murosimf::supervise
