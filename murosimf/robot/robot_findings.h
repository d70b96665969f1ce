/// robot_findings.h - what the checks have to say about a robot file.
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
  std::string where;   ///< "robot.xml:12"; empty: nowhere in particular
  std::string what;    ///< what is wrong
  std::string advice;  ///< what to do about it; may be empty
};

/// Takes a line of a reader apart: "robot.xml:12: what; what to do".
[[nodiscard]] Finding make_finding(Severity severity, std::string_view line);

/// Paths below `folder` are said from there.
void shorten_paths(std::vector<Finding>& findings, const std::filesystem::path& folder);

/// "warning: robot.xml:12: what; what to do"
[[nodiscard]] std::string to_line(const Finding& finding);

}  // namespace murosimf::robot
