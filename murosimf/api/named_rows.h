/// named_rows.h - which numbers of a robot a name of batch.h means: "PROPERTY" or "OBJECT.PROPERTY".
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "murosimf/api/scene_inside.h"

namespace murosimf::api {

struct NamedRows {
  std::string property;
  std::vector<std::size_t> rows;  ///< of its column
  std::size_t numbers = 1;        ///< of a row
};

/// A property alone: of all joints if all objects have it, else that which the robot has once. Throws UnknownName; `kind` is what the
/// message calls the name, `others` are names that would be known besides.
[[nodiscard]] NamedRows named_rows(const Entity& robot, const JointRows& joints, const std::string& name,
                                   std::string_view kind, std::vector<std::string> others = {});

}  // namespace murosimf::api
