#include "murosimf/robot/robot_findings.h"

#include <algorithm>

#include <fmt/format.h>

#include "murosimf/math/assert.h"

namespace murosimf::robot {
namespace {

/// Length of "file:line" or "file:line:column" at the beginning of a line; 0 if there is none.
std::size_t place_length(std::string_view line) {
  const std::size_t end = line.find(": ");
  if (end == std::string_view::npos) return 0;
  const std::size_t colon = line.substr(0, end).rfind(':');
  if (colon == std::string_view::npos || colon + 1 == end) return 0;
  const auto number = line.substr(colon + 1, end - colon - 1);
  MUROSIMF_ASSERT(colon < end);
  return std::ranges::all_of(number, [](char c) { return c >= '0' && c <= '9'; }) ? end : 0;
}

/// Removes `above` where a path begins with it, not inside of one.
void shorten_paths(std::string& text, const std::string& above) {
  for (std::size_t at = text.find(above); at != std::string::npos; at = text.find(above, at + 1)) {
    if (at == 0 || std::string_view(" '(,:").find(text[at - 1]) != std::string_view::npos) text.erase(at, above.size());
  }
}

}  // namespace

const char* severity_name(Severity severity) {
  constexpr const char* names[] = {"note", "warning", "error"};
  return names[static_cast<int>(severity)];
  MUROSIMF_ASSERT(static_cast<std::size_t>(severity) < std::size(names));
}

Finding make_finding(Severity severity, std::string_view line) {
  Finding finding{severity, "", "", ""};
  if (const std::size_t place = place_length(line); place > 0) {
    finding.where = line.substr(0, place);
    line.remove_prefix(place + 2);
  }
  const std::size_t advice = line.rfind("; ");
  finding.what = line.substr(0, advice);
  if (advice != std::string_view::npos) finding.advice = line.substr(advice + 2);
  return finding;
}

void shorten_paths(std::vector<Finding>& findings, const std::filesystem::path& folder) {
  if (folder == folder.root_path()) return;
  const std::string above = (folder / "").string();
  for (Finding& finding : findings) {
    for (std::string* text : {&finding.where, &finding.what, &finding.advice}) shorten_paths(*text, above);
  }
}

std::string to_line(const Finding& finding) {
  std::string line = fmt::format("{}: ", severity_name(finding.severity));
  if (!finding.where.empty()) line += finding.where + ": ";
  line += finding.what;
  if (!finding.advice.empty()) line += "; " + finding.advice;
  return line;
}

}  // namespace murosimf::robot
