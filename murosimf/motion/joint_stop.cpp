#include "murosimf/motion/joint_stop.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "murosimf/collision/colliding_shapes.h"
#include "murosimf/model/properties.h"
#include "murosimf/motion/torque_watch.h"

namespace murosimf::motion {
namespace {

constexpr double bend = 0.25 * pi / 180;  // [rad]
constexpr double shift = 0.5e-3;          // [m]
constexpr double frequency = 800;         // [rad/s]
constexpr double damping_time = 5e-3;     // [s] damper over spring

// Explicitly, without servo.
constexpr double free_damping_time = 10e-3;  // [s]
constexpr double free_frequency = 200;       // [rad/s]

/// Inertia [kg m^2 | kg] that a joint moves against its parent while all joints are at zero.
double carried_inertia(const Model& model, int joint) {
  const Tree& tree = model.tree();
  const int first = tree.link_of[joint];
  const Vec3d axis = tree.links[first].axis;
  std::vector<std::optional<Transformd>> poses(tree.links.size());  // in the joint's frame, of what it moves
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

}  // namespace

JointStop joint_stop(const Model& model, int joint, double lowest, double highest) {
  if (std::isinf(lowest) && std::isinf(highest)) return {};
  const double weight = model.tree().mass * 9.81;
  const Servo* servo = model.find(properties::servo, joint);
  const double stall = servo ? servo->stall_torque : 0;
  const bool slider = model.objects()[joint].kind == Kind::prismatic;
  const double k = slider ? std::max(stall, weight) / shift : std::max(stall, 0.1 * weight) / bend;
  const double inertia = carried_inertia(model, joint);
  const double firm = std::max(k, inertia * frequency * frequency);
  JointStop stop{lowest, highest, {firm, firm * damping_time}, {k, k * damping_time}};
  if (servo) return stop;
  const double soft = std::max(k, inertia * free_frequency * free_frequency);
  stop.explicitly = {soft, soft * free_damping_time};
  return stop;
}

}  // namespace murosimf::motion
