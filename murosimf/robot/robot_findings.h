/// robot_findings.h - the results of the checks of a robot file.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace murosimf::robot {

enum class Severity { note, warning, error };

[[nodiscard]] const char* severity_name(Severity severity);

struct Finding {
  Severity severity = Severity::warning;
  std::string where;   ///< "robot.xml:12"; empty: no particular place
  std::string what;    ///< the error
  std::string advice;  ///< a correction; may be empty
};

/// Splits a line of a reader: "robot.xml:12: what; what to do".
[[nodiscard]] Finding make_finding(Severity severity, std::string_view line);

/// Makes paths below `folder` relative to it.
void shorten_paths(std::vector<Finding>& findings, const std::filesystem::path& folder);

/// "warning: robot.xml:12: what; what to do"
[[nodiscard]] std::string to_line(const Finding& finding);

}  // namespace murosimf::robot
