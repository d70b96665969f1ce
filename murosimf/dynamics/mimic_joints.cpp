#include "murosimf/dynamics/mimic_joints.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/dynamics/rate_limit.h"
#include "murosimf/dynamics/servo/servo_law.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"

namespace murosimf::dynamics {
namespace {

using multibody::is_tendon;

constexpr double infinity = std::numeric_limits<double>::infinity();

[[noreturn]] void refuse(const Model& model, int follower, const std::string& why) {
  throw SetupError(
      fmt::format("model '{}', coupled joint '{}': {}", model.name(), model.objects()[follower].name, why));
}

[[noreturn]] void refuse_tendon(const Model& model, int follower, const std::string& why) {
  throw SetupError(fmt::format("model '{}', tendon '{}': {}", model.name(), model.objects()[follower].name, why));
}

/// The leader of a coupling; rejects couplings without a sensible leader and numbers.
int leader_of(const Model& model, int follower, const JointCoupling& coupling) {
  const int leader = with_context(fmt::format("coupled joint '{}'", model.objects()[follower].name),
                                  [&] { return model.object_index(coupling.leader); });
  if (!model.objects()[leader].is_joint()) refuse(model, follower, fmt::format("'{}' is no joint", coupling.leader));
  if (!std::isfinite(coupling.offset) || !std::isfinite(coupling.ratio) || coupling.ratio == 0) {
    refuse(model, follower,
           fmt::format("ratio {} and offset {} must be finite, the ratio not zero", coupling.ratio, coupling.offset));
  }
  return leader;
}

void refuse_wheels(const Model& model, const MimicJoints::Pair& pair) {
  for (const int joint : {pair.follower, pair.leader}) {
    const Servo* servo = model.find(properties::servo, joint);
    if (!servo || !follows_rate(*servo)) continue;
    refuse(model, pair.follower,
           fmt::format("the servo of '{}' follows a rate; coupled joints need a servo with a position gain, or none",
                       model.objects()[joint].name));
  }
}

}  // namespace

MimicJoints::MimicJoints(const Model& model)
    : ranges_(static_cast<std::size_t>(model.size()), {-infinity, infinity}), rate_limits_(ranges_.size(), infinity) {
  for (const int i : model.having(properties::joint_rate_limit)) rate_limits_[i] = joint_rate_limit(model, i);
  for (const int i : model.having(properties::joint_range)) {
    const Vec3d& range = *model.find(properties::joint_range, i);
    ranges_[i] = {range.x, range.y};
  }
  for (const int i : model.having(properties::joint_coupling)) pairs_.push_back(pair(model, i));
  narrow(model);
  for (const int i : model.having(properties::joint_tendon)) tendons_.push_back(tendon(model, i));
  for (const int i : model.having(properties::spatial_tendon)) tendons_.push_back(spatial_tendon(model, i));
  for (const int i : model.having(properties::tendon_tie)) ties_.push_back(tie(model, i));
}

double MimicJoints::Tendon::length(std::span<const double> q) const noexcept {
  if (path) return path->look(q, slopes);
  double length = 0;
  for (std::size_t i = 0; i < joints.size(); ++i) length += slopes[i] * q[joints[i]];
  return length;
}

double MimicJoints::Tendon::rate(std::span<const double> qd) const noexcept {
  double rate = 0;
  for (std::size_t i = 0; i < joints.size(); ++i) rate += slopes[i] * qd[joints[i]];
  return rate;
}

MimicJoints::Tendon MimicJoints::tendon(const Model& model, int follower) const {
  const auto refuse = [&](const std::string& why) { refuse_tendon(model, follower, why); };
  if (!model.objects()[follower].is_joint()) refuse("it is no joint");
  Tendon tendon{follower, {}};
  for (const auto& [name, coefficient] : model.find(properties::joint_tendon, follower)->parts) {
    const int joint = with_context(fmt::format("tendon '{}'", model.objects()[follower].name),
                                   [&, &other = name] { return model.object_index(other); });
    if (!model.objects()[joint].is_joint()) refuse(fmt::format("'{}' is no joint", name));
    if (is_tendon(model, joint)) refuse(fmt::format("'{}' is a tendon itself", name));
    if (!std::isfinite(coefficient) || coefficient == 0) {
      refuse(fmt::format("the coefficient {} of '{}' must be finite and not zero", coefficient, name));
    }
    tendon.joints.push_back(joint);
    tendon.slopes.push_back(coefficient);
  }
  if (tendon.joints.empty()) refuse("it runs over no joint");
  return tendon;
}

MimicJoints::Tendon MimicJoints::spatial_tendon(const Model& model, int follower) const {
  if (!model.objects()[follower].is_joint()) refuse_tendon(model, follower, "it is no joint");
  if (model.find(properties::joint_tendon, follower)) refuse_tendon(model, follower, "it has joints and points");
  const std::string context = fmt::format("model '{}', tendon '{}'", model.name(), model.objects()[follower].name);
  Tendon tendon{follower, {}};
  tendon.path = with_context(context, [&] {
    return multibody::TendonPath(model, *model.find(properties::spatial_tendon, follower));
  });
  const auto joints = tendon.path->joints();
  tendon.joints.assign(joints.begin(), joints.end());
  tendon.slopes.resize(joints.size());
  if (joints.empty()) refuse_tendon(model, follower, "no joint is between its points");
  return tendon;
}

MimicJoints::Tie MimicJoints::tie(const Model& model, int follower) const {
  Tie tie{follower, -1, *model.find(properties::tendon_tie, follower)};
  if (!is_tendon(model, follower)) refuse_tendon(model, follower, "only tendons are tied");
  if (!tie.by.other.empty()) {
    tie.leader = with_context(fmt::format("tendon '{}'", model.objects()[follower].name),
                              [&] { return model.object_index(tie.by.other); });
    if (!is_tendon(model, tie.leader) || tie.leader == follower) {
      refuse_tendon(model, follower, fmt::format("it is tied to '{}', which is no other tendon", tie.by.other));
    }
  }
  if (!std::isfinite(tie.by.start + tie.by.other_start) ||
      !std::ranges::all_of(tie.by.polynomial, [](double number) { return std::isfinite(number); })) {
    refuse_tendon(model, follower, "numbers of its tie must be finite");
  }
  return tie;
}

MimicJoints::Pair MimicJoints::pair(const Model& model, int follower) const {
  if (!model.objects()[follower].is_joint()) refuse(model, follower, "it is no joint");
  Pair pair{follower, follower, 1, 0};
  for (int i = 0; const JointCoupling* next = model.find(properties::joint_coupling, pair.leader); ++i) {
    // more couplings than objects: a circle
    if (i == model.size()) refuse(model, follower, "it follows itself");
    const int leader = leader_of(model, pair.leader, *next);
    pair = {follower, leader, pair.ratio * next->ratio, pair.offset + pair.ratio * next->offset};
  }
  refuse_wheels(model, pair);
  return pair;
}

void MimicJoints::narrow(const Model& model) {
  for (const Pair& pair : pairs_) {
    MUROSIMF_ASSERT(pair.ratio != 0 && pair.leader != pair.follower);
    // a leader's range is the intersection of those of its followers, seen through their couplings
    auto [low, high] = range(pair.follower);
    low = (low - pair.offset) / pair.ratio;
    high = (high - pair.offset) / pair.ratio;
    if (low > high) std::swap(low, high);  // a negative ratio turns the range around
    double& rate = rate_limits_[pair.leader];
    rate = std::min(rate, rate_limit(pair.follower) / std::abs(pair.ratio));
    Range& leader = ranges_[pair.leader];
    leader = {std::max(leader.lowest, low), std::min(leader.highest, high)};
    if (leader.lowest <= leader.highest) continue;
    refuse(model, pair.follower,
           fmt::format("its range and that of '{}' have no position in common", model.objects()[pair.leader].name));
  }
}

multibody::LoopJoints joints_of_loops(const Model& model) {
  const auto loops = multibody::loops_of(model);
  const auto commanded = model.having(properties::loop_commanded);
  for (const int joint : commanded) {
    if (multibody::is_in_loop(model, loops, joint)) continue;
    throw SetupError(fmt::format("model '{}': joint '{}' is commanded for its linkage, but in no loop", model.name(),
                                 model.objects()[joint].name));
  }
  const auto is_led = [&](int joint) {
    return std::ranges::any_of(loops, [&](const multibody::Loop& loop) {
      return is_in(model, loop, joint) &&
             std::ranges::any_of(commanded, [&](int other) { return is_in(model, loop, other); });
    });
  };
  std::vector<bool> follows(static_cast<std::size_t>(model.size()));
  std::vector<double> start(follows.size());
  for (const int joint : model.joints()) {
    // a servo drives its joint unless the linkage is commanded elsewhere
    const bool driven = model.find(properties::servo, joint) && !is_led(joint);
    const bool leads = driven || std::ranges::count(commanded, joint) > 0;
    follows[joint] = !leads && !model.find(properties::joint_coupling, joint);
    if (const double* at = model.find(properties::joint_start, joint)) start[joint] = *at;
  }
  return {model, follows, std::move(start)};
}

void MimicJoints::follow(std::span<double> q, std::span<double> qd) const noexcept {
  MUROSIMF_ASSERT(pairs_.empty() || (q.size() == ranges_.size() && qd.size() == ranges_.size()));
  for (const Pair& pair : pairs_) {
    q[pair.follower] = pair.offset + pair.ratio * q[pair.leader];
    qd[pair.follower] = pair.ratio * qd[pair.leader];
  }
  for (const Tendon& tendon : tendons_) {
    q[tendon.follower] = tendon.length(q);
    qd[tendon.follower] = tendon.rate(qd);
  }
}

}  // namespace murosimf::dynamics
