/// robot_soles.h - frames of a robot's file that are soles, and soles that are computed from shapes.
///
/// Only readers of robots need this; with a model, use model/feet.h.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "murosimf/robot/robot_config.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot {

/// The only rule for files: a sole is a frame with a rectangle that is named in [soles] of the table; without such a section, any
/// box site with a name that ends with "sole". To be called when soles are placed (role_inference.h).
[[nodiscard]] bool is_sole(const robot_formats::FrameDescription& frame, const RobotConfig& table);

/// Indices of bodies with a sole by that rule, or that are named in [soles] of the table.
[[nodiscard]] std::set<std::size_t> bodies_with_soles(const robot_formats::RobotDescription& description,
                                                      const RobotConfig& table);

/// Place of every body in the frame of the base, in the pose of the file.
[[nodiscard]] std::vector<Transformd> body_places(const robot_formats::RobotDescription& description);

/// All bodies as one, in the frame of the base and the pose of the file.
[[nodiscard]] robot_formats::MassProperties whole_solid(const robot_formats::RobotDescription& description);

/// [m] Lowest point of all shapes that collide, in the frame of the base and the pose of the file; infinite without any.
[[nodiscard]] double lowest_point(const robot_formats::RobotDescription& description);

/// The rectangle around the lowest few millimeters of the colliding shapes of a body, at least 2 cm wide; a frame of
/// `name` at its middle. Parts are drawn along their own axes, but a foot need not be level in the pose of the file: x, y, z
/// of the sole are those axes of `axes` (in the body), with either sign, that are nearest to forward, left and up
/// there. Nothing if the body has no such shape.
/// Bodies behind it that end within those millimeters of its bottom, toes, are included.
[[nodiscard]] std::optional<robot_formats::FrameDescription> sole_under(
    const robot_formats::RobotDescription& description, std::size_t body, const std::string& name,
    const Mat3d& axes = {});

/// Farthest points downwards, and nearly so, of all shapes of a body that collide; `place`: of the body in a frame with -z
/// is down.
[[nodiscard]] std::vector<Vec3d> low_points(const robot_formats::BodyDescription& body, const Transformd& place);
/// [m] z of the lowest; infinite without points.
[[nodiscard]] double lowest(const std::vector<Vec3d>& points);

}  // namespace murosimf::robot
