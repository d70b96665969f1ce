/// booster_options.h - options of a robot with the controller 'booster'.
#pragma once

#include <string>

namespace murosimf::dds::booster {

struct BoosterOptions {
  int domain = -1;               ///< of DDS; -1: that of the command line
  std::string suffix;            ///< behind the names of all topics
  std::string mode = "prepare";  ///< at the start
  double lock_step = 0;  ///< [s] of wall time that a cycle in custom mode waits for a low-level command; 0: it does not
};

}  // namespace murosimf::dds::booster
