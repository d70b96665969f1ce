/// ball_chaser.h - algorithm: a small soccer player. Turns to the ball, walks behind it and pushes it to the goal.
///
/// Uses the sensor `ground_truth` (sensors/ground_truth.h) and writes `walk_command`. The robot of a team that is nearest to
/// the ball attacks it; the others follow it at a distance. Robots steer around each other, and push
/// each other only where they attack the ball. With a motion engine (`kicks`) it requests kicks to the goal near the ball: the engine
/// chooses one of the robot's motions, walks to where it sends the ball there (locomotion/kick_plan.h), and gets up after a fall.
#pragma once

#include "murosimf/locomotion/motion_state.h"
#include "murosimf/model/properties.h"
#include "murosimf/sensors/ground_truth.h"
#include "murosimf/world/algorithm.h"
#include "murosimf/world/setup.h"

namespace murosimf::soccer {

struct Situation;  // ball_chaser.cpp

struct BallChaserOptions {
  std::string ball = "ball";  ///< name of the entity to chase
  Vec3d goal{3, 0, 0};        ///< [m] where to push it, world frame
  Vec3d half_field{3, 2, 0};  ///< [m] bounds of the places of supporters
  double speed = 0.2;         ///< [m/s] forward
  // [m] on the ground
  double behind_ball = 0.22;    ///< where a push begins
  double detour = 0.40;         ///< sideways, to get around the ball
  double support_behind = 0.8;  ///< distance of supporters behind the ball
  double support_aside = 0.7;   ///< the same sideways
  double keep_clear = 0.55;     ///< of other robots
  bool kicks =
      false;  ///< a motion engine moves it: it kicks with motions of the robot's file that give the place of the ball
};

class BallChaser final : public Algorithm {
 public:
  explicit BallChaser(Setup& setup, const BallChaserOptions& options);

  [[nodiscard]] Phase phase() const noexcept override { return Phase::control; }
  void initialize() override;
  void step(const Instant& instant) noexcept override;

  static constexpr double rate_hz = 20;

 private:
  [[nodiscard]] Vec3d attack_with_kicks(const Situation& situation, const Instant& instant) noexcept;

  BallChaserOptions options_;
  sensors::Sightings seen_;
  Vec3d& command_;                           // [m/s, m/s, rad/s]
  locomotion::KickRequest* kick_ = nullptr;  // null: without kicks
};

}  // namespace murosimf::soccer
