/// urdf_log.h - where the readers of URDF put what they have to say about a file.
#pragma once

#include <set>
#include <string>

#include "murosimf/description/robot_description.h"
#include "murosimf/files/xml_element.h"
#include "murosimf/files/xml_schema.h"

namespace murosimf::formats::urdf {

class UrdfLog {
 public:
  UrdfLog(description::RobotDescription& description, bool lenient) : description_(description), lenient_(lenient) {}

  /// What was taken instead, or guessed; the same message is noted once.
  void note(const files::XmlElement& at, const std::string& message);
  /// What has no effect here: `check` shows the message, `run` the word, like "transmission"; the same message is told once.
  void unused(const files::XmlElement& at, const std::string& word, const std::string& message);
  /// What a schema says of a part of the file; what it does not know is a warning.
  void take(const files::XmlFindings& findings);
  /// What looks wrong; the same message is told once.
  void warn(const files::XmlElement& at, const std::string& message);
  /// What would change the robot: throws SetupError, or is a warning if the reader is lenient.
  void refuse(const files::XmlElement& at, const std::string& message);
  [[nodiscard]] bool lenient() const { return lenient_; }

 private:
  description::RobotDescription& description_;
  bool lenient_;
  std::set<std::string> said_;
};

}  // namespace murosimf::formats::urdf
