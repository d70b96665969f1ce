#include "murosimf/scene/unsettled_warning.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/collision/body_pairs.h"
#include "murosimf/collision/contact_properties.h"
#include "murosimf/math/assert.h"

namespace murosimf::scene {
namespace {

constexpr double share = 0.5;  // [1] of the steps of a second
constexpr double left = 0.1;   // [m/s] on average
constexpr double grain = 50;   // [Hz] grid of the suggested rate

/// Whether an entity has penetrated deeply: its contact is too soft, and no step length cures that.
bool gives_way(const World& world, const collision::PairSet& pairs, int entity) {
  MUROSIMF_ASSERT(entity >= 0 && static_cast<std::size_t>(entity) < world.entities().size());
  const auto* ground = world.entities()[static_cast<std::size_t>(entity)]->find(collision::contacts);
  if (ground && ground->values[0].interpenetration) return true;
  return std::ranges::any_of(pairs.interpenetrations,
                             [&](const auto& one) { return one.a == entity || one.b == entity; });
}

}  // namespace

std::string unsettled_warning(const World& world) {
  const auto* pairs = world.common().find(collision::pair_contacts);
  if (!pairs) return {};
  const collision::UnsettledSteps& second = pairs->values[0].most_unsettled;
  if (second.unsettled == 0 || second.unsettled < share * second.steps || second.left < left * second.steps) return {};
  if (gives_way(world, pairs->values[0], second.first)) return {};
  MUROSIMF_ASSERT(second.unsettled > 0 && second.steps > 0);
  const double needed = 1 + second.sweeps / second.unsettled;
  const Entity& first = *world.entities()[static_cast<std::size_t>(second.first)];
  return fmt::format(
      "contacts of {} and {} more did not settle in {} of {} steps of a second: they carry too much, or stand too "
      "high, for steps of {:g} ms; rate = {:.0f} Hz would settle them",
      first.name(), second.members - 1, second.unsettled, second.steps, 1000.0 / second.steps,
      grain * std::ceil(needed * second.steps / grain));
}

}  // namespace murosimf::scene
