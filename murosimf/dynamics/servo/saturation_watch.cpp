#include "murosimf/dynamics/servo/saturation_watch.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/math/assert.h"

namespace murosimf::dynamics {
namespace {

constexpr double worth_a_word = 0.01;  // [1] of the time: less is not reported
constexpr std::size_t most_names = 4;

struct Share {
  int joint;
  double of_time;  // [1]
};

std::vector<Share> saturated_joints(const Entity& entity) {
  const auto* saturated = entity.find(properties::saturated_time);
  const auto* watched = entity.find(properties::watched_time);
  std::vector<Share> shares;
  if (!saturated || !watched || !(watched->values[0] > 0)) return shares;
  for (const int i : entity.model().joints()) {
    const double share = saturated->values[i] / watched->values[0];
    if (share >= worth_a_word) shares.push_back({i, share});
  }
  // the worst first; equal ones in the order of the model
  std::ranges::stable_sort(shares, std::greater{}, &Share::of_time);
  return shares;
}

}  // namespace

SaturationWatch::SaturationWatch(Setup& setup)
    : saturated_(setup.write(properties::saturated_time)), watched_(setup.write(properties::watched_time)[0]) {}

void SaturationWatch::initialize() noexcept {
  std::ranges::fill(saturated_, 0.0);
  watched_ = 0;
}

void SaturationWatch::look(const Tree& tree, std::span<const multibody::FrictionalJoint<double>> joints,
                           double dt) noexcept {
  begin(dt);
  MUROSIMF_ASSERT(joints.size() == tree.links.size());
  for (std::size_t l = 1; l < joints.size(); ++l) {
    if (!multibody::is_free(joints[l])) add(tree.links[l].object, dt);
  }
}

std::string saturation_message(const Entity& entity) {
  const std::vector<Share> shares = saturated_joints(entity);
  if (shares.empty()) return {};
  std::string line = entity.name() + ": servos give all they have: ";
  for (std::size_t k = 0; k < std::min(shares.size(), most_names); ++k) {
    line += fmt::format("{}{} {}{:.0f} %{}", k == 0 ? "" : ", ", entity.model().objects()[shares[k].joint].name,
                        k == 0 ? "in " : "", 100 * shares[k].of_time, k == 0 ? " of the time" : "");
  }
  if (shares.size() > most_names) line += fmt::format(" and {} more", shares.size() - most_names);
  return line;
}

}  // namespace murosimf::dynamics
