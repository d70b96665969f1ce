/// scene_steering.h - what people ask of the scene that is shown, while it runs: changes of properties, levels and places, pushes, jumps.
///
/// Everything is asked of the session, which does it between two steps; what refuses becomes a message.
#pragma once

#include <optional>
#include <string>

#include "murosimf/viewer/scene_outline.h"
#include "murosimf/viewer/session_requests.h"

namespace murosimf::viewer {

class SceneSteering {
 public:
  /// All outlive it: where messages go, and what is known of the scene.
  SceneSteering(MessageLog& messages, const session::SessionStatus& status, const SceneOutline& outline)
      : messages_(messages), status_(status), outline_(outline), requests_(messages) {}

  /// From now on of this session; what was asked of another one is forgotten.
  void begin(session::Session& session);

  double push_seconds = 0.1;  ///< how long a push lasts

  /// PATH = VALUE, as for Session::change.
  void change(const std::string& text, bool silent = false) { ask(text, session_->change(text), silent); }
  void set_property(const ObjectPath& path, const PropertyValue& property);
  void switch_level(int entity, const std::string& level) { change(outline_.of(entity).name + ".level = " + level); }
  void switch_contact(int entity, const std::string& law) { change(outline_.of(entity).name + ".contact = " + law); }
  /// [m] world: of its base. Only one move is on its way at a time; the last one wins.
  void move(int entity, const Vec3d& place);
  /// [rad | m] While it is paused; as move().
  void move_joint(const ObjectPath& path, double position);
  /// [N] world, for push_seconds.
  void push(const ObjectPath& path, const Vec3d& force);
  /// [N m] likewise.
  void twist(const ObjectPath& path, const Vec3d& moment);
  void seek(double time, std::optional<int> branch = {});
  void reset() { ask("reset", session_->reset()); }
  void record();  ///< from now on, or no longer

  /// Has poses published, although no step was made.
  void publish_poses();
  /// Takes the answers that have come.
  void collect() { requests_.collect(*session_); }
  [[nodiscard]] const SessionRequests& requests() const noexcept { return requests_; }

 private:
  void ask(std::string what, std::future<void> done, bool silent = false);

  MessageLog& messages_;
  const session::SessionStatus& status_;
  const SceneOutline& outline_;
  session::Session* session_ = nullptr;
  SessionRequests requests_;
};

}  // namespace murosimf::viewer
