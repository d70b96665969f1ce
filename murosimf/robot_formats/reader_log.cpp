#include "murosimf/robot_formats/reader_log.h"

#include <fmt/format.h>

#include "murosimf/files/xml_element.h"
#include "murosimf/model/error.h"

namespace murosimf::robot_formats {
namespace {

std::string line(const std::string& where, const std::string& message) {
  return files::one_line(fmt::format("{}: {}", where, message));
}

}  // namespace

void ReaderLog::note(const std::string& where, const std::string& message) {
  if (report(message)) description_.notes.push_back(line(where, message));
}

void ReaderLog::unused(const std::string& where, const std::string& word, const std::string& message) {
  if (report(message)) description_.unused.push_back({files::one_line(word), line(where, message)});
}

void ReaderLog::warn(const std::string& where, const std::string& message) {
  if (report(message)) description_.warnings.push_back(line(where, message));
}

void ReaderLog::refuse(const std::string& where, const std::string& message) {
  if (!lenient_) throw SetupError(line(where, message + " (--lenient reads on)"));
  warn(where, message);
}

}  // namespace murosimf::robot_formats
