/// booster_link.h - the topics of one Booster robot in a DDS domain.
#pragma once

#include <chrono>
#include <string>

#include "murosimf/dds/booster/messages.h"
#include "murosimf/dds/inbox.h"
#include "murosimf/dds/participant.h"

namespace murosimf::dds::booster {

/// Marks of messages in the inbox.
inline constexpr char low_command_mark = 'c', request_mark = 'r', kick_mark = 'k';

/// Service of the robot's walk, without "Req" and "Resp".
inline constexpr const char* loco_service = "rt/LocoApiTopic";

class BoosterLink {
 public:
  /// `suffix`: behind the names of all topics, for several robots in a domain. Throws SetupError as Participant.
  BoosterLink(int domain, const std::string& suffix);

  [[nodiscard]] Inbox& inbox() { return inbox_; }

  struct StateWriters {
    TopicWriter &low_state, &odometer, &fall_down, &robot_states, &battery;
  };
  [[nodiscard]] const StateWriters& states() const { return states_; }
  void answer(const RpcMessage& message);

 private:
  [[nodiscard]] TopicWriter& state_writer(const std::string& topic, const std::string& type);

  std::string suffix_;
  Inbox inbox_;
  Participant participant_;  // ends before the inbox
  StateWriters states_;
  TopicWriter& answers_;
  CdrWriter answer_;
};

}  // namespace murosimf::dds::booster
