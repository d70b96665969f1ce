/// accelerations.h - algorithm: how fast the velocities of an entity's objects and joints change, at any level of detail.
///
///     a_i = (v_i(t) - v_i(t - h)) / h     alpha_i = (w_i(t) - w_i(t - h)) / h     qdd_i = (qd_i(t) - qd_i(t - h)) / h
///
/// with h the time between two calls, the longest step of the entity: the mean over the step that has just ended, of every object's origin in world axes. Under
/// semi-implicit Euler that is, for the base and the joints, the acceleration that the level has solved for; it is the one of
/// which accelerometers show the specific force (sensors/inertial.h). Each level's velocities define it, so it is there at
/// kinematic_walking as well, where nobody solves for one.
///
/// Impulses are accelerations of one step: a landing foot of kinematic_walking (the base's velocity becomes that of the new
/// stance), an impact, an exchange of levels that changes velocities, and what users write into velocities. Divided by h = 1 ms,
/// 0.1 m/s is 100 m/s^2. Means over longer times keep their meaning.
///
/// Nobody pays for it who does not attach it; it changes nothing (Scope::shown). All is 0 until the first step has ended.
/// Source: paper, table 3 (properties linear and angular acceleration); definition of a mean acceleration.
#pragma once

#include <vector>

#include "murosimf/model/algorithm.h"
#include "murosimf/model/properties.h"
#include "murosimf/model/setup.h"

namespace murosimf::motion {

class Accelerations final : public Algorithm {
 public:
  /// To be attached with the rate of the longest steps of the entity.
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
  std::vector<Vec3d> last_v_, last_w_;  // those of the step before
  std::vector<double> last_qd_;
};

}  // namespace murosimf::motion
