/// contact_point.h - one point where a body touches something: plain data, which can be copied byte for byte, stored and
/// read back.
#pragma once

#include <cstdint>
#include <type_traits>
#include <vector>

#include "murosimf/math/hash.h"
#include "murosimf/math/mat3.h"

namespace murosimf {
class StateArchive;
}  // namespace murosimf

namespace murosimf::collision {

/// What collision detection finds: geometry only.
struct Contact {
  int object = 0;             ///< body A, the one that feels +force
  std::uint64_t feature = 0;  ///< which corner of which shape; stays the same from step to step
  std::uint32_t surface = 0;  ///< index of the pair's constants (ContactTerms::parameters)
  Vec3d point;                ///< [m] world frame
  Vec3d normal;               ///< [1] unit, world frame, from B to A
  double depth = 0;           ///< [m] overlap along the normal, positive
  double radius = 0;          ///< [m] of a round body at the point, 0 for corners: arm of the rolling resistance
};

/// Constants of a contact point, from the pair of surfaces and the weight of the robot (contact_parameters.h).
struct ContactParameters {
  double stiffness = 0;          ///< [N/m] k, normal
  double damping = 0;            ///< [N s/m] d, normal
  double tangent_stiffness = 0;  ///< [N/m] kt
  double tangent_damping = 0;    ///< [N s/m] ct
  double friction = 0;           ///< [1] mu
  double rolling = 0;            ///< [1] rolling resistance
  double torsional = 0;          ///< [m] resistance of a round body to spinning
  double restitution = -1;       ///< [1] of a body that bounces; negative: it has none
  Vec3d friction_direction;  ///< [1] world frame: friction towards the unit vector d is mu (1 - friction_direction . d)
  Vec3d rolling_direction;   ///< [1] the same of the rolling resistance, d where the body rolls to
  double mass = 0;           ///< [kg] that moves at the point, as the constants were chosen for
  double theta = 1;          ///< [1] 1: depth after the step counts, 0: depth before it
  double rebound = 1;        ///< [1] s_b of the paper's laws (paper_law.h)
  double viscous_friction = 0;  ///< [s/m] s_mu of these
  double spin_friction = 0;     ///< [m s] s_nu of these
};

/// Input of a law besides the points: the constants of one entity's contacts, the same in every step.
struct ContactTerms {
  std::vector<ContactParameters> parameters;  ///< by Contact::surface
  double dt = 0;                              ///< [s] of contact's steps; 0: no contact attached
};

enum class ContactState : std::uint8_t { open, stick, slip };

/// A contact with the law's memory and its present linearization: force on A for a velocity v+ after the step is
///     f = force - (b_n n n^T + b_t (1 - n n^T - d d^T)) (v+ - v),     moment = moment - (b_w (1 - n n^T) + b_s n n^T) (w+ - w)
/// with d the direction of sliding, along which friction does not depend on the speed; zero while sticking.
struct ContactPoint : Contact {
  Vec3d velocity;          ///< [m/s] v: A's point against B's, world frame, at the beginning of the step
  Vec3d angular_velocity;  ///< [rad/s] w: A against B, world frame
  Vec3d stretch;           ///< [m] memory: displacement of the tangential spring
  ContactState state = ContactState::stick;
  Vec3d force;                                     ///< [N] world frame
  Vec3d moment;                                    ///< [N m] world frame, besides what the force does at the point
  double normal_damping = 0, tangent_damping = 0;  ///< [N s/m] b_n, b_t
  double angular_damping = 0;                      ///< [N m s] b_w, about axes across n
  double spin_damping = 0;                         ///< [N m s] b_s, about n
  double last_normal_force = 0;                    ///< [N] of the pass before: a sliding force follows it
  Vec3d slip_direction;                            ///< [1] d, unit or zero
  double lift = 0;     ///< [m/s] contact lets the point out no faster (depenetration.h); 0: no bound
  double bounce = -1;  ///< [m/s] at which it leaves at least (bounce.h); negative: what its spring gives
};

static_assert(std::is_trivially_copyable_v<ContactPoint>);

void append_hash(Hasher& hasher, const ContactPoint& point);
void state(StateArchive& archive, ContactPoint& point);

/// b_w (1 - n n^T) + b_s n n^T [N m s].
[[nodiscard]] SymMat3d angular_damping_matrix(const ContactPoint& point) noexcept;

/// The law's memory of a point goes on: what `old` has at the end of its step.
void recall(const ContactPoint& old, ContactPoint& point) noexcept;

}  // namespace murosimf::collision
