/// requests.h - what a supervisor asks, done by a session and answered.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "murosimf/logging/log_paths.h"
#include "murosimf/session/session.h"

namespace murosimf::wire {
class FromSupervisor;
class Status;
class ToSupervisor;
}  // namespace murosimf::wire

namespace murosimf::supervise {

class Requests {
 public:
  using Save = std::function<std::string(scene::Scene&)>;
  using Load = std::function<void(scene::Scene&, const std::string& bytes)>;

  /// `save` and `load` as in SupervisionOptions. `given_up`: whether the answer is wanted no more.
  Requests(session::Session& session, Save save, Load load, std::function<bool()> given_up)
      : session_(&session), save_(std::move(save)), load_(std::move(load)), given_up_(std::move(given_up)) {}

  /// Waits until it is done. Throws SetupError if it cannot be, WireError if it is no request.
  void answer(const wire::FromSupervisor& request, wire::ToSupervisor& answer);
  void write_status(wire::Status& status) const;
  /// Scene, seed, step and status.
  void welcome(wire::ToSupervisor& answer);

 private:
  using Patterns = std::vector<std::string>;

  void advance(Duration duration);
  void settle();
  void change(const wire::FromSupervisor& request);
  void seek(const wire::FromSupervisor& request);
  void read(const Patterns& patterns, wire::ToSupervisor& answer);
  void describe(wire::ToSupervisor& answer);
  void tell_events(std::uint64_t first, wire::ToSupervisor& answer);
  void tell_branches(wire::ToSupervisor& answer);
  void save(wire::ToSupervisor& answer);
  void load(const wire::FromSupervisor& request);
  void visit(const std::function<void(scene::Scene&)>& look);

  session::Session* session_;
  Save save_;
  Load load_;
  std::string state_;  // that comes in parts
  std::function<bool()> given_up_;
  std::map<Patterns, std::vector<logging::LoggedNumber>> found_;  // what patterns mean
};

}  // namespace murosimf::supervise
