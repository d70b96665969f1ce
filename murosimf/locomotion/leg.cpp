#include "murosimf/locomotion/leg.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/locomotion/leg_ik.h"
#include "murosimf/locomotion/leg_shape.h"
#include "murosimf/locomotion/leg_solver.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"

namespace murosimf::locomotion {
namespace {

constexpr double tolerance = 1e-6;        // [m], [1]
constexpr double least_bend = 0.06;       // [rad] of a knee: 99.95 % of the leg's length, as in leg_ik.cpp
constexpr double home_bend = 0.6;         // [rad]
constexpr double home_length = 0.92;      // [1] hip to ankle at home, of thigh and shin
constexpr double weight_of_turns = 0.25;  // [1] a radian of the sole counts as much as this part of the leg's length
constexpr std::size_t turning_feet = 5;   // hinges from which on the sole can be held level

[[noreturn]] void refuse(const Model& model, const std::string& why) {
  throw SetupError(fmt::format("model '{}' has no leg that can be walked with: {}", model.name(), why));
}

bool vanishes(const Vec3d& v) { return norm(v) < tolerance; }
bool points_down(const Vec3d& v) { return std::hypot(v.x, v.y) < tolerance && v.z < 0; }

/// Sets the signs of the axes if the leg has the geometry of leg_ik.h. Numbers that this geometry gives exactly replace those of its shape.
void take_closed_form(Leg& leg, const FixedObject& sole) {
  constexpr std::array<Vec3d, 6> axes{{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}, {0, 1, 0}, {1, 0, 0}}};
  const auto& hinges = leg.chain.hinges;
  if (hinges.size() != axes.size() || sole.turned) return;
  std::array<double, 6> signs{};
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const double along = dot(hinges[i].axis, axes[i]);
    const Mat3d& T = hinges[i].turn;
    if (std::abs(std::abs(along) - 1) > tolerance || !vanishes(T.x - Vec3d{1, 0, 0}) ||
        !vanishes(T.y - Vec3d{0, 1, 0})) {
      return;
    }
    signs[i] = along > 0 ? 1 : -1;
  }
  const bool meet = vanishes(hinges[1].offset) && vanishes(hinges[2].offset) && vanishes(hinges[5].offset);
  if (!meet || !points_down(hinges[3].offset) || !points_down(hinges[4].offset)) return;
  leg.hip = hinges[0].offset;
  leg.thigh = -hinges[3].offset.z;
  leg.shin = -hinges[4].offset.z;
  leg.ankle_height = -sole.offset.z;
  leg.signs = signs;
}

/// Limits the knee so that it neither straightens nor bends the other way: there the iteration could change to another solution.
void keep_bent(LegHinge& knee, const LegShape& shape) {
  MUROSIMF_ASSERT(std::abs(shape.bend) == 1);
  const double limit = shape.straight + shape.bend * least_bend;
  if (shape.bend > 0) {
    knee.lowest = std::min(std::max(knee.lowest, limit), knee.highest);
  } else {
    knee.highest = std::max(std::min(knee.highest, limit), knee.lowest);
  }
  MUROSIMF_ASSERT(knee.lowest <= knee.highest);
}

void find_home(Leg& leg, const LegShape& shape) {
  MUROSIMF_ASSERT(shape.knee < leg.joints.size());
  leg.home.assign(leg.joints.size(), 0.0);
  leg.home[shape.knee] = shape.straight + shape.bend * home_bend;
  const Vec3d below{0, leg.ankle.y - leg.hip.y, -home_length * (leg.thigh + leg.shin)};
  bend(leg, {.ankle = below}, leg.home);
}

bool bend_in_closed_form(const Leg& leg, const FootTarget& target, std::span<double> q) {
  MUROSIMF_ASSERT(q.size() == leg.signs->size());
  const LegAngles angles = leg_angles(leg.thigh, leg.shin, target.ankle, target.sole);
  for (std::size_t i = 0; i < q.size(); ++i) q[i] = (*leg.signs)[i] * angles.q[i];
  if (target.roll != 0) q[1] = (*leg.signs)[1] * (angles.q[1] + target.roll);
  return angles.reachable;
}

