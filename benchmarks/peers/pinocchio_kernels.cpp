// Pinocchio's algorithms, compiled from its headers.
#include <pinocchio/multibody.hpp>

#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/kinematics.hpp>
#include <pinocchio/algorithm/rnea.hpp>

#include "benchmarks/peers/kernels.h"

namespace peers {

namespace {

namespace pin = pinocchio;

Eigen::Vector3d vector(const Vector& v) { return {v[0], v[1], v[2]}; }

/// A coordinate axis where it is one: these joints cost less.
pin::JointModel hinge(const Vector& axis) {
  if (axis == Vector{1, 0, 0}) return pin::JointModelRX();
  if (axis == Vector{0, 1, 0}) return pin::JointModelRY();
  if (axis == Vector{0, 0, 1}) return pin::JointModelRZ();
  return pin::JointModelRevoluteUnaligned(vector(axis));
}

class PinocchioKernels final : public Kernels {
 public:
  explicit PinocchioKernels(const Description& description) {
    std::vector<pin::JointIndex> joints;
    for (const Link& link : description.links) joints.push_back(add(link, joints));
    data_ = pin::Data(model_);
    const KernelState state(description.joints());
    q_ = Eigen::VectorXd::Zero(model_.nq);
    q_[6] = 1;  // x y z w
    v_ = Eigen::VectorXd::Constant(model_.nv, state.joint_velocity);
    v_.head<6>() << 0, 0, 0, state.angular_velocity[0], state.angular_velocity[1], state.angular_velocity[2];
    a_ = Eigen::VectorXd::Constant(model_.nv, state.joint_acceleration);
    a_.head<6>().setZero();
    torque_ = Eigen::VectorXd::Zero(model_.nv);
    for (std::size_t i = 0; i < state.q.size(); ++i) {
      const auto& joint = model_.joints[joints[i + 1]];
      q_[joint.idx_q()] = state.q[i];
      torque_[joint.idx_v()] = state.torque[i];
      rows_.push_back(joint.idx_v());
    }
  }

  void kinematics() override { pin::forwardKinematics(model_, data_, q_); }
  void inverse_dynamics() override { pin::rnea(model_, data_, q_, v_, a_); }
  void mass_matrix() override { pin::crba(model_, data_, q_, pin::Convention::WORLD); }
  void forward_dynamics() override { pin::aba(model_, data_, q_, v_, torque_, pin::Convention::WORLD); }

  std::vector<double> accelerations() override {
    forward_dynamics();
    const auto& a = data_.ddq;
    std::vector<double> result{a[3], a[4], a[5], a[0], a[1], a[2]};
    for (const int row : rows_) result.push_back(a[row]);
    return result;
  }
  std::vector<double> torques() override {
    inverse_dynamics();
    std::vector<double> result;
    // rotors are in Pinocchio's, not in ours
    for (const int row : rows_) result.push_back(data_.tau[row] - model_.armature[row] * a_[row]);
    return result;
  }

 private:
  pin::JointIndex add(const Link& link, const std::vector<pin::JointIndex>& joints) {
    const bool base = link.parent < 0;
    const Eigen::Quaterniond turn(link.rotation[0], link.rotation[1], link.rotation[2], link.rotation[3]);
    const pin::SE3 place(turn, base ? Eigen::Vector3d::Zero().eval() : vector(link.offset));
    const pin::JointIndex parent = base ? 0 : joints[static_cast<std::size_t>(link.parent)];
    const pin::JointIndex joint =
        model_.addJoint(parent, base ? pin::JointModel(pin::JointModelFreeFlyer()) : hinge(link.axis), place,
                        base ? "base" : link.joint);
    const auto& I = link.inertia;
    const Eigen::Matrix3d inertia =
        (Eigen::Matrix3d() << I[0], I[3], I[4], I[3], I[1], I[5], I[4], I[5], I[2]).finished();
    model_.appendBodyToJoint(joint, pin::Inertia(link.mass, vector(link.center), inertia), pin::SE3::Identity());
    if (!base) model_.armature[model_.joints[joint].idx_v()] = link.armature;
    return joint;
  }

  pin::Model model_;
  pin::Data data_;
  Eigen::VectorXd q_, v_, a_, torque_;
  std::vector<int> rows_;  // of velocities, by joint of the description
};

}  // namespace

__attribute__((visibility("default"))) std::unique_ptr<Kernels> pinocchio_kernels(const Description& description) {
  return std::make_unique<PinocchioKernels>(description);
}

}  // namespace peers
