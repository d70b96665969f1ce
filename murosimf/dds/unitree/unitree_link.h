/// unitree_link.h - the topics of one Unitree robot in a DDS domain.
#pragma once

#include <string>

#include "murosimf/dds/inbox.h"
#include "murosimf/dds/participant.h"
#include "murosimf/dds/unitree/motion_switcher.h"

namespace murosimf::dds::unitree {

/// Marks of messages in the inbox.
inline constexpr char low_command_mark = 'c', request_mark = 'r';

class UnitreeLink {
 public:
  /// `suffix`: behind the names of all topics, for several robots in a domain. Throws SetupError as Participant.
  UnitreeLink(int domain, const std::string& suffix);

  [[nodiscard]] Inbox& inbox() { return inbox_; }
  [[nodiscard]] TopicWriter& low_state() { return low_state_; }
  [[nodiscard]] TopicWriter& torso_imu() { return torso_imu_; }
  void answer(const Answer& answer);

 private:
  Inbox inbox_;
  Participant participant_;  // ends before the inbox
  TopicWriter &low_state_, &torso_imu_, &answers_;
  CdrWriter answer_;
};

}  // namespace murosimf::dds::unitree
