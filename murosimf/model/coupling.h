/// coupling.h - a joint whose position follows another joint's, by a rod or a gear: plain data.
#pragma once

#include <string>

namespace murosimf {

/// position = offset + ratio * (position of the leader). A property of the joint that follows.
struct JointCoupling {
  std::string leader;  ///< name of a joint of the same model; it may follow another one itself
  double ratio = 1;    ///< [1 | rad/m | m/rad]
  double offset = 0;   ///< [rad | m]
};

}  // namespace murosimf
