/// link_options.h - properties of a communication link.
#pragma once

#include <cstdint>

#include "murosimf/world/time.h"

namespace murosimf::control_software {

struct LinkOptions {
  double delay = 0;      ///< [s] from the last byte sent to its arrival
  double jitter = 0;     ///< [s] random extra delay: uniform from 0 to this
  double bandwidth = 0;  ///< [byte/s]; 0: any
  double loss = 0;       ///< [1] share of the packets that do not arrive
  double longest_queue =
      1;  ///< [s] for which a packet waits while others are being sent; if it had to wait longer, it is lost
  bool in_order = false;  ///< none overtakes another one: a stream. Otherwise jitter may reorder packets, as on a radio
};

/// Of packets.
struct LinkCounts {
  std::uint64_t sent = 0, lost = 0;
  std::uint64_t overtaken = 0;  ///< came after newer ones
  Duration longest{};           ///< on the way, of those that are not lost
};

}  // namespace murosimf::control_software
