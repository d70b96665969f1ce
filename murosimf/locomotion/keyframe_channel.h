/// keyframe_channel.h - what the names in a key-frame motion's columns mean to a model.
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

/// Of "left_foot.x"; nothing if the channel is none of a foot.
[[nodiscard]] std::optional<FootAxis> foot_axis(std::string_view channel);
[[nodiscard]] std::string channel_name(const FootAxis& foot);

/// The object. Throws SetupError with the nearest name if the model has no such joint.
[[nodiscard]] int joint_of_channel(const Model& model, std::string_view channel);

}  // namespace murosimf::locomotion
