#include "murosimf/collision/body_contact.h"

#include <algorithm>

#include "murosimf/collision/contact_law.h"
#include "murosimf/collision/keep_apart.h"
#include "murosimf/model/properties.h"

namespace murosimf::collision {
namespace {

std::vector<Mover> make_movers(Setup& setup, const std::vector<Entity*>& entities) {
  std::vector<Mover> movers;
  for (Entity* entity : entities) movers.emplace_back(setup.of(*entity));
  return movers;
}

// of movers that are no members of the island at hand
constexpr int outside = -1;
constexpr int insane = -2;  // it belongs to the island, but its numbers have gone bad

bool ground_becomes_rows(const ContactSet& ground) {
  return ground.law && ground.law->island_use() != IslandUse::never;
}

}  // namespace

BodyContact::BodyContact(Setup& setup, const std::vector<Entity*>& movers, const MaterialTable& materials,
                         const BodyContactOptions& options)
    : options_(options),
      movers_(make_movers(setup, movers)),
      finder_(movers_, materials, norm(setup.world().gravity), seconds(setup.period())),
      period_(seconds(setup.period())),
      set_(setup.write(pair_contacts)[0]),
      environment_(&setup.entity()),
      member_(movers.size(), -1) {}

void BodyContact::initialize() {
  set_ = PairSet{};
  set_.parameters = finder_.parameters();
  for (const Mover& mover : movers_) set_.entities.push_back(mover.entity);
  for (Mover& mover : movers_) {
    std::fill(mover.interaction_force.begin(), mover.interaction_force.end(), Forced{});
    std::fill(mover.external_force.begin(), mover.external_force.end(), Forced{});
    std::fill(mover.external_damping.begin(), mover.external_damping.end(), Sym6d{});
    mover.ledger[0] = Forced{};
    mover.separation[0] = {};
    mover.contacts.dt = period_;
    mover.contacts.damped_by_others = options_.law == PairLaw::carry;
  }
}

void BodyContact::step(const Instant& instant) noexcept {
  const double dt = seconds(instant.period);
  for (Mover& mover : movers_) mover.start_step();
  finder_.find(movers_, set_);
  keep_apart(movers_, environment_, set_);
  switch (options_.law) {
    case PairLaw::carry: return push_by_carry(movers_, set_, dt);
    case PairLaw::kelvin_voigt:
      for (PairContact& c : set_.points) push_by_kelvin_voigt(movers_, c, set_.parameters[c.surface], dt);
      return;
    case PairLaw::island_gauss_seidel: return solve_islands(dt);
  }
}

void BodyContact::solve_islands(double dt) noexcept {
  islands_.find(movers_, set_);
  for (PairContact& c : set_.points) {
    // levels that cannot answer an island solver
    if (islands_.of(c) < 0) push_by_kelvin_voigt(movers_, c, set_.parameters[c.surface], dt);
  }
  for (int island = 0; island < islands_.count(); ++island) solve_island(island, dt);
}

void BodyContact::solve_island(int island, double dt) noexcept {
  solver_.start(dt);
  bool stands = false;
  for (std::size_t i = 0; i < movers_.size(); ++i) {
    member_[i] = outside;
    if (islands_.of(static_cast<int>(i)) != island) continue;
    member_[i] = start_member(movers_[i], dt);
    stands |= !movers_[i].contacts.points.empty();
  }
  for (std::size_t i = 0; i < movers_.size(); ++i) {
    ContactSet& ground = movers_[i].contacts;
    if (member_[i] < 0 || !ground_becomes_rows(ground)) continue;
    for (ContactPoint& c : ground.points) {
      solver_.add(c, ground.parameters[c.surface], side(static_cast<int>(i), c.object, c.velocity), {});
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
    movers_[c.a].push(c.object, c.point, c.force, dt);
    movers_[c.b].push(c.object_b, c.point, -c.force, dt);
  }
  for (std::size_t i = 0; i < movers_.size(); ++i) {
    if (member_[i] != outside) finish_member(movers_[i], stands);
  }
}

/// The free pass: pushes of users, explicit laws, and rolling resistance, which is no row.
int BodyContact::start_member(Mover& mover, double dt) noexcept {
  ContactSet& ground = mover.contacts;
  if (ground_becomes_rows(ground)) {
    for (const int object : ground.loaded) {
      mover.external_force[object] = ground.rest_force[object];
      mover.external_damping[object] = Sym6d{};
    }
    for (const ContactPoint& c : ground.points) {
      mover.external_force[c.object].n += c.moment;
      mover.external_damping[c.object].J += diagonal(c.angular_damping);
    }
  }
  return ground.response->free_pass(dt) ? solver_.add(*ground.response) : insane;
}

/// Memory of a law that is no rows, and forces as they acted, for motion's report and for sensors.
void BodyContact::finish_member(Mover& mover, bool island_stands) noexcept {
  ContactSet& ground = mover.contacts;
  if (ground.law) {
    if (!ground_becomes_rows(ground)) {
      ground.next_velocity.clear();
      for (const ContactPoint& c : ground.points) {
        ground.next_velocity.push_back(ground.response->free_velocity(c.object, c.point, c.velocity));
      }
      ground.law->commit(ground);
    }
    write_final_forces(ground, mover.r, mover.external_force);
    for (const int object : ground.loaded) mover.external_damping[object] = Sym6d{};
  }
  ground.solved = true;
  ground.island_stands = island_stands;
}

IslandSolver::Side BodyContact::side(int mover, int object, const Vec3d& velocity) const {
  return {member_[mover], object, velocity};
}

}  // namespace murosimf::collision
