#include "murosimf/dynamics/push.h"

#include <algorithm>

#include "murosimf/collision/contact_properties.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"

namespace murosimf::dynamics {
namespace {

/// [1] Share of the step during which the push lasts.
double share_of_step(const TimedPush& push, const Instant& instant) {
  MUROSIMF_ASSERT(instant.period > Duration{});
  const Duration from = std::max(push.begin, instant.now), to = std::min(push.end, instant.now + instant.period);
  return to > from ? seconds(to - from) / seconds(instant.period) : 0;
}

bool same_push(const Wrenchd& a, const Wrenchd& b) { return is_zero(Wrenchd{a.n - b.n, a.f - b.f}); }

}  // namespace

Push::Push(Setup& setup, std::vector<TimedPush> pushes)
    : entity_(setup.entity()),
      pushes_(std::move(pushes)),
      R_(setup.read(properties::orientation)),
      applied_force_(setup.write(properties::applied_force)) {
  for (const TimedPush& push : pushes_) take_up(push.object);
}

void Push::take_up(int object) {
  MUROSIMF_ASSERT(object >= 0 && object < entity_.model().size());
  if (std::ranges::find(pushed_, object, &Pushed::object) != pushed_.end()) return;
  const Vec3d* center = entity_.model().find(properties::center_of_mass, object);
  pushed_.push_back({object, center ? *center : Vec3d{}, {}, {}});
}

void Push::add(const TimedPush& push) {
  std::erase_if(pushes_, [&](const TimedPush& other) { return other.end < push.begin; });
  // pushes that are over would only cost time in every step
  pushes_.push_back(push);
  take_up(push.object);
}

void Push::initialize() { std::fill(applied_force_.begin(), applied_force_.end(), Wrenchd{}); }

void Push::state(StateArchive& archive) { archive(pushes_, pushed_); }

void Push::model_exchanged(const Entity& entity) {
  if (&entity != &entity_) return;
  for (Pushed& pushed : pushed_) {
    const Vec3d* center = entity.model().find(properties::center_of_mass, pushed.object);
    pushed.center = center ? *center : Vec3d{};
  }
}

Wrenchd Push::sum_for(const Pushed& pushed, const Instant& instant) const noexcept {
  Wrenchd sum;
  for (const TimedPush& push : pushes_) {
    // a push that ends within the step acts with that share of its force: its impulse is exact
    const double share = push.object == pushed.object ? share_of_step(push, instant) : 0;
    if (share == 0) continue;
    const Vec3d arm = R_[pushed.object] * pushed.center;
    sum += Wrenchd{share * (push.moment + cross(arm, push.force)), share * push.force};
  }
  return sum;
}

void Push::step(const Instant& instant) noexcept {
  for (Pushed& pushed : pushed_) {
    Wrenchd& applied = applied_force_[pushed.object];
    // an unchanged number is our own; any other has been set by a user and is kept below the pushes
    if (!same_push(applied, pushed.written)) pushed.own = applied;
    applied = pushed.own;
    applied += sum_for(pushed, instant);
    pushed.written = applied;
  }
}

}  // namespace murosimf::dynamics
