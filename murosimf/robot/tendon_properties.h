/// tendon_properties.h - tendons of a description as properties of their sliders.
#pragma once

#include <functional>
#include <string>

#include "murosimf/multibody/spatial_tendon.h"
#include "murosimf/multibody/tendon_tie.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot {

/// Of a tendon with a path, whose parts exist; `object_of`: name of the object of a body.
[[nodiscard]] SpatialTendon spatial_tendon_of(const robot_formats::RobotDescription& description,
                                              const robot_formats::TendonDescription& tendon,
                                              const std::function<std::string(const std::string&)>& object_of);

/// Of a tendon with a tie.
[[nodiscard]] TendonTie tie_of(const robot_formats::RobotDescription& description,
                               const robot_formats::TendonDescription& tendon);

}  // namespace murosimf::robot
