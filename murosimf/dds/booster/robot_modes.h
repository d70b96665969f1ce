/// robot_modes.h - modes of a Booster robot: what each request does in each of them, and what moves the joints.
///
///     damping    0  joints are limp but for their dampers: the robot falls
///     prepare    1  stands
///     walking    2  walks as Move says
///     custom     3  joints follow low-level commands
///     soccer     4  as walking
///
/// Any of them may follow any other. A robot that has fallen goes to damping, as the real one protects itself, and stays there until it is asked to
/// get up. Which changes the real firmware refuses is not published: these rules are our own.
#pragma once

#include <cstdint>

#include "murosimf/dds/booster/messages.h"
#include "murosimf/math/vec3.h"

namespace murosimf::dds::booster {

enum class Mode : std::int32_t { damping = 0, prepare = 1, walking = 2, custom = 3, soccer = 4 };

/// Status of an answer. Source: status codes of the vendor's SDK 1.6.3 (kRpcStatusCode...).
enum class Status : std::int32_t { success = 0, bad_request = 400, conflict = 409, refused = 501 };

/// How the robot lies or stands, from its own sensors.
struct Posture {
  bool fallen = false, falling = false;
  bool gets_up = false;  ///< the motion engine has it get up
};

class RobotModes {
 public:
  RobotModes() = default;
  explicit RobotModes(Mode first) : mode_(first) {}

  /// Damping ends whatever the robot does. Bad request: there is no such mode.
  Status change(std::int64_t mode);
  /// [m/s, m/s, rad/s] until the next one. Conflict: not in walking or soccer.
  Status move(const Vec3d& velocity);
  /// Then it is in `mode`: walking or soccer. Conflict: it has not fallen.
  Status get_up(std::int64_t mode, const Posture& posture);
  /// Conflict: not in prepare, walking or soccer.
  Status lie_down();
  /// To be called in each cycle, before requests.
  void follow(const Posture& posture);

  [[nodiscard]] Mode mode() const { return mode_; }
  [[nodiscard]] bool walks() const { return (mode_ == Mode::walking || mode_ == Mode::soccer) && !rising_ && !lies_; }
  /// The motion engine moves the joints.
  [[nodiscard]] bool uses_motions() const { return mode_ != Mode::damping && mode_ != Mode::custom; }
  [[nodiscard]] bool rises() const { return rising_; }
  /// Lies because it was asked to.
  [[nodiscard]] bool lies() const { return lies_; }
  /// [m/s, m/s, rad/s]
  [[nodiscard]] Vec3d velocity() const { return walks() ? velocity_ : Vec3d{}; }
  /// As in the vendor's enum BodyControl.
  [[nodiscard]] std::int32_t body_control() const;
  [[nodiscard]] FallDown fall_down(const Posture& posture) const;

  template <class Archive>
  void state(Archive& archive) {
    archive(mode_, rising_, lies_, velocity_.x, velocity_.y, velocity_.z);
  }

 private:
  Mode mode_ = Mode::prepare;
  bool rising_ = false;  // asked to get up, and does not stand yet
  bool lies_ = false;
  Vec3d velocity_;
};

}  // namespace murosimf::dds::booster
