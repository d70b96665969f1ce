/// contact.h - points where a body touches something, and the set of them that one entity has.
///
/// The seam between contact and motion: a law turns contacts into `external_force` and
/// `external_damping` per body; a motion algorithm that integrates implicitly lets the law look at the velocities
/// that its trial step would give, and repeats the step while the law asks for it.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "murosimf/math/spatial.h"
#include "murosimf/model/property.h"
#include "murosimf/model/value.h"

namespace murosimf {
class Entity;
}

namespace murosimf::collision {

/// What collision detection finds: geometry only.
struct Contact {
  int object = 0;             ///< body A, the one that feels +force
  std::uint64_t feature = 0;  ///< which corner of which shape; stays the same from step to step
  std::uint32_t surface = 0;  ///< index of the pair's constants (ContactSet::parameters)
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
  Vec3d friction_direction;  ///< [1] world frame: friction towards the unit vector d is mu (1 - friction_direction . d)
  double theta = 1;          ///< [1] 1: depth after the step counts, 0: depth before it
};

enum class ContactState : std::uint8_t { open, stick, slip };

/// A contact with the law's memory and its present linearization: force on A for a velocity v+ after the step is
///     f = force - (b_n n n^T + b_t (1 - n n^T - d d^T)) (v+ - v),     moment = moment - b_w (w+ - w)
/// with d the direction of sliding, along which friction does not depend on the speed; zero while sticking.
struct ContactPoint : Contact {
  Vec3d velocity;          ///< [m/s] v: A's point against B's, world frame, at the beginning of the step
  Vec3d angular_velocity;  ///< [rad/s] w: A against B, world frame
  Vec3d stretch;           ///< [m] memory: displacement of the tangential spring
  ContactState state = ContactState::stick;
  Vec3d force;                                     ///< [N] world frame
  Vec3d moment;                                    ///< [N m] world frame, besides what the force does at the point
  double normal_damping = 0, tangent_damping = 0;  ///< [N s/m] b_n, b_t
  double angular_damping = 0;                      ///< [N m s] b_w
  double last_normal_force = 0;                    ///< [N] of the pass before: a sliding force follows it
  Vec3d slip_direction;                            ///< [1] d, unit or zero
};

void append_hash(Hasher& hasher, const ContactPoint& point);

/// How much collision detection had to test in a step (paper 7.5).
struct TestCounts {
  std::int64_t volumes = 0;  ///< pairs of bounding volumes
  std::int64_t objects = 0;  ///< pairs of shapes, exactly
};

class ContactLaw;
class ImpulseResponse;

/// All contacts of one entity with what does not move. One value per entity, kept in a column.
struct ContactSet {
  std::vector<ContactPoint> points;           ///< sorted by feature
  std::vector<ContactParameters> parameters;  ///< by Contact::surface
  const Entity* environment = nullptr;        ///< what is touched
  std::vector<int> environment_objects;       ///< by Contact::surface: which body of the environment
  const ContactLaw* law = nullptr;
  double dt = 0;                        ///< [s] of contact's steps; motion must have the same. 0: no contact attached
  ImpulseResponse* response = nullptr;  ///< of the level that moves the entity, for island solvers; null: none
  bool damped_by_others = false;        ///< contact between bodies adds external damping: motion must be implicit in it
  TestCounts tests;                     ///< of collision detection in this step
  bool solved = false;         ///< an island solver has settled this step already; motion takes it over and resets this
  bool island_stands = false;  ///< in that case: somebody in the island touches the environment

  // working memory, kept to avoid allocation
  std::vector<ContactPoint> previous;
  std::vector<Vec3d> next_velocity;                 ///< [m/s] of every point after the trial step; motion fills it
  std::vector<Wrenchd> rest_force;                  ///< [N m, N] external force of every object without these contacts
  std::vector<std::pair<int, Sym6d>> rest_damping;  ///< external damping of objects without these contacts
  std::vector<int> loaded;                          ///< objects that carry the force of these contacts
};

void append_hash(Hasher& hasher, const ContactSet& set);

/// Contacts of an entity with static geometry. Contact detection writes it, motion takes the law's decisions in it.
inline constexpr Property<ContactSet> contacts{
    {"contacts", "-", "world", "points where the entity touches the ground, with the law's memory", Scope::base}};

/// Writes the sum of all contacts to the columns: external_force = rest_force + contacts, external_damping =
/// contacts. `r` [m] origins of the objects. Objects without contacts keep what they have.
void write_loads(ContactSet& set, std::span<const Vec3d> r, std::span<Wrenchd> external_force,
                 std::span<Sym6d> external_damping) noexcept;

/// After the law has committed: external_force = rest_force + the forces that acted in the step (for reports and
/// sensors; the linearization before was about the velocities at its beginning).
void write_final_forces(const ContactSet& set, std::span<const Vec3d> r, std::span<Wrenchd> external_force) noexcept;

/// The step is settled: memory of the law, and the forces that acted in the column. Does nothing if an island solver
/// has done it already. `r` [m] origins of the objects at the beginning of the step.
void commit_contacts(ContactSet& set, std::span<const Vec3d> r, std::span<Wrenchd> external_force) noexcept;

/// The law's memory of a point goes on: what `old` has at the end of its step.
void recall(const ContactPoint& old, ContactPoint& point) noexcept;

}  // namespace murosimf::collision
