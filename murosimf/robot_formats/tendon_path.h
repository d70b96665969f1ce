/// tendon_path.h - where the parts of a spatial tendon are on a robot as its file describes it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "murosimf/math/taut_string.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats {

/// A part of a path on a body (an index).
struct PartOfBody {
  std::size_t body = 0;
  StringPart part;     ///< in the body's frame, without a side
  int side_body = -1;  ///< -1: it has no side
  Vec3d side{};        ///< [m] a point there, in that body's frame
};

/// Nothing if the site does not exist, or the shape is neither a sphere nor a cylinder of the robot.
[[nodiscard]] std::optional<PartOfBody> find_part(const RobotDescription& description,
                                                  const TendonPartDescription& part);

/// [m] Length where every joint stands at one of its numbers; its parts exist.
[[nodiscard]] double path_length(const RobotDescription& description, const std::vector<TendonBranchDescription>& path,
                                 double JointDescription::*position);

/// Names of the joints that change the length of a tendon.
[[nodiscard]] std::vector<std::string> joints_of(const RobotDescription& description, const TendonDescription& tendon);

}  // namespace murosimf::robot_formats
