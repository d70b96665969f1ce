#include "murosimf/collision/body_island_law.h"

#include <span>

#include "murosimf/collision/body_kelvin_voigt_law.h"
#include "murosimf/collision/contact_law.h"
#include "murosimf/collision/contact_parameters.h"
#include "murosimf/model/properties.h"

namespace murosimf::collision {
namespace {

// of moving entities that are members of no island
constexpr int outside = -1;
constexpr int insane = -2;  // it belongs to the island, but its numbers have gone bad

bool ground_becomes_rows(const ContactSeam& seam) { return seam.law && seam.law->island_use() != IslandUse::never; }

}  // namespace

void BodyIslandLaw::push(std::vector<MovingEntity>& moving_entities, PairSet& set, double dt) noexcept {
  islands_.find(moving_entities, set);
  for (PairContact& c : set.points) {
    // levels that cannot answer an island solver
    if (islands_.of(c) < 0)
      push_by_kelvin_voigt(moving_entities, c, for_explicit_step(set.parameters[c.surface], dt), dt);
  }
  member_.assign(moving_entities.size(), outside);
  for (int island = 0; island < islands_.count(); ++island) solve(island, moving_entities, set, dt);
}

void BodyIslandLaw::solve(int island, std::vector<MovingEntity>& moving_entities, PairSet& set, double dt) noexcept {
  const std::span<const int> members = islands_.members(island), touching = islands_.contacts(island);
  solver_.start(dt);
  bool stands = false;
  for (const int i : members) {
    member_[i] = start_member(moving_entities[i], dt);
    stands |= !moving_entities[i].contacts.points.empty();
  }
  for (const int i : members) {
    ContactSet& ground = moving_entities[i].contacts;
    const ContactSeam& seam = moving_entities[i].seam;
    if (member_[i] < 0 || !ground_becomes_rows(seam)) continue;
    for (ContactPoint& c : ground.points) {
      solver_.add(c, seam.terms.parameters[c.surface], side(i, c.object, c.velocity), {});
    }
  }
  const auto is_row = [&](const PairContact& c) { return member_[c.a] != insane && member_[c.b] != insane; };
  for (const int i : touching) {
    PairContact& c = set.points[i];
    if (!is_row(c)) continue;
    solver_.add(c, set.parameters[c.surface], side(c.a, c.object, c.velocity_a), side(c.b, c.object_b, c.velocity_b));
  }
  solver_.sweep(sweeps_);
  solver_.finish();
  for (const int i : touching) {
    const PairContact& c = set.points[i];
    if (!is_row(c)) continue;
    moving_entities[c.a].push(c.object, c.point, c.force, dt);
    moving_entities[c.b].push(c.object_b, c.point, -c.force, dt);
  }
  for (const int i : members) finish_member(moving_entities[i], stands);
}

/// The free pass: pushes of users, explicit laws, and rolling resistance, which is no row.
int BodyIslandLaw::start_member(MovingEntity& moving_entity, double dt) noexcept {
  ContactSet& ground = moving_entity.contacts;
  if (ground_becomes_rows(moving_entity.seam)) {
    for (const int object : ground.loaded) {
      moving_entity.external_force[object] = ground.rest_force[object];
      moving_entity.external_damping[object] = Sym6d{};
    }
    for (const ContactPoint& c : ground.points) {
      moving_entity.external_force[c.object].n += c.moment;
      moving_entity.external_damping[c.object].J += diagonal(c.angular_damping);
    }
  }
  return moving_entity.seam.response->free_pass(dt) ? solver_.add(*moving_entity.seam.response) : insane;
}

/// Memory of a law that is no rows, and forces as they acted, for motion's report and for sensors.
void BodyIslandLaw::finish_member(MovingEntity& moving_entity, bool island_stands) noexcept {
  ContactSet& ground = moving_entity.contacts;
  const ContactSeam& seam = moving_entity.seam;
  if (seam.law) {
    if (!ground_becomes_rows(seam)) {
      next_velocity_.clear();
      for (const ContactPoint& c : ground.points) {
        next_velocity_.push_back(seam.response->free_velocity(c.object, c.point, c.velocity));
      }
      seam.law->commit(ground.points, seam.terms, next_velocity_);
    }
    write_final_forces(ground, moving_entity.r, moving_entity.external_force);
    for (const int object : ground.loaded) moving_entity.external_damping[object] = Sym6d{};
  }
  ground.solved = true;
  ground.island_stands = island_stands;
}

IslandSolver::Side BodyIslandLaw::side(int moving_entity, int object, const Vec3d& velocity) const {
  return {member_[moving_entity], object, velocity};
}

}  // namespace murosimf::collision
