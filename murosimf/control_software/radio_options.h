/// radio_options.h - radio communication within a team: [communication] of a scene.
#pragma once

#include <cstdint>

#include "murosimf/control_software/link_options.h"

namespace murosimf::control_software {

/// Each team has its own channel, which its robots use one at a time; a message is sent to every other robot of the
/// team, each with its own delay and probability of loss.
struct RadioOptions {
  double range = 0;                        ///< [m] between the bases of two robots; 0: any
  double bandwidth = 0;                    ///< [byte/s] of the channel of a team; 0: any
  double delay = 0, jitter = 0;            ///< [s] as in LinkOptions
  double loss = 0;                         ///< [1] share of the messages that do not arrive at one of the others
  std::uint64_t message_bytes = 1400;      ///< longest message: with its headers it fits into one Ethernet frame
  std::uint64_t messages_per_second = 20;  ///< of one robot, in any second of simulated time

  [[nodiscard]] LinkOptions channel() const { return {.bandwidth = bandwidth}; }
  [[nodiscard]] LinkOptions way() const { return {.delay = delay, .jitter = jitter, .loss = loss}; }
};

}  // namespace murosimf::control_software
