/// accelerations.h - algorithm: mean accelerations of an entity's objects and joints, at any level of detail.
///
///     a_i = (v_i(t) - v_i(t - h)) / h     alpha_i = (w_i(t) - w_i(t - h)) / h     qdd_i = (qd_i(t) - qd_i(t - h)) / h
///
/// with h the time between two calls, the longest step of the entity: the mean over the step that has just ended, of every object's
/// origin in world axes. Under semi-implicit Euler these are, for the base and the joints, the accelerations that the level has solved
/// for, and those whose specific force accelerometers report (sensors/inertial.h). They follow from each level's velocities, so they
/// exist at kinematic_walking as well, which solves for none.
///
/// Impulses are accelerations of one step: a landing foot of kinematic_walking (the base's velocity becomes that of the new
/// stance), an impact, an exchange of levels that changes velocities, and what users write into velocities. Divided by h = 1 ms,
/// 0.1 m/s is 100 m/s^2. Means over longer times keep their meaning.
///
/// It costs nothing unless it is attached, and it changes no state (Scope::shown). All is 0 until the first step has ended.
/// Source: paper, table 3 (properties linear and angular acceleration); definition of a mean acceleration.
#pragma once

#include <vector>

#include "murosimf/model/properties.h"
#include "murosimf/world/algorithm.h"
#include "murosimf/world/setup.h"

namespace murosimf::dynamics {

class Accelerations final : public Algorithm {
 public:
  /// Attach it with the rate of the longest steps of the entity.
  explicit Accelerations(Setup& setup);

  [[nodiscard]] Phase phase() const noexcept override { return Phase::observe; }
  void initialize() override;
  void state(StateArchive& archive) override;
  void step(const Instant& instant) noexcept override;

 private:
  std::span<const Vec3d> v_, w_;        // [m/s], [rad/s] by object, world
  std::span<const double> qd_;          // [rad/s | m/s] by object
  std::span<Vec3d> a_, alpha_;          // [m/s^2], [rad/s^2] by object, world
  std::span<double> qdd_;               // [rad/s^2 | m/s^2] by object
  std::vector<Vec3d> last_v_, last_w_;  // of the preceding step
  std::vector<double> last_qd_;
};

}  // namespace murosimf::dynamics
