/// kernels.h - rigid-body algorithms on the robot of a description, as each library does them from joint positions on.
#pragma once

#include <memory>
#include <vector>

#include "benchmarks/peers/description.h"

namespace peers {

/// The same state for all: the base stands upright at the origin of the world and turns, joints are bent and turn.
struct KernelState {
  explicit KernelState(std::size_t joints) : q(joints), torque(joints, 0.1) {
    for (std::size_t i = 0; i < joints; ++i) q[i] = 0.1 * static_cast<double>(i % 7) - 0.3;
  }
  Vector angular_velocity{0.1, 0.2, 0.3};  ///< [rad/s] of the base; its origin rests
  double joint_velocity = 0.5;             ///< [rad/s] of all joints
  double joint_acceleration = 1;           ///< [rad/s^2] that inverse dynamics is asked for
  std::vector<double> q;                   ///< [rad] of links 1 and on
  std::vector<double> torque;              ///< [N m] likewise
};

class Kernels {
 public:
  virtual ~Kernels() = default;
  virtual void kinematics() = 0;        ///< poses of all links
  virtual void inverse_dynamics() = 0;  ///< recursive Newton-Euler
  virtual void mass_matrix() = 0;       ///< composite rigid bodies
  virtual void forward_dynamics() = 0;  ///< articulated bodies, with rotors
  /// Of the base [rad/s^2, m/s^2] and the joints [rad/s^2], as forward dynamics finds them under gravity, and the torques [N m] that
  /// inverse dynamics finds. The base's is that of its origin.
  [[nodiscard]] virtual std::vector<double> accelerations() = 0;
  [[nodiscard]] virtual std::vector<double> torques() = 0;
  [[nodiscard]] virtual int robots() const { return 1; }  ///< that a call works on
};

[[nodiscard]] std::unique_ptr<Kernels> pinocchio_kernels(const Description& description);

}  // namespace peers
