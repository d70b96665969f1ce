/// urdf_log.h - diagnostics of the readers of URDF (robot_formats/reader_log.h).
#pragma once

#include "murosimf/files/xml_element.h"
#include "murosimf/files/xml_schema.h"
#include "murosimf/robot_formats/reader_log.h"

namespace murosimf::robot_formats::urdf {

class UrdfLog : public robot_formats::ReaderLog {
 public:
  using ReaderLog::ReaderLog;

  void note(const files::XmlElement& at, const std::string& message) { ReaderLog::note(at.where(), message); }
  void unused(const files::XmlElement& at, const std::string& word, const std::string& message) {
    ReaderLog::unused(at.where(), word, message);
  }
  void warn(const files::XmlElement& at, const std::string& message) { ReaderLog::warn(at.where(), message); }
  void refuse(const files::XmlElement& at, const std::string& message) { ReaderLog::refuse(at.where(), message); }
  /// Adds the findings of a schema; unknown words are warnings.
  void take(const files::XmlFindings& findings);
};

}  // namespace murosimf::robot_formats::urdf
