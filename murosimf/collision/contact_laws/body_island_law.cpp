#include "murosimf/collision/contact_laws/body_island_law.h"

#include <algorithm>
#include <span>

#include "murosimf/collision/contact_laws/body_explicit_laws.h"
#include "murosimf/collision/contact_laws/contact_law.h"
#include "murosimf/collision/contact_laws/contact_parameters.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"

namespace murosimf::collision {
namespace {

bool ground_becomes_rows(const ContactInterface& interface) {
  return interface.law && interface.law->island_use() != IslandUse::never;
}

}  // namespace

void BodyIslandLaw::push(std::vector<MovingEntity>& moving_entities, PairSet& set, double dt,
                         ParallelFor& parallel_for) noexcept {
  MUROSIMF_ASSERT(dt > 0);
  find_islands(moving_entities, set);
  for (PairContact& c : set.points) {
    // contacts without an entity that answers impulses: no island contains them
    if (islands_.of(c) < 0)
      push_by_kelvin_voigt(moving_entities, c, for_explicit_step(set.parameters[c.surface], dt), dt);
  }
  parallel_for.for_each(entities_, [&](std::size_t i) {
    const int member = in_islands_[i];
    member_[member].number = start_member(moving_entities[member], dt) ? 0 : insane;
  });
  parallel_for.for_each(first_members_, [&](std::size_t i) { solve(static_cast<int>(i), moving_entities, set, dt); });
  count_unsettled(moving_entities, dt, set);
  // in order, after the parallel part: sums of several islands on one entity have a fixed order
  for (int island = 0; island < islands_.count(); ++island) push_members(island, moving_entities, set, dt);
  parallel_for.for_each(entities_, [&](std::size_t i) { finish_member(in_islands_[i], moving_entities); });
}

void BodyIslandLaw::find_islands(const std::vector<MovingEntity>& moving_entities, const PairSet& set) {
  islands_.find(moving_entities, set);
  member_.resize(moving_entities.size());
  if (island_.size() < static_cast<std::size_t>(islands_.count())) island_.resize(islands_.count());
  in_islands_.clear();
  entities_.clear();
  first_members_.clear();
  for (int i = 0; i < static_cast<int>(moving_entities.size()); ++i) {
    member_[i].number = outside;
    if (islands_.of(i) < 0) continue;
    in_islands_.push_back(i);
    entities_.push_back(moving_entities[i].entity);
  }
  for (int island = 0; island < islands_.count(); ++island) {
    first_members_.push_back(moving_entities[islands_.members(island).front()].entity);
  }
}

/// Executes the free pass with the pushes of users, explicit laws, and rolling resistance, which has no row in the solver. Returns
/// whether its numbers are sane.
bool BodyIslandLaw::start_member(MovingEntity& moving_entity, double dt) noexcept {
  MUROSIMF_ASSERT(dt > 0 && moving_entity.interface.response);
  ContactSet& ground = moving_entity.contacts;
  if (ground_becomes_rows(moving_entity.interface)) {
    for (const int object : ground.loaded) {
      moving_entity.external_force[object] = ground.rest_force[object];
      moving_entity.external_damping[object] = Sym6d{};
    }
    for (const ContactPoint& c : ground.points) {
      moving_entity.external_force[c.object].n += c.moment;
      moving_entity.external_damping[c.object].J += angular_damping_matrix(c);
    }
  }
  return moving_entity.interface.response->free_pass(dt);
}

/// Computes forces and memory of all contacts of an island.
void BodyIslandLaw::solve(int number, std::vector<MovingEntity>& moving_entities, PairSet& set, double dt) noexcept {
  MUROSIMF_ASSERT(number >= 0 && static_cast<std::size_t>(number) < island_.size());
  Island& island = island_[number];
  IslandSolver& solver = island.solver;
  solver.start(dt);
  island.stands = false;
  for (const int i : islands_.members(number)) {
    if (member_[i].number != insane) member_[i].number = solver.add(*moving_entities[i].interface.response);
    island.stands |= !moving_entities[i].contacts.points.empty();
  }
  for (const int i : islands_.members(number)) {
    const ContactInterface& interface = moving_entities[i].interface;
    if (member_[i].number < 0 || !ground_becomes_rows(interface)) continue;
    for (ContactPoint& c : moving_entities[i].contacts.points) {
      solver.add(c, interface.terms.parameters[c.surface], side(i, c.object, c.velocity), {});
    }
  }
  for (const int i : islands_.contacts(number)) {
    PairContact& c = set.points[i];
    if (!is_row(c)) continue;
    solver.add(c, set.parameters[c.surface], side(c.a, c.object, c.velocity_a), side(c.b, c.object_b, c.velocity_b));
  }
  solver.sweep(sweeps_);
  solver.finish_points();
}

void BodyIslandLaw::count_unsettled(const std::vector<MovingEntity>& moving_entities, double dt,
                                    PairSet& set) const noexcept {
  UnsettledSteps& second = set.unsettled;  // sums over a second: single steps that do not settle are normal
  IslandSolver::Rest most;
  for (int island = 0; island < islands_.count(); ++island) {
    const IslandSolver::Rest& rest = island_[island].solver.rest();
    most.sweeps = std::max(most.sweeps, rest.sweeps);
    most.change = std::max(most.change, rest.change);
    if (rest.change <= second.most_left) continue;
    second.most_left = rest.change;
    second.first = moving_entities[islands_.members(island).front()].number;
    second.members = static_cast<int>(islands_.members(island).size());
  }
  if (most.change > 0) ++second.unsettled;
  second.sweeps += most.sweeps;
  second.left += most.change;
  if (++second.steps * dt < 1) return;
  if (second.left > set.most_unsettled.left) set.most_unsettled = second;
  second = {};
}

/// Several islands may push one entity that cannot be pushed, and add to its ledger.
void BodyIslandLaw::push_members(int island, std::vector<MovingEntity>& moving_entities, const PairSet& set,
                                 double dt) noexcept {
  for (const int i : islands_.contacts(island)) {
    const PairContact& c = set.points[i];
    if (!is_row(c)) continue;
    moving_entities[c.a].push(c.object, c.point, c.force, dt);
    moving_entities[c.b].push(c.object_b, c.point, -c.force, dt);
  }
}

/// What motion takes over, memory of a law that is no rows, and forces as they acted, for motion's report and for sensors.
void BodyIslandLaw::finish_member(int number, std::vector<MovingEntity>& moving_entities) noexcept {
  MovingEntity& moving_entity = moving_entities[number];
  Member& member = member_[number];
  const Island& island = island_[islands_.of(number)];
  ContactSet& ground = moving_entity.contacts;
  const ContactInterface& interface = moving_entity.interface;
  if (member.number >= 0) island.solver.apply(member.number);
  if (interface.law) {
    if (!ground_becomes_rows(interface)) {
      member.next_velocity.clear();
      for (const ContactPoint& c : ground.points) {
        member.next_velocity.push_back(interface.response->free_velocity(c.object, c.point, c.velocity));
      }
      interface.law->commit(ground.points, interface.terms, member.next_velocity);
    }
    write_final_forces(ground, moving_entity.r, moving_entity.external_force);
    for (const int object : ground.loaded) moving_entity.external_damping[object] = Sym6d{};
  }
  ground.solved = true;
  ground.island_stands = island.stands;
}

bool BodyIslandLaw::is_row(const PairContact& contact) const {
  MUROSIMF_ASSERT(static_cast<std::size_t>(contact.a) < member_.size() &&
                  static_cast<std::size_t>(contact.b) < member_.size());
  return member_[contact.a].number != insane && member_[contact.b].number != insane;
}

IslandSolver::Side BodyIslandLaw::side(int moving_entity, int object, const Vec3d& velocity) const {
  return {member_[moving_entity].number, object, velocity};
}

}  // namespace murosimf::collision
