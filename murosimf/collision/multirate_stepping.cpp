#include "murosimf/collision/multirate_stepping.h"

#include <algorithm>

#include "murosimf/collision/compound.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"

namespace murosimf::collision {
namespace {

constexpr double nearness = 0.05;  // [m] margin of the test whether entities are near each other

bool is_due(const Entity& entity, const Instant& instant) {
  MUROSIMF_ASSERT(instant.period > Duration{} && entity.options().step_multiple >= 1);
  return instant.now % (entity.options().step_multiple * instant.period) == Duration{};
}

double reach_of(const Entity& entity) { return compound_of(entity, {}).reach(); }

}  // namespace

MultirateStepping::Mover MultirateStepping::mover(Setup setup) {
  const Entity& entity = setup.entity();
  const bool own = entity.options().step_multiple > 1;
  return {&entity, reach_of(entity), setup.read(properties::position), setup.read(properties::linear_velocity),
          own ? setup.write(properties::step_ratio) : std::span<double>{}};
}

MultirateStepping::MultirateStepping(Setup& setup, const std::vector<Entity*>& moving_entities) {
  for (Entity* entity : moving_entities) movers_.push_back(mover(setup.of(*entity)));
}

void MultirateStepping::initialize() { std::for_each(movers_.begin(), movers_.end(), start); }

void MultirateStepping::start(const Mover& mover) { std::fill(mover.step_ratio.begin(), mover.step_ratio.end(), 1.0); }

void MultirateStepping::entity_entered(const Entity& entity) {
  for (const Mover& mover : movers_) {
    if (mover.entity == &entity) start(mover);
  }
}

void MultirateStepping::entity_added(Setup& setup) { movers_.push_back(mover(setup)); }

void MultirateStepping::entity_taken_back(const Entity& entity) noexcept {
  if (!movers_.empty() && movers_.back().entity == &entity) movers_.pop_back();
}

void MultirateStepping::step(const Instant& instant) noexcept {
  if (any_decides(instant)) decide(instant);
}

bool MultirateStepping::any_decides(const Instant& instant) const noexcept {
  return std::any_of(movers_.begin(), movers_.end(),
                     [&](const Mover& mover) { return !mover.step_ratio.empty() && is_due(*mover.entity, instant); });
}

void MultirateStepping::decide(const Instant& instant) noexcept {
  int most_steps = 1;
  for (const Mover& mover : movers_) most_steps = std::max(most_steps, mover.entity->options().step_multiple);
  const double longest = most_steps * seconds(instant.period);
  // reach over the longest step: an entity must not arrive while another one makes a long step
  near_.clear();
  for (const Mover& mover : movers_) {
    near_.push_back({mover.r[0], mover.reach + 0.5 * nearness + norm(mover.v[0]) * longest});
  }
  has_company_.assign(movers_.size(), false);
  for (const auto& [a, b] : sweep_.find(near_)) {
    MUROSIMF_ASSERT(static_cast<std::size_t>(a) < movers_.size() && static_cast<std::size_t>(b) < movers_.size());
    if (movers_[a].entity->idle() || movers_[b].entity->idle()) continue;
    has_company_[a] = has_company_[b] = true;
  }
  for (std::size_t i = 0; i < movers_.size(); ++i) {
    const Mover& mover = movers_[i];
    if (mover.step_ratio.empty() || !is_due(*mover.entity, instant)) continue;
    mover.step_ratio[0] = has_company_[i] ? 1 : mover.entity->options().step_multiple;
  }
}

}  // namespace murosimf::collision
