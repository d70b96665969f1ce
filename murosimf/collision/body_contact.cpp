#include "murosimf/collision/body_contact.h"

#include <algorithm>
#include <utility>

#include "murosimf/collision/kinematic_separation.h"
#include "murosimf/model/properties.h"

namespace murosimf::collision {
namespace {

std::vector<MovingEntity> make_moving_entities(Setup& setup, const std::vector<Entity*>& entities) {
  std::vector<MovingEntity> moving_entities;
  for (Entity* entity : entities) moving_entities.emplace_back(setup.of(*entity));
  return moving_entities;
}

}  // namespace

BodyContact::BodyContact(Setup& setup, const std::vector<Entity*>& moving_entities, const MaterialTable& materials,
                         std::unique_ptr<BodyContactLaw> law)
    : law_(std::move(law)),
      moving_entities_(make_moving_entities(setup, moving_entities)),
      finder_(moving_entities_, materials, norm(setup.world().gravity), seconds(setup.period())),
      period_(seconds(setup.period())),
      set_(setup.write(pair_contacts)[0]),
      environment_(&setup.entity()) {}

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
    moving_entity.seam.damped_by_others = law_->damps();
  }
}

void BodyContact::state(StateArchive& archive) {
  for (MovingEntity& moving_entity : moving_entities_) archive(moving_entity);
}

void BodyContact::step(const Instant& instant) noexcept {
  const double dt = seconds(instant.period);
  for (MovingEntity& moving_entity : moving_entities_) moving_entity.start_step();
  finder_.find(moving_entities_, set_);
  kinematic_separation(moving_entities_, environment_, finder_.within_reach(), set_);
  law_->push(moving_entities_, set_, dt);
}

}  // namespace murosimf::collision
