#include "murosimf/robot_formats/joint_inertia.h"

#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Dense>

#include "murosimf/math/assert.h"

namespace murosimf::robot_formats {
namespace {

/// Motion of the bodies behind a degree of freedom: rate [rad/s] of turning and velocity [m/s] of the point at the world's origin.
struct Motion {
  Vec3d turn, shift;
};

/// Motions of the base, if it is free, then of all joints, in the frame of the base.
struct Motions {
  explicit Motions(const RobotDescription& description) : behind(description.bodies.size()) {
    // The base's six degrees of freedom come first: `base` separates them from the joints.
    if (!description.fixed_base) {
      for (const Vec3d& axis : {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}}) {
        all.push_back({axis, {}});
        all.push_back({{}, axis});
      }
    }
    base = all.size();
    armature.resize(base);
    for (std::size_t i = 0; i < base; ++i) behind[0].push_back(i);
    for (std::size_t b = 0; b < description.bodies.size(); ++b) add(description.bodies[b], b);
    MUROSIMF_ASSERT(all.size() == armature.size() && places.size() == description.bodies.size());
  }

  void add(const BodyDescription& body, std::size_t b) {
    MUROSIMF_ASSERT(body.parent < static_cast<int>(b));
    places.push_back(body.parent < 0 ? Transformd{} : places[body.parent] * body.place);
    if (body.parent >= 0) behind[b] = behind[body.parent];
    for (const JointDescription& joint : body.joints) {
      const Vec3d axis = places[b].orientation * ((1.0 / norm(joint.axis)) * joint.axis);
      const Vec3d anchor = places[b].position + places[b].orientation * joint.anchor;
      behind[b].push_back(all.size());
      // As a twist at the common origin, so that motions of different bodies add up.
      all.push_back(joint.kind == Kind::prismatic ? Motion{{}, axis} : Motion{axis, -cross(axis, anchor)});
      armature.push_back(joint.armature);
    }
  }

  std::vector<Transformd> places;  // of bodies
  std::vector<Motion> all;
  std::vector<double> armature;                  // [kg m^2 | kg] of each motion
  std::vector<std::vector<std::size_t>> behind;  // by body: the motions that move it
  std::size_t base = 0;                          // number of the base's motions
};

/// M = sum over bodies of J^T I J.
Eigen::MatrixXd inertia_matrix(const RobotDescription& description, const Motions& motions) {
  const auto size = static_cast<Eigen::Index>(motions.all.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
  for (std::size_t i = 0; i < motions.all.size(); ++i)
    matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i)) = motions.armature[i];
  for (std::size_t b = 0; b < description.bodies.size(); ++b) {
    const MassProperties solid =
        // Moved to the frame of the base, in which the twists are given.
        moved(description.bodies[b].solid, motions.places[b].position, motions.places[b].orientation);
    for (const std::size_t i : motions.behind[b]) {
      const Motion& one = motions.all[i];
      const Vec3d momentum = solid.mass * (one.shift + cross(one.turn, solid.center)), spin = solid.inertia * one.turn;
      for (const std::size_t j : motions.behind[b]) {
        const Motion& other = motions.all[j];
        matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) +=
            dot(other.shift + cross(other.turn, solid.center), momentum) + dot(other.turn, spin);
      }
    }
  }
  return matrix;
}

}  // namespace

std::vector<double> free_inertias(const RobotDescription& description) {
  const Motions motions(description);
  const Eigen::LLT<Eigen::MatrixXd> factor(inertia_matrix(description, motions));
  // A joint that moves no mass makes the matrix singular: the caller gets no inertias instead of infinite ones.
  if (factor.info() != Eigen::Success) return {};
  const auto size = static_cast<Eigen::Index>(motions.all.size());
  const Eigen::MatrixXd inverse = factor.solve(Eigen::MatrixXd::Identity(size, size));
  std::vector<double> inertias;
  for (auto i = static_cast<Eigen::Index>(motions.base); i < size; ++i) inertias.push_back(1 / inverse(i, i));
  return inertias;
}

double reference_of(const RobotDescription& description, const std::string& name) {
  for (const BodyDescription& body : description.bodies) {
    for (const JointDescription& joint : body.joints) {
      if (joint.name == name) return joint.reference;
    }
  }
  return 0;
}

double reflected_inertia(const RobotDescription& description, std::size_t body, const JointDescription& joint) {
  MUROSIMF_ASSERT(body < description.bodies.size() && norm(joint.axis) > 0);
  const Vec3d axis = (1.0 / norm(joint.axis)) * joint.axis;
  std::vector<std::optional<Transformd>> places(
      description.bodies.size());  // in the frame of `body`; none: not behind it
  places[body] = Transformd{};
  double inertia = joint.armature;
  for (std::size_t b = body; b < description.bodies.size(); ++b) {
    // One pass suffices: parents precede their children.
    const BodyDescription& moved_body = description.bodies[b];
    if (b != body && moved_body.parent >= 0 && places[moved_body.parent]) {
      places[b] = *places[moved_body.parent] * moved_body.place;
    }
    if (!places[b]) continue;
    const MassProperties solid = moved(moved_body.solid, places[b]->position, places[b]->orientation);
    MUROSIMF_ASSERT(moved_body.parent < static_cast<int>(b));
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

}  // namespace murosimf::robot_formats
