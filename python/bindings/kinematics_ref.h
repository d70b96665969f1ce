/// kinematics_ref.h - kinematics of a robot as Python holds them: a model that nothing changes, for any thread.
#pragma once

#include "murosimf/kinematics.h"

namespace murosimf::python {

struct KinematicsRef {
  Kinematics kinematics;
};

}  // namespace murosimf::python
