/// unitree_options.h - options of a robot with the controller 'unitree'.
#pragma once

#include <string>

namespace murosimf::dds::unitree {

struct UnitreeOptions {
  int domain = -1;       ///< of DDS; -1: that of the command line
  std::string suffix;    ///< behind the names of all topics
  bool stands = true;    ///< until a program takes its motors; false: they are off until then
  double lock_step = 0;  ///< [s] of wall time that a cycle waits for a low-level command; 0: it does not
};

}  // namespace murosimf::dds::unitree
