/// reader_log.h - collects the diagnostics of readers of robot files.
#pragma once

#include <set>
#include <string>

#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats {

/// Each message is reported once, with the first place ("robot.xml:12") that it applies to.
class ReaderLog {
 public:
  ReaderLog(RobotDescription& description, bool lenient) : description_(description), lenient_(lenient) {}

  /// Reports what is used instead, or guessed.
  void note(const std::string& where, const std::string& message);
  /// Reports a part without effect: `check` shows the message, `run` the word, like "transmission".
  void unused(const std::string& where, const std::string& word, const std::string& message);
  /// Reports what looks wrong.
  void warn(const std::string& where, const std::string& message);
  /// Reports what would change the robot: throws SetupError, or is a warning if the reader is lenient.
  void refuse(const std::string& where, const std::string& message);
  [[nodiscard]] bool lenient() const { return lenient_; }

 protected:
  /// False if the message was reported earlier.
  bool report(const std::string& message) { return said_.insert(message).second; }
  [[nodiscard]] RobotDescription& description() { return description_; }

 private:
  RobotDescription& description_;
  bool lenient_;
  std::set<std::string> said_;
};

}  // namespace murosimf::robot_formats
