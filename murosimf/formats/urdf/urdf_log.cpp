#include "murosimf/formats/urdf/urdf_log.h"

#include <fmt/format.h>

namespace murosimf::formats::urdf {
namespace {

std::string line(const files::XmlElement& at, const std::string& message) {
  return files::one_line(fmt::format("{}: {}", at.where(), message));
}

}  // namespace

void UrdfLog::note(const files::XmlElement& at, const std::string& message) {
  if (said_.insert(message).second) description_.notes.push_back(line(at, message));
}

void UrdfLog::unused(const files::XmlElement& at, const std::string& word, const std::string& message) {
  if (said_.insert(message).second) description_.unused.push_back({files::one_line(word), line(at, message)});
}

void UrdfLog::take(const files::XmlFindings& findings) {
  for (const auto& [word, text] : findings.unused) {
    if (said_.insert(word).second) description_.unused.push_back({word, text});
  }
  for (const std::string& text : findings.refused) {
    if (said_.insert(text).second) description_.warnings.push_back(text);
  }
}

void UrdfLog::warn(const files::XmlElement& at, const std::string& message) {
  if (said_.insert(message).second) description_.warnings.push_back(line(at, message));
}

void UrdfLog::refuse(const files::XmlElement& at, const std::string& message) {
  if (!lenient_) at.fail(message + " (--lenient reads on)");
  warn(at, message);
}

}  // namespace murosimf::formats::urdf
