#include "murosimf/dynamics/coupling_rods.h"

#include <algorithm>
#include <cmath>

#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"

namespace murosimf::dynamics {
namespace {

constexpr double trace_share = 1e-6;   // [1] of the leader's inertia: enough for the factors, too little to be seen
constexpr double tendon_share = 1e-3;  // [1] of the inertia along a tendon

double stall_torque(const Model& model, int joint) {
  const Servo* servo = model.find(properties::servo, joint);
  return servo ? servo->stall_torque : 0;
}

double stiffness(const Model& model, const MimicJoints::Pair& pair) {
  MUROSIMF_ASSERT(pair.ratio != 0);
  const double weight = model.tree().mass * 9.81;
  const bool slider = model.objects()[pair.follower].kind == Kind::prismatic;
  const double servos =
      std::max(stall_torque(model, pair.follower), stall_torque(model, pair.leader) / std::abs(pair.ratio));
  return slider ? std::max(servos, weight) / shift_under_load : std::max(servos, 0.1 * weight) / bend_under_load;
}

/// The slider of a tendon.
double stiffness(const Model& model, int tendon) {
  constexpr double stiffer = 1000;  // than what pulls along the tendon
  const double weight = model.tree().mass * 9.81;
  const double* spring = model.find(properties::joint_stiffness, tendon);
  const Servo* servo = model.find(properties::servo, tendon);
  const double pulls = (spring ? *spring : 0) + (servo ? servo->position_gain : 0);
  return std::max(std::max(stall_torque(model, tendon), weight) / shift_under_load, stiffer * pulls);
}

}  // namespace

double CouplingRod::place(std::span<const double> q) const noexcept {
  double place = offset;
  for (const Joint& leader : leaders) place += leader.share * q[leader.object];
  return place;
}

void CouplingRod::follow(std::span<const double> q) noexcept {
  if (tendon && tendon->path) {
    offset = tendon->length(q);
    for (std::size_t i = 0; i < leaders.size(); ++i) {
      leaders[i].share = tendon->slopes[i];
      offset -= leaders[i].share * q[leaders[i].object];
    }
  }
  if (tie && !leaders.empty()) {
    const double x = q[leaders[0].object];
    leaders[0].share = tie->slope(x);
    offset = tie->at(x) - leaders[0].share * x;
  }
}

double CouplingRod::mobility(std::span<const double> moved, double mass) const noexcept {
  double sum = 0;
  for (const Joint& leader : leaders) sum += leader.share * leader.share / moved[leader.link];
  return tendon && tendon->path ? std::max(sum, 1 / mass) : sum;
}

void CouplingRod::weigh(std::span<const double> moved, double mass) noexcept {
  if (!tendon || !tendon->path) return;
  taken_along = 1 / mobility(moved, mass);
  if (trace > 0) trace = lightest * taken_along;
}

std::vector<CouplingRod> coupling_rods(const Model& model, const MimicJoints& joints) {
  const auto joint = [&](int object, double share) {
    return CouplingRod::Joint{object, model.tree().link_of[object], share};
  };
  std::vector<CouplingRod> rods;
  for (const auto& pair : joints.pairs()) {
    rods.push_back(
        {joint(pair.follower, 1), {joint(pair.leader, pair.ratio)}, pair.offset, stiffness(model, pair), trace_share});
  }
  for (const auto& tendon : joints.tendons()) {
    CouplingRod& rod = rods.emplace_back(
        CouplingRod{joint(tendon.follower, 1), {}, 0, stiffness(model, tendon.follower), tendon_share});
    for (std::size_t i = 0; i < tendon.joints.size(); ++i) {
      rod.leaders.push_back(joint(tendon.joints[i], tendon.slopes[i]));
    }
    rod.tendon = &tendon;
  }
  for (const auto& tie : joints.ties()) {
    CouplingRod& rod =
        rods.emplace_back(CouplingRod{joint(tie.follower, 1), {}, tie.by.at(0), stiffness(model, tie.follower)});
    if (tie.leader >= 0) rod.leaders.push_back(joint(tie.leader, 0));
    rod.tie = &tie.by;
  }
  return rods;
}

}  // namespace murosimf::dynamics