/// Solves from the present angles, and from home if that does not reach the target.
bool bend_numerically(const Leg& leg, const FootTarget& target, std::span<double> q) {
  MUROSIMF_ASSERT(leg.home.size() == q.size() && q.size() <= most_hinges);
  const Mat3d R = rotation_x(target.roll);
  const TipTarget tip{leg.hip + R * target.ankle, R * target.sole};
  const SolverOptions options{.weight = leg.weight};
  const SolverResult near = solve_leg(leg.chain, tip, options, q);
  if (near.reached) return true;
  std::array<double, most_hinges> other{};
  const auto q_other = std::span(other).first(q.size());
  std::copy(leg.home.begin(), leg.home.end(), q_other.begin());
  const SolverResult far = solve_leg(leg.chain, tip, options, q_other);
  const auto cost = [&](const SolverResult& r) { return std::hypot(r.distance, leg.weight * r.angle); };
  // Only if home is clearly better: two solutions of about the same cost must not alternate from cycle to cycle.
  if (cost(far) < 0.5 * cost(near)) std::copy(q_other.begin(), q_other.end(), q.begin());
  return far.reached;
}

}  // namespace

Leg find_leg(const Model& model, int sole, std::size_t shared) {
  Leg leg;
  leg.chain = read_chain(model, sole, shared);
  std::string problem;
  const LegShape shape = shape_of(leg.chain, problem);
  if (!problem.empty()) refuse(model, fmt::format("{} ('{}')", problem, model.objects()[sole].name));
  for (const LegHinge& hinge : leg.chain.hinges) leg.joints.push_back(hinge.object);
  const std::vector<double> zero(leg.joints.size());
  const ChainPose pose = pose_of(leg.chain, zero);
  const Vec3d ankle_in_sole = transposed_times(pose.sole, shape.ankle - pose.tip);
  leg.chain.tip += leg.chain.sole * ankle_in_sole;
  leg.knee = shape.knee;
  leg.hip = shape.hip;
  leg.ankle = shape.ankle;
  leg.thigh = shape.thigh;
  leg.shin = shape.shin;
  leg.ankle_height = ankle_in_sole.z;
  if (leg.joints.size() >= turning_feet) leg.weight = weight_of_turns * (leg.thigh + leg.shin);
  keep_bent(leg.chain.hinges[shape.knee], shape);
  take_closed_form(leg, model.placement(sole));
  MUROSIMF_ASSERT(leg.thigh > 0 && leg.shin > 0 && leg.knee < leg.joints.size());
  find_home(leg, shape);
  return leg;
}

std::array<Leg, 2> find_legs(const Model& model) {
  const auto soles = model.having(properties::sole);
  if (soles.size() != 2) refuse(model, fmt::format("it has {} soles, not 2", soles.size()));
  const std::size_t shared = shared_hinges(model, soles[0], soles[1]);
  std::array<Leg, 2> legs{find_leg(model, soles[0], shared), find_leg(model, soles[1], shared)};
  for (const Leg& leg : legs) {
    if (leg.joints.size() < turning_feet) {
      refuse(model,
             fmt::format("{} joints between the base and its sole, less than {}", leg.joints.size(), turning_feet));
    }
  }
  MUROSIMF_ASSERT(legs[0].home.size() == legs[0].joints.size() && legs[1].home.size() == legs[1].joints.size());
  if (legs[0].hip.y < legs[1].hip.y) std::swap(legs[0], legs[1]);
  return legs;
}

const std::array<Leg, 2>& legs_of(const Model& model) {
  return *model.derived().get<std::array<Leg, 2>>("legs", [&] { return find_legs(model); });
}

std::array<Leg, 4> find_four_legs(const Model& model) {
  const auto soles = model.having(properties::sole);
  if (soles.size() != 4) refuse(model, fmt::format("it has {} soles, not 4", soles.size()));
  std::array<Leg, 4> legs;
  for (std::size_t i = 0; i < 4; ++i) legs[i] = find_leg(model, soles[i]);
  std::ranges::sort(legs, [](const Leg& a, const Leg& b) { return a.ankle.x > b.ankle.x; });
  if (legs[0].ankle.y < legs[1].ankle.y) std::swap(legs[0], legs[1]);
  if (legs[2].ankle.y < legs[3].ankle.y) std::swap(legs[2], legs[3]);
  return legs;
}

bool bend(const Leg& leg, const FootTarget& target, std::span<double> q) noexcept {
  MUROSIMF_ASSERT(q.size() == leg.joints.size());
  return leg.signs ? bend_in_closed_form(leg, target, q) : bend_numerically(leg, target, q);
}

}  // namespace murosimf::locomotion
