/// scene_viewpoints.h - named viewpoints of a scene.
///
/// overview: from the scene's [view], all of it in the picture; top: from above; side: along y; left, right: from behind
/// the goal at negative and positive x; the name of a robot or ball: from behind and above it, along its heading;
/// and the [views.NAME] of the scene.
#pragma once

#include <string>
#include <vector>

#include "murosimf/render/projection.h"
#include "murosimf/scene/scene.h"

namespace murosimf::scene {

/// Names of all viewpoints of a scene.
[[nodiscard]] std::vector<std::string> viewpoint_names(const Scene& scene);

/// The present picture from one of them. Throws SetupError with the nearest name if there is none.
[[nodiscard]] sensors::Perspective viewpoint_perspective(const Scene& scene, const std::string& name, int width,
                                                         int height);

/// From the azimuth of the scene's [view], `elevation` [rad] up, at the smallest distance with all points [m, world] in the picture.
[[nodiscard]] sensors::Perspective perspective_around(const Scene& scene, const std::vector<Vec3d>& points,
                                                      double elevation, int width, int height);

/// By parallel rays along the scene's [view]: all of its field, or `width` [m] about `center`.
[[nodiscard]] render::ParallelView parallel_view(const Scene& scene, int width, int height);

}  // namespace murosimf::scene
