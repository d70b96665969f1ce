/// scene_viewpoints.h - from where people look at a scene: places by name.
///
/// overview: from the scene's [view], all of it in the picture; top: from above; side: along y; left, right: from behind
/// the goal at negative and positive x; the name of a robot or ball: from behind and above it, turned as it is headed;
/// and the [views.NAME] of the scene.
#pragma once

#include <string>
#include <vector>

#include "murosimf/render/projection.h"
#include "murosimf/scene/scene.h"

namespace murosimf::scene {

/// Names of all places of a scene.
[[nodiscard]] std::vector<std::string> viewpoint_names(const Scene& scene);

/// The picture from one of them, as things are now. Throws SetupError with the nearest name if there is none.
[[nodiscard]] sensors::Perspective viewpoint_perspective(const Scene& scene, const std::string& name, int width,
                                                         int height);

/// From the scene's [view] by parallel rays: all of its field, or `width` [m] about `center`.
[[nodiscard]] render::ParallelView parallel_view(const Scene& scene, int width, int height);

}  // namespace murosimf::scene
