/// section_change.h - keys of [light] and [ball] that change while a scene runs: "light.brightness = 0.3", "ball.radius = 0.07".
#pragma once

#include <string_view>
#include <vector>

#include "murosimf/scene_file/scene_spec.h"

namespace murosimf::scene_file {

/// Of [ball]: keys that replace the ball. All keys of [light] can change.
[[nodiscard]] const std::vector<std::string_view>& changeable_ball_keys();

/// The section with one key changed, as an event requests. Throw SetupError at the event's place: no key of the
/// section that can change, or an invalid value.
[[nodiscard]] LightSpec changed(const LightSpec& light, const SceneEvent& event);
[[nodiscard]] BallSpec changed(const BallSpec& ball, const SceneEvent& event);

}  // namespace murosimf::scene_file
