#include "murosimf/collision/body_contact.h"

#include <algorithm>

#include "murosimf/collision/contact_law.h"
#include "murosimf/collision/kinematic_separation.h"
#include "murosimf/model/properties.h"

namespace murosimf::collision {
namespace {

std::vector<MovingEntity> make_moving_entities(Setup& setup, const std::vector<Entity*>& entities) {
  std::vector<MovingEntity> moving_entities;
  for (Entity* entity : entities) moving_entities.emplace_back(setup.of(*entity));
  return moving_entities;
}

// of moving entities that are no members of the island at hand
constexpr int outside = -1;
constexpr int insane = -2;  // it belongs to the island, but its numbers have gone bad

bool ground_becomes_rows(const ContactSeam& seam) { return seam.law && seam.law->island_use() != IslandUse::never; }

}  // namespace

BodyContact::BodyContact(Setup& setup, const std::vector<Entity*>& moving_entities, const MaterialTable& materials,
                         const BodyContactOptions& options)
    : options_(options),
      moving_entities_(make_moving_entities(setup, moving_entities)),
      finder_(moving_entities_, materials, norm(setup.world().gravity), seconds(setup.period())),
      period_(seconds(setup.period())),
      set_(setup.write(pair_contacts)[0]),
      environment_(&setup.entity()),
      member_(moving_entities.size(), -1) {}

void BodyContact::initialize() {
  set_ = PairSet{};
  set_.parameters = finder_.parameters();
  for (const MovingEntity& moving_entity : moving_entities_) set_.entities.push_back(moving_entity.number);
  for (MovingEntity& moving_entity : moving_entities_) {
    std::fill(moving_entity.interaction_force.begin(), moving_entity.interaction_force.end(), Wrenchd{});
    std::fill(moving_entity.external_force.begin(), moving_entity.external_force.end(), Wrenchd{});
    std::fill(moving_entity.external_damping.begin(), moving_entity.external_damping.end(), Sym6d{});
    moving_entity.ledger[0] = Wrenchd{};
    moving_entity.separation[0] = {};
    moving_entity.seam.terms.dt = period_;
    moving_entity.seam.damped_by_others = options_.law == BodyContactLaw::carry;
  }
}

void BodyContact::step(const Instant& instant) noexcept {
  const double dt = seconds(instant.period);
  for (MovingEntity& moving_entity : moving_entities_) moving_entity.start_step();
  finder_.find(moving_entities_, set_);
  kinematic_separation(moving_entities_, environment_, set_);
  switch (options_.law) {
    case BodyContactLaw::carry: return push_by_carry(moving_entities_, set_, dt);
    case BodyContactLaw::kelvin_voigt:
      for (PairContact& c : set_.points) push_by_kelvin_voigt(moving_entities_, c, set_.parameters[c.surface], dt);
      return;
    case BodyContactLaw::island_gauss_seidel: return solve_islands(dt);
  }
}

void BodyContact::solve_islands(double dt) noexcept {
  islands_.find(moving_entities_, set_);
  for (PairContact& c : set_.points) {
    // levels that cannot answer an island solver
    if (islands_.of(c) < 0) push_by_kelvin_voigt(moving_entities_, c, set_.parameters[c.surface], dt);
  }
  for (int island = 0; island < islands_.count(); ++island) solve_island(island, dt);
}

void BodyContact::solve_island(int island, double dt) noexcept {
  solver_.start(dt);
  bool stands = false;
  for (std::size_t i = 0; i < moving_entities_.size(); ++i) {
    member_[i] = outside;
    if (islands_.of(static_cast<int>(i)) != island) continue;
    member_[i] = start_member(moving_entities_[i], dt);
    stands |= !moving_entities_[i].contacts.points.empty();
  }
  for (std::size_t i = 0; i < moving_entities_.size(); ++i) {
    ContactSet& ground = moving_entities_[i].contacts;
    const ContactSeam& seam = moving_entities_[i].seam;
    if (member_[i] < 0 || !ground_becomes_rows(seam)) continue;
    for (ContactPoint& c : ground.points) {
      solver_.add(c, seam.terms.parameters[c.surface], side(static_cast<int>(i), c.object, c.velocity), {});
    }
  }
  const auto is_row = [&](const PairContact& c) {
    return islands_.of(c) == island && member_[c.a] != insane && member_[c.b] != insane;
  };
  for (PairContact& c : set_.points) {
    if (!is_row(c)) continue;
    solver_.add(c, set_.parameters[c.surface], side(c.a, c.object, c.velocity_a), side(c.b, c.object_b, c.velocity_b));
  }
  solver_.sweep(options_.sweeps);
  solver_.finish();
  for (const PairContact& c : set_.points) {
    if (!is_row(c)) continue;
    moving_entities_[c.a].push(c.object, c.point, c.force, dt);
    moving_entities_[c.b].push(c.object_b, c.point, -c.force, dt);
  }
  for (std::size_t i = 0; i < moving_entities_.size(); ++i) {
    if (member_[i] != outside) finish_member(moving_entities_[i], stands);
  }
}

/// The free pass: pushes of users, explicit laws, and rolling resistance, which is no row.
int BodyContact::start_member(MovingEntity& moving_entity, double dt) noexcept {
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
void BodyContact::finish_member(MovingEntity& moving_entity, bool island_stands) noexcept {
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

IslandSolver::Side BodyContact::side(int moving_entity, int object, const Vec3d& velocity) const {
  return {member_[moving_entity], object, velocity};
}

}  // namespace murosimf::collision
