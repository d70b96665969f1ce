/// kinematic_walking.h - level `kinematic_walking`: the standing foot stays fixed on the ground.
///
/// Each step: joints follow their targets; the base is placed so that the standing sole is at its fixed place (x, y,
/// heading), where it turns flat; if then the other foot is lower, the feet swap roles and the new one is fixed where it
/// is. External forces are ignored; the robot cannot fall.
///
///     R_0 = exp(t) R_n Rz(psi) R_S^T    r_0 = x_S + s - R_0 r_S           S: sole in base axes
///     w_0 = t' - w_S                v_0 = s' - v_S - w_0 x (r_S - r_0)
///     t' = u_t - t / 0.1 s          s' = u_s - s / 0.1 s          u' = -u / 0.02 s
///
/// x_S and R_n are those of the plane that touches the ground right below the sole's middle when it lands (collision/ground_finder.h): the
/// field, a plate, a ramp. R_n turns the vertical into its normal on the shortest way. Surfaces higher by more than 60 mm are not ground.
/// A foot is hardly ever exactly flat and at height 0 when it lands, or when this level takes over a moving robot
/// (world/motion_level.h; the lower foot stands then), nor at rest. Its tilt t and height s remain as offsets; they decay, x and y are
/// constant, and the pose does not jump: the velocity matches the motion of the base. A sole that moves when it lands or when the robot is
/// taken over stops within 0.02 s: u is the excess of its velocity over that decay, so base and limbs continue their motion: a level that
/// takes over a few steps later finds the momentum unchanged, and an accelerometer shows no step of the velocity. A sole that lands
/// in a walk of kid21 slides by 2 mm meanwhile, and back. The velocity is analytic, and in the step in which the feet swap
/// that of the preceding stance, which has led there. The other foot is lower when its lowest corner is 1 um below that of the
/// standing one, and while the standing one still turns also below its ends' motion due to the turn, |t| half_length, at
/// most 1 mm: otherwise two feet that cannot both be flat would swap roles in every step.
/// A robot whose base is bolted to the world (model/fixed_base.h) stands on no foot: its base keeps its place and its joints move.
/// A robot that leans more than 30 degrees, or whose soles are both more than 20 mm away from the ground, is not taken over:
/// it could stand only after a jump of its pose.
/// Source:  paper 4.1.
/// Differs: the paper leaves open the heading (here: that of the foot when it lands), the tested point (lowest corner
///          of the other sole), and the first stance (the lower foot); it keeps the pose of a foot that lands, here its
///          tilt decays, so that tilts do not add up.
/// Limits:  both feet in the air cannot occur; a jump looks like standing. A foot that lands half on a plate has the height of its middle;
///          a robot that steps off something comes down within 0.1 s, as a foot that lands above the ground does.
#pragma once

#include <array>

#include "murosimf/collision/ground_finder.h"
#include "murosimf/dynamics/joint_reference.h"
#include "murosimf/dynamics/pose_columns.h"
#include "murosimf/model/feet.h"
#include "murosimf/world/motion_level.h"

namespace murosimf::dynamics {

class KinematicWalking final : public MotionLevel {
 public:
  static constexpr LevelTraits has{};

  /// Throws SetupError if the model has neither exactly two soles nor a fixed base.
  /// `environment`: what it walks on; null for the plane z = 0.
  explicit KinematicWalking(Setup& setup, const JointReferenceOptions& reference = {},
                            const Entity* environment = nullptr);

  [[nodiscard]] LevelTraits traits() const override { return has; }
  void initialize() override;
  void step(const Instant& instant) noexcept override;
  [[nodiscard]] std::string refusal() const override;
  void model_exchanged(const Entity& entity) override;
  [[nodiscard]] Momentum hand_over() noexcept override { return columns_.momentum(); }
  void take_over(const Momentum& momentum) override;
  [[nodiscard]] bool goes_with(const Algorithm& other) const override;
  [[nodiscard]] std::unique_ptr<LaneGroup> join(std::span<Algorithm* const> members) const override;

 private:
  friend class WalkingLanes;

  struct Foot : murosimf::Foot {
    std::vector<int> path;  // links from the base outwards, base excluded
  };

  void step_fixed(double dt) noexcept;
  [[nodiscard]] Foot with_path(const murosimf::Foot& foot) const;
  [[nodiscard]] std::size_t standing() const noexcept { return stance_foot_ != 0 ? 1 : 0; }  // number of that foot
  [[nodiscard]] const Foot& standing_foot() const noexcept { return feet_[standing()]; }
  [[nodiscard]] Vec3d upright_axis() const;
  [[nodiscard]] int lower_foot() const noexcept;
  [[nodiscard]] collision::GroundBelow ground_below(int foot) const noexcept;
  [[nodiscard]] collision::GroundBelow stance_ground() const noexcept;
  [[nodiscard]] bool begin_step(double dt) noexcept;
  void end_step() noexcept;
  void pin() noexcept;
  void pin(const Transformd& sole) noexcept;
  void stand_on(int foot) noexcept;
  void keep_moving() noexcept;
  void swap_if_other_foot_lands() noexcept;
  [[nodiscard]] double clearance(const Foot& foot, const collision::GroundBelow& ground) const noexcept;
  void set_base_twist() noexcept;
  void set_base_twist(const Twistd& sole) noexcept;
  void fade_remainder(double dt) noexcept;

  Entity& entity_;
  PoseColumns columns_;
  JointReference reference_;
  std::array<Foot, 2> feet_;
  bool fixed_;  // the base is bolted to the world; there are no feet then
  Vec3d up_;    // [1] axis of the base that is vertical when the robot stands with all joints at 0
  const Entity* environment_;
  mutable collision::GroundSurface ground_;
  Vec3d& stance_pose_;       // [m, m, rad] x, y, heading of the standing sole
  Vec3d& stance_ground_;     // [m, 1, 1] height and slopes of the ground below its middle
  double& stance_foot_;      // 0 or 1
  Vec3d& remaining_shift_;   // [m] s, of the standing sole
  Vec3d& remaining_turn_;    // [rad] t, of the standing sole
  Twistd& remaining_twist_;  // [rad/s; m/s] u, of the standing sole
  const Vec3d& separation_;
  double& dynamic_;
};

}  // namespace murosimf::dynamics
