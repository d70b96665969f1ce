/// message_box.h - messages of one robot: sent to its team, and received.
///
/// The software (team_radio.h) writes the outbox and reads the inbox; MessageExchange carries messages between them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "murosimf/model/property.h"
#include "murosimf/model/value.h"
#include "murosimf/world/state_archive.h"
#include "murosimf/world/time.h"

namespace murosimf::control_software {

struct TeamMessage {
  Duration sent{};     ///< simulated time
  std::string sender;  ///< name of the robot; empty: it comes from outside of the simulation
  std::string bytes;

  void state(StateArchive& archive) { archive(sent, sender, bytes); }
};

/// Counts of a robot's messages by outcome.
struct MessageCounts {
  std::uint64_t sent = 0;      ///< by this robot
  std::uint64_t refused = 0;   ///< too long, or too many in a second
  std::uint64_t lost = 0;      ///< of those sent: deliveries that failed, one per team mate
  std::uint64_t arrived = 0;   ///< for this robot
  std::uint64_t not_read = 0;  ///< of these: pushed out of the inbox by newer ones
};

struct MessageBox {
  std::uint64_t longest = 0;     ///< [byte] of a message; constant
  std::uint64_t per_second = 0;  ///< messages; constant
  std::vector<TeamMessage> outbox, inbox;
  std::vector<Duration> recent;  ///< when it has sent within the last second
  MessageCounts counts;

  static constexpr std::size_t most_unread = 1000;

  /// Appends to the inbox; if it is full, the oldest message is dropped.
  void deliver(TeamMessage message);
  void state(StateArchive& archive) { archive(outbox, inbox, recent, counts); }
};

void append_hash(Hasher& hasher, const MessageBox& box);

inline constexpr Property<MessageBox> message_box{
    {"message_box", "-", "-", "messages between a robot's software and its team", Scope::base}};

}  // namespace murosimf::control_software
