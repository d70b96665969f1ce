#include "murosimf/description/joint_inertia.h"

#include <cmath>

namespace murosimf::description {

double reference_of(const RobotDescription& description, const std::string& name) {
  for (const BodyDescription& body : description.bodies) {
    for (const JointDescription& joint : body.joints) {
      if (joint.name == name) return joint.reference;
    }
  }
  return 0;
}

double reflected_inertia(const RobotDescription& description, std::size_t body, const JointDescription& joint) {
  const Vec3d axis = (1.0 / norm(joint.axis)) * joint.axis;
  std::vector<std::optional<Transformd>> places(
      description.bodies.size());  // in the frame of `body`; none: not behind it
  places[body] = Transformd{};
  double inertia = joint.armature;
  for (std::size_t b = body; b < description.bodies.size(); ++b) {
    const BodyDescription& moved_body = description.bodies[b];
    if (b != body && moved_body.parent >= 0 && places[moved_body.parent]) {
      places[b] = *places[moved_body.parent] * moved_body.place;
    }
    if (!places[b]) continue;
    const MassProperties solid = moved(moved_body.solid, places[b]->position, places[b]->orientation);
    const SymMat3d at_anchor = solid.inertia + solid.mass * inertia_of_point(solid.center - joint.anchor);
    inertia += joint.kind == Kind::prismatic ? solid.mass : dot(axis, at_anchor * axis);
  }
  return inertia;
}

void resolve_damping_ratios(RobotDescription& description) {
  for (std::size_t b = 0; b < description.bodies.size(); ++b) {
    for (JointDescription& joint : description.bodies[b].joints) {
      if (!joint.servo || !(joint.damping_ratio > 0)) continue;
      joint.servo->velocity_gain =
          2 * joint.damping_ratio * std::sqrt(joint.servo->position_gain * reflected_inertia(description, b, joint));
    }
  }
}

}  // namespace murosimf::description
