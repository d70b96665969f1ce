#include "murosimf/locomotion/leg_chain.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"

namespace murosimf::locomotion {
namespace {

LegHinge hinge(const Model& model, const Link& link) {
  MUROSIMF_ASSERT(link.object >= 0);
  if (link.kind != LinkKind::revolute) {
    throw SetupError(fmt::format("model '{}' has no leg that can be walked with: '{}' is not a hinge", model.name(),
                                 model.objects()[link.object].name));
  }
  LegHinge result{.object = link.object, .offset = link.offset, .turn = link.turn, .axis = link.axis};
  if (const Vec3d* range = model.find(properties::joint_range, link.object)) {
    result.lowest = range->x;
    result.highest = range->y;
  }
  MUROSIMF_ASSERT(std::abs(norm(result.axis) - 1) < 1e-6);
  return result;
}

/// From the base, which is excluded, to `link`.
std::vector<int> links_to(const Model& model, int link) {
  std::vector<int> links;
  for (int l = link; l > 0; l = model.tree().links[l].parent) {
    MUROSIMF_ASSERT(model.tree().links[l].parent < l);
    links.push_back(l);
  }
  std::ranges::reverse(links);
  return links;
}

/// Removes the first `count` hinges: the next one moves to where they put it at rest.
void hold(LegChain& chain, std::size_t count) {
  if (count == 0 || count >= chain.hinges.size()) return;
  Vec3d r;
  Mat3d R;
  for (std::size_t i = 0; i < count; ++i) {
    const LegHinge& held = chain.hinges[i];
    r += R * held.offset;
    R = R * held.turn * rotation(held.axis, std::clamp(0.0, held.lowest, held.highest));
  }
  chain.hinges.erase(chain.hinges.begin(), chain.hinges.begin() + static_cast<std::ptrdiff_t>(count));
  LegHinge& first = chain.hinges.front();
  first.offset = r + R * first.offset;
  first.turn = R * first.turn;
}

}  // namespace

LegChain read_chain(const Model& model, int sole, std::size_t shared) {
  LegChain chain;
  const FixedObject place = model.placement(sole);
  for (const int l : links_to(model, place.link)) chain.hinges.push_back(hinge(model, model.tree().links[l]));
  hold(chain, shared);
  if (chain.hinges.size() > most_hinges) {
    throw SetupError(
        fmt::format("model '{}' has no leg that can be walked with: {} joints between the base and its "
                    "sole, more than {}",
                    model.name(), chain.hinges.size(), most_hinges));
  }
  chain.tip = place.offset;
  // An object that is not turned against its link leaves `turn` unset: the identity stands for it.
  chain.sole = place.turned ? place.turn : Mat3d{};
  return chain;
}

std::size_t shared_hinges(const Model& model, int sole, int other_sole) {
  const std::vector<int> a = links_to(model, model.placement(sole).link);
  const std::vector<int> b = links_to(model, model.placement(other_sole).link);
  return static_cast<std::size_t>(std::ranges::mismatch(a, b).in1 - a.begin());
}

ChainPose pose_of(const LegChain& chain, std::span<const double> q) noexcept {
  MUROSIMF_ASSERT(q.size() == chain.hinges.size() && q.size() <= most_hinges);
  ChainPose pose;
  Vec3d r;
  Mat3d R;
  for (std::size_t i = 0; i < chain.hinges.size(); ++i) {
    const LegHinge& hinge = chain.hinges[i];
    r += R * hinge.offset;
    R = R * hinge.turn;
    pose.place[i] = r;
    pose.axis[i] = R * hinge.axis;
    R = R * rotation(hinge.axis, q[i]);
  }
  pose.tip = r + R * chain.tip;
  pose.sole = R * chain.sole;
  return pose;
}

Vec3d center_of_axes(const ChainPose& pose, std::size_t first, std::size_t end, const Vec3d& reference) {
  constexpr double pull = 1e-6;  // of the reference, against axes that determine no point
  MUROSIMF_ASSERT(first <= end && end <= most_hinges);
  constexpr int rounds = 3;  // each makes what the pull displaces a million times smaller
  Vec3d center = reference;
  for (int round = 0; round < rounds; ++round) {
    SymMat3d squares = diagonal(pull);
    Vec3d sum;
    for (std::size_t i = first; i < end; ++i) {
      squares += inertia_of_point(pose.axis[i]);
      sum += tangential(pose.place[i] - center, pose.axis[i]);
    }
    center += inverse(squares) * sum;
  }
  return center;
}

}  // namespace murosimf::locomotion
