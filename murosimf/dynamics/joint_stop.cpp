#include "murosimf/dynamics/joint_stop.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "murosimf/collision/colliding_shapes.h"
#include "murosimf/dynamics/servo/torque_watch.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"

namespace murosimf::dynamics {
namespace {

constexpr double bend = 0.25 * pi / 180;  // [rad] under T; the header explains these numbers
constexpr double shift = 0.5e-3;          // [m] under T
constexpr double frequency = 800;         // [rad/s] lower bound of sqrt(k / J)
constexpr double damping_time = 5e-3;     // [s] damper over spring

// For explicit steps, of joints without servo: softer, since explicit steps of 1 ms must resolve it.
constexpr double free_damping_time = 10e-3;  // [s]
constexpr double free_frequency = 200;       // [rad/s]

/// Inertia [kg m^2 | kg] that a joint moves against its parent while all joints are at zero.
double carried_inertia(const Model& model, int joint) {
  MUROSIMF_ASSERT(model.objects()[joint].is_joint());
  const Tree& tree = model.tree();
  const int first = tree.link_of[joint];
  const Vec3d axis = tree.links[first].axis;
  std::vector<std::optional<Transformd>> poses(tree.links.size());  // in the joint's frame, of the links that it moves
  poses[first].emplace();
  double sum = rotor_inertia(model, joint);
  for (std::size_t l = first; l < tree.links.size(); ++l) {
    const Link& link = tree.links[l];
    if (link.parent >= 0 && poses[link.parent]) poses[l] = *poses[link.parent] * Transformd{link.offset, link.turn};
    if (!poses[l]) continue;
    const auto& [place, R] = *poses[l];
    const Vec3d lever = cross(axis, place + R * link.com);
    const bool slides = tree.links[first].kind == LinkKind::prismatic;
    sum += slides ? link.mass : link.mass * dot(lever, lever) + dot(axis, rotated(R, link.inertia) * axis);
  }
  return sum;
}

/// Motion of a link when all joints are at zero: its pose and velocities in the frame of the base.
struct Moving {
  Transformd pose;
  Vec3d w, v;  // [rad/s], [m/s] of its origin
};

/// `rate` [rad/s | m/s] of the link's own joint.
Moving moved_by(const Link& link, const Moving& parent, double rate) {
  Moving moving{parent.pose * Transformd{link.offset, link.turn}, parent.w, parent.v};
  moving.v += cross(parent.w, moving.pose.position - parent.pose.position);
  const Vec3d axis = rate * (moving.pose.orientation * link.axis);
  (link.kind == LinkKind::prismatic ? moving.v : moving.w) += axis;
  return moving;
}

/// The same of a joint that others follow: twice the kinetic energy at a rate of 1.
double inertia_with_followers(const Model& model, int leader, std::span<const MimicJoints::Pair> coupled) {
  const Tree& tree = model.tree();
  MUROSIMF_ASSERT(model.objects()[leader].is_joint());
  std::vector<double> rates(tree.links.size());
  rates[tree.link_of[leader]] = 1;
  double sum = rotor_inertia(model, leader);
  for (const MimicJoints::Pair& pair : coupled) {
    if (pair.leader != leader) continue;
    rates[tree.link_of[pair.follower]] = pair.ratio;
    sum += pair.ratio * pair.ratio * rotor_inertia(model, pair.follower);
  }
  std::vector<Moving> all(tree.links.size());
  for (std::size_t l = 0; l < tree.links.size(); ++l) {
    const Link& link = tree.links[l];
    if (link.parent >= 0) all[l] = moved_by(link, all[link.parent], rates[l]);
    const auto& [pose, w, v] = all[l];
    const Vec3d center = v + cross(w, pose.orientation * link.com);
    sum += link.mass * dot(center, center) + dot(w, rotated(pose.orientation, link.inertia) * w);
  }
  return sum;
}

double moved_inertia(const Model& model, int joint, std::span<const MimicJoints::Pair> coupled) {
  const bool leads = std::ranges::any_of(coupled, [&](const auto& pair) { return pair.leader == joint; });
  return leads ? inertia_with_followers(model, joint, coupled) : carried_inertia(model, joint);
}

}  // namespace

JointStop joint_stop(const Model& model, int joint, double lowest, double highest,
                     std::span<const MimicJoints::Pair> coupled) {
  MUROSIMF_ASSERT(!(lowest > highest));
  if (std::isinf(lowest) && std::isinf(highest)) return {};
  const double weight = model.tree().mass * 9.81;
  const Servo* servo = model.find(properties::servo, joint);
  const double stall = servo ? servo->stall_torque : 0;
  const bool slider = model.objects()[joint].kind == Kind::prismatic;
  const double k = slider ? std::max(stall, weight) / shift : std::max(stall, 0.1 * weight) / bend;
  const double inertia = moved_inertia(model, joint, coupled);
  MUROSIMF_ASSERT(inertia >= 0);
  // stiff enough for the static load and for the kinetic energy of an arriving limb
  const double firm = std::max(k, inertia * frequency * frequency);
  JointStop stop{lowest, highest, {firm, firm * damping_time}, {k, k * damping_time}};
  // a servo damps the joint itself, so the explicit spring can be the softer one
  if (servo) return stop;
  const double soft = std::max(k, inertia * free_frequency * free_frequency);
  stop.explicitly = {soft, soft * free_damping_time};
  return stop;
}

}  // namespace murosimf::dynamics
