#include "murosimf/scene/interpenetration_warnings.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/collision/body_pairs.h"
#include "murosimf/math/assert.h"

namespace murosimf::scene {
namespace {

using collision::Interpenetration;

constexpr std::size_t most_lines = 5;

std::string line_of(const Interpenetration& one, const World& world) {
  const auto entity = [&](int number) -> const Entity& {
    MUROSIMF_ASSERT(number >= 0 && static_cast<std::size_t>(number) < world.entities().size());
    return *world.entities()[static_cast<std::size_t>(number)];
  };
  const Entity &a = entity(one.a), &b = entity(one.b);
  const std::string what = one.crossed ? "passed through each other"
                                       : fmt::format("were {:.1f} mm in each other, the thinner one is {:.1f} mm thick",
                                                     1e3 * one.depth, 1e3 * one.thickness);
  return fmt::format("{} and {}: '{}' and '{}' {} (at {:.3f} s): contact is too soft for such masses, speeds and steps",
                     a.name(), b.name(), a.model().objects()[one.object].name, b.model().objects()[one.object_b].name,
                     what, seconds(one.time));
}

std::vector<Interpenetration> all_of(const World& world) {
  std::vector<Interpenetration> all;
  if (const auto* pairs = world.common().find(collision::pair_contacts)) all = pairs->values[0].interpenetrations;
  for (const auto& entity : world.entities()) {
    const auto* ground = entity->find(collision::contacts);
    if (!ground || !ground->values[0].interpenetration) continue;
    const Interpenetration& one = *ground->values[0].interpenetration;
    const auto same = [&](const Interpenetration& other) { return collision::is_of(other, one.a, one.b); };
    if (std::ranges::none_of(all, same)) all.push_back(one);
  }
  // stable: equal times keep the order of pairs, which does not depend on threads
  std::ranges::stable_sort(all, {}, &Interpenetration::time);
  return all;
}

}  // namespace

/// A few lines: in a heap, all bodies may be concerned.
std::vector<std::string> interpenetration_warnings(const World& world) {
  const std::vector<Interpenetration> all = all_of(world);
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < std::min(most_lines, all.size()); ++i) lines.push_back(line_of(all[i], world));
  if (all.size() > most_lines) {
    lines.push_back(fmt::format("{} more pairs of entities went so deep into each other", all.size() - most_lines));
  }
  return lines;
}

}  // namespace murosimf::scene
