/// proto_log.h - where the reader of PROTO files puts what it has to say about a file.
#pragma once

#include <set>
#include <string>

#include "murosimf/description/robot_description.h"
#include "murosimf/formats/proto/proto_node.h"

namespace murosimf::formats::proto {

class ProtoLog {
 public:
  ProtoLog(description::RobotDescription& description, bool lenient) : description_(description), lenient_(lenient) {}

  /// What was taken instead, or guessed; the same message is noted once.
  void note(const std::string& where, const std::string& message);
  /// What has no effect here: `check` shows the message, `run` the word, like "LED"; each word is told once.
  void unused(const std::string& where, const std::string& word, const std::string& message);
  /// What looks wrong; the same message is told once.
  void warn(const std::string& where, const std::string& message);
  /// What would change the robot: throws SetupError, or is a warning if the reader is lenient.
  void refuse(const Node& at, const std::string& message, const Field* field = nullptr);
  /// Refuses fields that the type of the node does not have, where it acts (proto_schema.h).
  void check_fields(const Node& node);
  [[nodiscard]] bool lenient() const { return lenient_; }

 private:
  description::RobotDescription& description_;
  bool lenient_;
  std::set<std::string> said_;
};

}  // namespace murosimf::formats::proto
