/// joint_arrays.h - joints of a robot as rows in memory that Python shows as arrays of NumPy.
///
/// The library's columns have a row for each object, with and without joint, so joints do not stand one after the other in them. The rows
/// here are gathered after each call that may have changed them; what was written to them is put in before the next call.
#pragma once

#include <span>
#include <vector>

#include "murosimf/robot.h"

namespace murosimf::python {

class JointArrays {
 public:
  explicit JointArrays(Robot robot);

  /// As the scene has them now; NaN while the robot is not there.
  void gather();
  /// Those that were written. Throws as Robot::set_joint_..., and Error while the robot is not there, and then shows again what the scene has.
  void put();

  // For one call of a controller.
  void show(const ControlCycle& cycle);
  void take(ControlCycle& cycle) const;

  struct Row {
    std::vector<double> values;
    std::vector<double> known;  ///< as gathered: others were written

    void gather(std::span<const double> now);
    void blank(std::size_t size);
    [[nodiscard]] bool was_written() const;
  };
  Row position, velocity, torque, target;

 private:
  void put_written();
  Robot robot_;
};

}  // namespace murosimf::python
