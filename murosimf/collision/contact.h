/// contact.h - the points where one entity touches what does not move, and what they do to its bodies.
///
/// Contact and motion meet here: a law turns points into `external_force` and `external_damping` per body; a motion
/// algorithm that integrates implicitly lets the law look at the velocities that its trial step would give, and repeats
/// the step while the law asks for it. Everything in a set is plain data: the law and whatever else works on it stand in
/// the entity's interface (contact_interface.h), other entities are numbers.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "murosimf/collision/contact_point.h"
#include "murosimf/collision/interpenetration.h"
#include "murosimf/math/spatial.h"
#include "murosimf/model/property.h"
#include "murosimf/model/value.h"
#include "murosimf/world/state_archive.h"

namespace murosimf::collision {

/// How much collision detection had to test in a step (paper 7.5).
struct TestCounts {
  std::int64_t volumes = 0;  ///< pairs of bounding volumes
  std::int64_t objects = 0;  ///< pairs of shapes, exactly
};

/// All contacts of one entity with what does not move. One value per entity, kept in a column.
struct ContactSet {
  std::vector<ContactPoint> points;      ///< sorted by feature
  int environment = -1;                  ///< what is touched: number of the entity in the world (World::index_of)
  std::vector<int> environment_objects;  ///< by Contact::surface: which body of the environment
  bool stiff = false;                    ///< what constants the points have (ground_contact.h)
  TestCounts tests;                      ///< of collision detection in this step; no state (body_pairs.h)
  std::optional<Interpenetration> interpenetration;  ///< the first so far, for a warning
  bool solved = false;         ///< an island solver has settled this step already; motion takes it over and resets this
  bool island_stands = false;  ///< in that case: an entity of the island touches the environment

  // what bodies feel besides, so that a trial step can begin anew
  std::vector<Wrenchd> rest_force;                  ///< [N m, N] external force of every object without these contacts
  std::vector<std::pair<int, Sym6d>> rest_damping;  ///< external damping of objects without these contacts
  std::vector<int> loaded;                          ///< objects that carry the force of these contacts
};

void append_hash(Hasher& hasher, const ContactSet& set);
void state(StateArchive& archive, ContactSet& set);

/// Contacts of an entity with static geometry. Contact detection writes it, motion takes the law's decisions in it.
inline constexpr Property<ContactSet> contacts{
    {"contacts", "-", "world", "points where the entity touches the ground, with the law's memory", Scope::base}};

/// Writes the sum of all contacts to the columns: external_force = rest_force + contacts, external_damping =
/// contacts. `r` [m] origins of the objects. Objects without contacts keep what they have.
void write_loads(const ContactSet& set, std::span<const Vec3d> r, std::span<Wrenchd> external_force,
                 std::span<Sym6d> external_damping) noexcept;

/// After the law has committed: external_force = rest_force + the forces that acted in the step (for reports and
/// sensors; the linearization before was about the velocities at its beginning).
void write_final_forces(const ContactSet& set, std::span<const Vec3d> r, std::span<Wrenchd> external_force) noexcept;

}  // namespace murosimf::collision
