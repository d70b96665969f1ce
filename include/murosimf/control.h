/// control.h - control software of a robot as a class of the program: called at its rate of simulated time, between the sensors and
/// the motion of its robot (docs/api.md). Software in libraries and other programs has interfaces of its own (docs/library.md, docs/tcp.md).
#pragma once

#include <span>

#include "murosimf/version.h"

namespace murosimf {
inline namespace v0 {

/// What a controller sees and sets in one cycle; rows have one number for each joint, in the order of Robot::joints(). They stay
/// at the same place in memory from start() on.
struct ControlCycle {
  double time = 0;                         ///< [s] simulated
  double period = 0;                       ///< [s] until the next cycle
  std::span<const double> joint_position;  ///< [rad | m]
  std::span<const double> joint_velocity;  ///< [rad/s | m/s]
  std::span<double>
      joint_target;  ///< [rad | m] a target stays until it is set again; limited to the range of the servo
};

/// An exception that leaves a call ends the step or run in which it was thrown with that exception; the robot keeps its last targets.
/// Its memory is not part of Scene::save(). During a call the robot's sensors may be read, but nothing of the scene may be changed.
/// A controller that keeps handles of its scene (Robot, Sensor) keeps the scene alive until Robot::set_controller(nullptr).
class MUROSIMF_API Controller {
 public:
  virtual ~Controller();

  /// The run begins, or begins again; targets are the positions of the joints.
  virtual void start(ControlCycle& cycle);
  virtual void step(ControlCycle& cycle) = 0;
};

}  // namespace v0
}  // namespace murosimf
