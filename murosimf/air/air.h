/// air.h - algorithm: aerodynamic forces on a ball: drag, and lift due to its spin.
///
///     F = -1/2 rho C_d A |u| u + 1/2 rho C_l A |u|^2 (w x u) / |w x u|
///     A = pi r^2        u = v - wind        C_l = lift S / (S + 0.17)        S = r |w x u| / |u|^2
///
/// Source: drag, lift and S as in J. E. Goff and M. J. Carre, Trajectory analysis of a soccer ball, Am. J. Phys. 77 (2009). C_l(S):
/// R. Cross' fit for baseballs, 1 / (2.32 + 0.4 / S), as in A. Nathan's trajectory calculator; wind tunnels give about the same
/// for soccer balls, 0.1 to 0.15 at S = 0.1 and 0.25 to 0.3 at S = 0.3 (T. Asai et al., Fundamental aerodynamics of the soccer ball,
/// Sports Eng. 10 (2007)). All figures are from memory: no copy was at hand. Here S counts the spin across the way alone, so that a
/// ball that spins about its way, as a bullet does, has no lift and no jump there.
///
/// Not here: the drag crisis (C_d falls to 0.2 above a Reynolds number of 2 x 10^5: 21 m/s for a ball of 14 cm, 14 m/s for one of
/// 22 cm; give such a ball the smaller number), the side forces of a ball without spin, the moment that slows spin down within tens of
/// seconds, drag that grows with spin, and all bodies that are not round.
///
/// The step: drag is linearly implicit, lift turns u by a Cayley rotation about the axis across the way, so it never changes |u|; a
/// ball loses energy at any step length, its terminal velocity is exact, and so is its speed without other forces. With a = the
/// acceleration by all other forces,
///
///     u_k+1 = (C(turn) u_k + dt a) / (1 + dt k |u_k|)        k = rho C_d A / (2 m)
///
/// and the force of the step is the one with this result. In contact a is unknown here, and taken for zero: the drag of such
/// a step is off by k |u_k| a dt.
#pragma once

#include <span>

#include "murosimf/air/air_options.h"
#include "murosimf/collision/contact.h"
#include "murosimf/world/algorithm.h"
#include "murosimf/world/setup.h"

namespace murosimf::air {

/// [1] Spin parameter at which C_l is half of `lift`: 0.4 / 2.32.
inline constexpr double half_lift_spin = 0.172;

/// A round body.
struct RoundBody {
  double radius = 0;          ///< [m]
  double mass = 0;            ///< [kg]
  double drag = 0, lift = 0;  ///< [1] C_d, and what C_l comes to at high spin
};

/// [1/m] k: a body of the speed v loses k v^2 [m/s^2] to air of this density [kg/m^3].
[[nodiscard]] double drag_per_meter(double density, const RoundBody& body) noexcept;

/// [N] mean force on a body in a step of dt [s] that begins with the velocity u [m/s] against the air and the spin w [rad/s];
/// `acceleration` [m/s^2] of everything else. World frame. `density` [kg/m^3]. Zero at rest.
[[nodiscard]] Vec3d air_force(double density, const RoundBody& body, const Vec3d& u, const Vec3d& w,
                              const Vec3d& acceleration, double dt) noexcept;

/// Adds it to the external force of an entity whose base is one sphere with a drag_coefficient. Attach it after
/// GroundContact, at the same rate, for levels at which forces move the entity.
class Air final : public Algorithm {
 public:
  /// Throws SetupError if the base of the model is no sphere with these coefficients.
  Air(Setup& setup, const AirOptions& options);

  [[nodiscard]] Phase phase() const noexcept override { return Phase::contact; }
  void model_exchanged(const Entity& entity) override;
  void step(const Instant& instant) noexcept override;

 private:
  void take_model();

  const Entity& entity_;
  AirOptions options_;
  Vec3d gravity_;   // [m/s^2]
  RoundBody body_;  // without mass, which is a column
  std::span<const Vec3d> v_, w_;
  const double& mass_;  // [kg]
  const double& dynamic_;
  std::span<Wrenchd> external_force_;
  collision::ContactSet& contacts_;
};

/// Whether Air can be attached to an entity of this model.
[[nodiscard]] bool feels_air(const Model& model);

}  // namespace murosimf::air
