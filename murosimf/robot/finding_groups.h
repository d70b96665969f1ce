/// finding_groups.h - findings of one kind in one line, for readers: files repeat their errors.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "murosimf/robot/robot_findings.h"

namespace murosimf::robot {

/// Findings of one severity that differ only in names and numbers.
struct FindingGroup {
  Finding first;
  std::vector<std::string> others;  ///< subject of each of the others: "'l_foot'", "attribute 'condim' of geom"
};

/// Errors, warnings, notes; within a severity in the order of their first findings.
[[nodiscard]] std::vector<FindingGroup> grouped(const std::vector<Finding>& findings);

/// "warning: robot.xml:12: 'l_foot' is odd (and 3 more: 'r_foot', 'l_toe', 'r_toe'); correct it"
[[nodiscard]] std::string to_line(const FindingGroup& group);

/// At most `most` lines; the last one then gives the number of kinds that are left out.
[[nodiscard]] std::string grouped_text(const std::vector<Finding>& findings, std::size_t most);

}  // namespace murosimf::robot
