/// keyframe_channel.h - meaning of the column names of a key-frame motion for a model.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "murosimf/model/model.h"

namespace murosimf::locomotion {

inline constexpr std::array<std::string_view, 4> foot_axes{"x", "y", "z", "pitch"};  // [m, m, m, rad]

struct FootAxis {
  std::size_t side = 0;  ///< 0: left
  std::size_t axis = 0;  ///< of foot_axes
};

/// Axis of a name such as "left_foot.x"; nothing if the channel is not one of a foot.
[[nodiscard]] std::optional<FootAxis> foot_axis(std::string_view channel);
[[nodiscard]] std::string channel_name(const FootAxis& foot);

/// The object of the joint. Throws SetupError with the nearest name if the model has no such joint.
[[nodiscard]] int joint_of_channel(const Model& model, std::string_view channel);

}  // namespace murosimf::locomotion
