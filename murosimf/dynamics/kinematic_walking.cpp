#include "murosimf/dynamics/kinematic_walking.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/collision/contact_properties.h"
#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/dynamics/sanity.h"
#include "murosimf/dynamics/walking_lanes.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/fixed_base.h"
#include "murosimf/multibody/kinematics.h"

namespace murosimf::dynamics {
namespace {

constexpr double penetration = -1e-6;       // [m] clearance below which a foot has landed: rounding is no landing
constexpr double fading_time = 0.1;         // [s] time constant of the difference from the pinned pose after a takeover
constexpr double stopping_time = 0.02;      // [s] time constant of the standing sole's velocity then
constexpr double steepest = 30 * pi / 180;  // [rad] lean of a robot that can be taken over
constexpr double highest_sole = 0.02;       // [m] distance of the lower sole from the ground at a takeover
constexpr double largest_margin = 1e-3;  // [m] by which the other foot must be lower while the standing one still turns

JointReferenceOptions without_load(JointReferenceOptions options) {
  options.carries = false;
  return options;
}

std::vector<Foot> two_feet(const Model& model) {
  auto feet = feet_of(model);
  if (feet.size() != 2) {
    throw SetupError(
        fmt::format("model '{}' cannot walk kinematically: it has {} sole{}, not 2 (name them in its "
                    "TOML file)",
                    model.name(), feet.size(), feet.size() == 1 ? "" : "s"));
  }
  return feet;
}

/// The shortest turn from the vertical to the normal of a plane with the slopes dz/dx and dz/dy.
Mat3d tilt_of(double slope_x, double slope_y) {
  if (slope_x == 0 && slope_y == 0) return rotation_z(0.0);  // exactly none: on flat ground no rounding enters the pose
  const double steepness = std::hypot(slope_x, slope_y);
  return to_matrix(exponential((std::atan(steepness) / steepness) * Vec3d{slope_y, -slope_x, 0}));
}

}  // namespace

KinematicWalking::KinematicWalking(Setup& setup, const JointReferenceOptions& reference, const Entity* environment)
    : entity_(setup.entity()),
      columns_(setup),
      reference_(setup, without_load(reference)),
      fixed_(has_fixed_base(setup.model())),
      environment_(environment),
      ground_(environment),
      stance_pose_(setup.write(properties::stance_pose)[0]),
      stance_ground_(setup.write(properties::stance_ground)[0]),
      stance_foot_(setup.write(properties::stance_foot)[0]),
      remaining_shift_(setup.write(properties::remaining_shift)[0]),
      remaining_turn_(setup.write(properties::remaining_turn)[0]),
      remaining_twist_(setup.write(properties::remaining_twist)[0]),
      separation_(setup.input(properties::separation, {})[0]),
      dynamic_(setup.write(properties::dynamic)[0]) {
  if (fixed_) return;
  const auto feet = two_feet(setup.model());
  feet_ = {with_path(feet[0]), with_path(feet[1])};
  up_ = upright_axis();
}

KinematicWalking::Foot KinematicWalking::with_path(const murosimf::Foot& foot) const {
  Foot result{foot, {}};
  for (int link = foot.place.link; link > 0; link = columns_.model.tree().links[link].parent) {
    result.path.insert(result.path.begin(), link);
  }
  return result;
}

void KinematicWalking::initialize() {
  reference_.initialize(columns_);
  place_at_start(columns_, entity_);
  dynamic_ = 0;
  if (!fixed_) {
    stand_on(lower_foot());
    remaining_shift_ = remaining_turn_ = {};
    pin();
  }
  columns_.update_poses();
  columns_.remember_base();
}

Vec3d KinematicWalking::upright_axis() const {
  const std::vector<double> zero(static_cast<std::size_t>(columns_.model.size()));
  return multibody::pose_in_base<double>(columns_.model.tree(), feet_[0].path, feet_[0].place, zero).orientation *
         Vec3d{0, 0, 1};
}

int KinematicWalking::lower_foot() const noexcept {
  // beyond rounding only: otherwise the first foot stands
  return clearance(feet_[1], ground_below(1)) < clearance(feet_[0], ground_below(0)) + penetration ? 1 : 0;
}

collision::GroundBelow KinematicWalking::ground_below(int foot) const noexcept {
  MUROSIMF_ASSERT(foot == 0 || foot == 1);
  return ground_.below(columns_.r[feet_[static_cast<std::size_t>(foot)].object]);
}

collision::GroundBelow KinematicWalking::stance_ground() const noexcept {
  return {stance_ground_.x, stance_ground_.y, stance_ground_.z};
}

void KinematicWalking::model_exchanged(const Entity& entity) {
  if (&entity == environment_) ground_ = collision::GroundSurface(environment_);
}

std::string KinematicWalking::refusal() const {
  if (fixed_) return {};
  // negated comparisons: NaN is refused as well
  const double lean = std::acos(std::clamp((columns_.R[0] * up_).z, -1.0, 1.0));
  if (!(lean <= steepest)) {
    return fmt::format("it leans {:.0f} degrees, more than {:.0f}; only a jump could make it stand on a foot",
                       lean * 180 / pi, steepest * 180 / pi);
  }
  const int lower = lower_foot();
  const double height = clearance(feet_[lower], ground_below(lower));
  if (!(std::abs(height) <= highest_sole)) {
    return fmt::format("its lower sole is {:.0f} mm away from the ground, more than {:.0f}", 1e3 * height,
                       1e3 * highest_sole);
  }
  return {};
}

void KinematicWalking::take_over(const Momentum&) {
  reference_.take_over(columns_);
  dynamic_ = 0;
  if (fixed_) columns_.v[0] = columns_.w[0] = {};
  columns_.update_poses();
  columns_.update_velocities();
  if (!fixed_) {
    stand_on(lower_foot());
    keep_moving();
  }
  columns_.remember_base();
}

void KinematicWalking::step(const Instant& instant) noexcept {
  if (fixed_) return step_fixed(seconds(instant.period));
  if (!begin_step(seconds(instant.period))) return;
  pin();
  columns_.update_poses();
  set_base_twist();
  columns_.update_velocities();
  end_step();
}

void KinematicWalking::step_fixed(double dt) noexcept {
  if (!reference_.advance(columns_, dt)) {
    MUROSIMF_ASSERT(dt > 0);
    columns_.stop();
    return entity_.freeze(joints_insane);
  }
  columns_.v[0] = columns_.w[0] = {};
  columns_.update_poses();
  columns_.update_velocities();
  columns_.remember_base();
}

/// Advances the joints, and the place of the standing sole. Returns false if the entity was frozen.
bool KinematicWalking::begin_step(double dt) noexcept {
  if (!reference_.advance(columns_, dt)) {
    MUROSIMF_ASSERT(dt > 0);
    columns_.stop();
    entity_.freeze(joints_insane);
    return false;
  }
  const Vec3d moved = columns_.take_displacement() + separation_;  // the standing foot moves with the base
  stance_pose_ += Vec3d{moved.x, moved.y, 0};
  // along the plane of the ground, not horizontally: the sole stays on a slope
  stance_ground_.x += stance_ground_.y * moved.x + stance_ground_.z * moved.y;
  fade_remainder(dt);
  return true;
}

void KinematicWalking::end_step() noexcept {
  columns_.remember_base();
  swap_if_other_foot_lands();
  const Vec3d& r = columns_.r[0];
  if (!(dot(r, r) < farthest * farthest)) {
    columns_.stop();
    entity_.freeze(too_fast);
  }
}

bool KinematicWalking::goes_with(const Algorithm& other) const {
  const auto* same = dynamic_cast<const KinematicWalking*>(&other);
  return same && !fixed_ && &columns_.model == &same->columns_.model;
}

std::unique_ptr<LaneGroup> KinematicWalking::join(std::span<Algorithm* const> members) const {
  return std::make_unique<WalkingLanes>(members_of<KinematicWalking>(members));
}

void KinematicWalking::pin() noexcept {
  const Foot& foot = standing_foot();
  pin(multibody::pose_in_base<double>(columns_.model.tree(), foot.path, foot.place, columns_.q));
}

/// Places the base so that the standing sole is at its prescribed pose; `sole`: its pose in the base.
void KinematicWalking::pin(const Transformd& sole) noexcept {
  const bool slopes = stance_ground_.y != 0 || stance_ground_.z != 0;
  const Mat3d level = rotation_z(stance_pose_.z);
  const Mat3d flat = slopes ? tilt_of(stance_ground_.y, stance_ground_.z) * level : level;
  const Mat3d R = to_matrix(exponential(remaining_turn_)) * flat * transpose(sole.orientation);
  columns_.Q[0] = from_matrix(R);
  columns_.R[0] = R;
  columns_.r[0] = Vec3d{stance_pose_.x, stance_pose_.y, stance_ground_.x} + remaining_shift_ - R * sole.position;
}

void KinematicWalking::stand_on(int foot) noexcept {
  MUROSIMF_ASSERT(foot == 0 || foot == 1);
  const Vec3d& r = columns_.r[feet_[foot].object];
  const Mat3d& R = columns_.R[feet_[foot].object];
  const collision::GroundBelow ground = ground_below(foot);
  // the difference between the actual and the prescribed pose remains as an offset that decays: nothing jumps
  const Mat3d level = transpose(tilt_of(ground.slope_x, ground.slope_y));
  stance_foot_ = foot;
  stance_ground_ = {ground.height, ground.slope_x, ground.slope_y};
  stance_pose_ = {r.x, r.y, heading(level * R)};
  remaining_shift_ = {0, 0, r.z - ground.height};
  remaining_turn_ = rotation_vector(from_matrix(R * rotation_z(-stance_pose_.z) * level));
  remaining_twist_ = {};
}

/// The standing sole keeps its present motion, which decays.
void KinematicWalking::keep_moving() noexcept {
  const Foot& foot = standing_foot();
  remaining_twist_ = {columns_.w[foot.object] + (1 / fading_time) * remaining_turn_,
                      columns_.v[foot.object] + (1 / fading_time) * remaining_shift_};
}

/// Pose and velocity of this step are not changed: the next step starts with them.
void KinematicWalking::swap_if_other_foot_lands() noexcept {
  const int other = stance_foot_ != 0 ? 0 : 1;
  MUROSIMF_ASSERT(feet_[0].object != feet_[1].object);
  // a sole that still turns moves its ends: less than that is no landing of the other foot
  const double still_to_turn = norm(remaining_turn_) * standing_foot().sole.half_length;
  const double lower = penetration - std::min(largest_margin, still_to_turn);
  if (clearance(feet_[other], ground_below(other)) >= clearance(standing_foot(), stance_ground()) + lower) return;
  stand_on(other);
  keep_moving();
}

/// [m] Height of the lowest corner of a foot's sole above a plane.
double KinematicWalking::clearance(const Foot& foot, const collision::GroundBelow& ground) const noexcept {
  const Mat3d& R = columns_.R[foot.object];
  const auto rise = [&](const Vec3d& axis) { return axis.z - ground.slope_x * axis.x - ground.slope_y * axis.y; };
  return columns_.r[foot.object].z - ground.height - foot.sole.half_length * std::abs(rise(R.x)) -
         foot.sole.half_width * std::abs(rise(R.y));
}

void KinematicWalking::set_base_twist() noexcept {
  const Foot& foot = standing_foot();
  set_base_twist(multibody::twist_against_base<double>(columns_.model.tree(), foot.path, columns_.r[foot.object],
                                                       columns_.qd, columns_.r, columns_.R));
}

/// Sets the velocity with which the standing sole comes to rest flat on the plane; `sole`: its motion relative to the base.
void KinematicWalking::set_base_twist(const Twistd& sole) noexcept {
  const Foot& foot = standing_foot();
  columns_.w[0] = remaining_twist_.w - (1 / fading_time) * remaining_turn_ - sole.w;
  columns_.v[0] = remaining_twist_.v - (1 / fading_time) * remaining_shift_ - sole.v -
                  cross(columns_.w[0], columns_.r[foot.object] - columns_.r[0]);
}

void KinematicWalking::fade_remainder(double dt) noexcept {
  MUROSIMF_ASSERT(dt > 0);
  constexpr double nothing = 1e-9;  // [m | rad], also in a second; below it exactly 0, so that it leaves the state hash
  if (const double rate = dot(remaining_twist_.w, remaining_twist_.w) + dot(remaining_twist_.v, remaining_twist_.v);
      rate != 0) {
    // implicit Euler: decays for any step
    remaining_twist_ = (rate > nothing * nothing ? 1 / (1 + dt / stopping_time) : 0) * remaining_twist_;
    remaining_turn_ += dt * remaining_twist_.w;
    remaining_shift_ += dt * remaining_twist_.v;
  }
  const double size = dot(remaining_shift_, remaining_shift_) + dot(remaining_turn_, remaining_turn_);
  if (size == 0) return;
  const double rest = size > nothing * nothing ? 1 / (1 + dt / fading_time) : 0;
  remaining_shift_ = rest * remaining_shift_;
  remaining_turn_ = rest * remaining_turn_;
}

}  // namespace murosimf::dynamics
