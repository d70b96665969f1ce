#include "murosimf/robot_formats/urdf/urdf_log.h"

namespace murosimf::robot_formats::urdf {

void UrdfLog::take(const files::XmlFindings& findings) {
  for (const auto& [word, text] : findings.unused) {
    if (report(word)) description().unused.push_back({word, text});
  }
  for (const std::string& text : findings.refused) {
    if (report(text)) description().warnings.push_back(text);
  }
}

}  // namespace murosimf::robot_formats::urdf
