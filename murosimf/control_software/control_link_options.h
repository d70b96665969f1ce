/// control_link_options.h - the link between a robot and its control software: [robots.link] of a scene.
#pragma once

#include "murosimf/control_software/link_options.h"

namespace murosimf::control_software {

/// Measured values go one way, once in each cycle; commands go the other way. Each way has all of these properties of its own.
struct ControlLinkOptions {
  double delay = 0, jitter = 0;  ///< [s] as in LinkOptions
  double bandwidth = 0;          ///< [byte/s] 8 bytes for each number; 0: any
  double loss = 0;               ///< [1] share of the cycles whose numbers do not arrive
  bool signals = true;           ///< whether measured values take this link
  bool commands = true;          ///< whether commands do

  [[nodiscard]] LinkOptions one_way() const {
    return {.delay = delay, .jitter = jitter, .bandwidth = bandwidth, .loss = loss};
  }
  [[nodiscard]] bool does_something() const {
    return (signals || commands) && (delay > 0 || jitter > 0 || bandwidth > 0 || loss > 0);
  }
};

}  // namespace murosimf::control_software
