/// section_change.h - keys of [light] and [ball] that change while a scene runs: "light.brightness = 0.3", "ball.radius = 0.07".
#pragma once

#include <string_view>
#include <vector>

#include "murosimf/scene_file/scene_spec.h"

namespace murosimf::scene_file {

/// Of [ball]: what makes another ball. Of [light] all can change.
[[nodiscard]] const std::vector<std::string_view>& changeable_ball_keys();

/// What there is with one key changed, as an event of such a section says. Throw SetupError at the event's place: no key of the
/// section that can change, and whatever the section refuses.
[[nodiscard]] LightSpec changed(const LightSpec& light, const SceneEvent& event);
[[nodiscard]] BallSpec changed(const BallSpec& ball, const SceneEvent& event);

}  // namespace murosimf::scene_file
