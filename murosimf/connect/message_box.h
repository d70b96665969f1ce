/// message_box.h - messages of one robot: what it sends to its team, and what has arrived.
///
/// Its software (team_radio.h) puts into the outbox and takes out of the inbox; MessageExchange carries from one to the other.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "murosimf/model/property.h"
#include "murosimf/model/state_archive.h"
#include "murosimf/model/time.h"
#include "murosimf/model/value.h"

namespace murosimf::connect {

struct TeamMessage {
  Duration sent{};     ///< simulated time
  std::string sender;  ///< name of the robot; empty: it comes from outside of the simulation
  std::string bytes;

  void state(StateArchive& archive) { archive(sent, sender, bytes); }
};

/// How many messages of a robot have gone which way.
struct MessageCounts {
  std::uint64_t sent = 0;      ///< by it
  std::uint64_t refused = 0;   ///< too long, or too many in a second
  std::uint64_t lost = 0;      ///< of what it has sent: times that one did not reach a robot of its team
  std::uint64_t arrived = 0;   ///< for it
  std::uint64_t not_read = 0;  ///< of these: pushed out of the inbox by newer ones
};

struct MessageBox {
  std::uint64_t longest = 0;     ///< [byte] of a message; constant
  std::uint64_t per_second = 0;  ///< messages; constant
  std::vector<TeamMessage> outbox, inbox;
  std::vector<Duration> recent;  ///< when it has sent within the last second
  MessageCounts counts;

  static constexpr std::size_t most_unread = 1000;

  /// Into the inbox; the oldest one makes room if it is full.
  void deliver(TeamMessage message);
  void state(StateArchive& archive) { archive(outbox, inbox, recent, counts); }
};

void append_hash(Hasher& hasher, const MessageBox& box);

inline constexpr Property<MessageBox> message_box{
    {"message_box", "-", "-", "messages between a robot's software and its team", Scope::base}};

}  // namespace murosimf::connect
