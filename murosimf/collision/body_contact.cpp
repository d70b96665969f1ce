#include "murosimf/collision/body_contact.h"

#include <algorithm>
#include <utility>

#include "murosimf/collision/contact_laws/depenetration.h"
#include "murosimf/collision/continuous_collision.h"
#include "murosimf/collision/kinematic_separation.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"

namespace murosimf::collision {
namespace {

std::vector<MovingEntity> make_moving_entities(Setup& setup, const std::vector<Entity*>& entities) {
  std::vector<MovingEntity> moving_entities;
  for (Entity* entity : entities) moving_entities.emplace_back(setup.of(*entity));
  return moving_entities;
}

}  // namespace

BodyContact::BodyContact(Setup& setup, const Entity* environment, const std::vector<Entity*>& moving_entities,
                         const MaterialTable& materials, std::unique_ptr<BodyContactLaw> law)
    : law_(std::move(law)),
      moving_entities_(make_moving_entities(setup, moving_entities)),
      finder_(materials, {seconds(setup.period()), law_->implicit()}, setup.world().gravity),
      period_(seconds(setup.period())),
      gravity_(setup.world().gravity),
      set_(setup.write(pair_contacts)[0]),
      environment_(static_compound_of(environment)) {
  for (const MovingEntity& moving_entity : moving_entities_) finder_.add(moving_entity);
  MUROSIMF_ASSERT(law_);
}

void BodyContact::initialize() {
  set_ = PairSet{};
  for (const MovingEntity& moving_entity : moving_entities_) set_.entities.push_back(moving_entity.number);
  set_.parameters = finder_.parameters();
  for (MovingEntity& moving_entity : moving_entities_) start(moving_entity);
}

void BodyContact::start(MovingEntity& moving_entity) {
  std::fill(moving_entity.interaction_force.begin(), moving_entity.interaction_force.end(), Wrenchd{});
  std::fill(moving_entity.external_force.begin(), moving_entity.external_force.end(), Wrenchd{});
  std::fill(moving_entity.external_damping.begin(), moving_entity.external_damping.end(), Sym6d{});
  moving_entity.ledger[0] = Wrenchd{};
  moving_entity.separation[0] = {};
  moving_entity.interface.terms.dt = period_;
  moving_entity.interface.damped_by_others = law_->damps();
}

void BodyContact::entity_added(Setup& setup) {
  moving_entities_.emplace_back(setup);
  finder_.add(moving_entities_.back());
  set_.entities.push_back(moving_entities_.back().number);
  renumber_surfaces();
}

void BodyContact::entity_taken_back(const Entity& entity) noexcept {
  if (moving_entities_.empty() || moving_entities_.back().entity != &entity) return;
  moving_entities_.pop_back();
  finder_.take_back();
  set_.entities.pop_back();
  renumber_surfaces();
}

void BodyContact::renumber_surfaces() {
  set_.parameters = finder_.parameters();
  finder_.number_surfaces(set_);
}

void BodyContact::model_exchanged(const Entity& entity) {
  const auto changed = std::ranges::find(moving_entities_, &entity, &MovingEntity::entity);
  if (changed == moving_entities_.end()) return;
  changed->take_shapes();
  finder_.model_exchanged(moving_entities_, entity, set_);
  set_.parameters = finder_.parameters();
}

void BodyContact::exchange_materials(const MaterialTable& materials) {
  finder_.exchange_materials(materials);
  set_.parameters = finder_.parameters();
}

void BodyContact::entity_entered(const Entity& entity) {
  for (MovingEntity& moving_entity : moving_entities_) {
    if (moving_entity.entity == &entity) start(moving_entity);
  }
}

void BodyContact::state(StateArchive& archive) {
  // entities that were added after the state was saved keep what they are, but for pushes
  std::size_t known = moving_entities_.size();
  archive(known);
  for (std::size_t i = 0; i < moving_entities_.size(); ++i) {
    if (i < known) {
      archive(moving_entities_[i]);
    } else {
      moving_entities_[i].forget_pushes();  // was added since
    }
  }
}

void BodyContact::step(const Instant& instant) noexcept {
  const double dt = seconds(instant.period);
  MUROSIMF_ASSERT(dt > 0);
  for (MovingEntity& moving_entity : moving_entities_) moving_entity.start_step();
  finder_.find(moving_entities_, set_);
  // before depths are changed by the depenetration below: reports show the depths that were found
  note_interpenetrations(moving_entities_, dt, instant.now, set_);
  for (PairContact& c : set_.points) end_depenetration(c, set_.parameters[c.surface], dt);
  kinematic_separation(moving_entities_, *environment_, finder_.within_reach(), dt, set_);
  stop_at_touch(moving_entities_, set_, *environment_, gravity_, dt);
  SerialFor serial;
  law_->push(moving_entities_, set_, dt, instant.parallel_for ? *instant.parallel_for : serial);
}

}  // namespace murosimf::collision
