/// reader_log.h - where readers of robot files put what they have to say about a file.
#pragma once

#include <set>
#include <string>

#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats {

/// Each message is told once, with the first place ("robot.xml:12") that it is about.
class ReaderLog {
 public:
  ReaderLog(RobotDescription& description, bool lenient) : description_(description), lenient_(lenient) {}

  /// What was taken instead, or guessed.
  void note(const std::string& where, const std::string& message);
  /// What has no effect here: `check` shows the message, `run` the word, like "transmission".
  void unused(const std::string& where, const std::string& word, const std::string& message);
  /// What looks wrong.
  void warn(const std::string& where, const std::string& message);
  /// What would change the robot: throws SetupError, or is a warning if the reader is lenient.
  void refuse(const std::string& where, const std::string& message);
  [[nodiscard]] bool lenient() const { return lenient_; }

 protected:
  /// False if it was told before.
  bool tell(const std::string& message) { return said_.insert(message).second; }
  [[nodiscard]] RobotDescription& description() { return description_; }

 private:
  RobotDescription& description_;
  bool lenient_;
  std::set<std::string> said_;
};

}  // namespace murosimf::robot_formats
