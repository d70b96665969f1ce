/// overlays.h - overlays of the picture of a scene: contacts, forces, centers of mass, axes, boxes, names, levels.
///
/// Computed from a frame of poses and from models, in world coordinates; the window projects and paints them.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/runtime/pose_frame.h"
#include "murosimf/viewer/inspection.h"

namespace murosimf::viewer {

struct OverlayOptions {
  bool contacts = false, forces = false, centers_of_mass = false, frames = false, bounding_volumes = false;
  bool names = true, levels = false, standing_feet = false, support_polygons = false;
  bool zero_moment_points = false, joint_loads = false, beliefs = false, drawings = true;
  double force_scale = 0.005;  ///< [m/N] length of an arrow
};

/// A line in the picture, with a head at its end if it is an arrow; a single point is a dot.
struct Mark {
  std::vector<Vec3d> points;  ///< [m] world
  Color color;
  double width = 2;  ///< [px]; of a dot: its radius
  bool arrow = false, closed = false, filled = false;
};
struct Label {
  Vec3d place;  ///< [m] world
  std::string text;
  Color color{1, 1, 1};
};
struct Overlays {
  std::vector<Mark> marks;
  std::vector<Label> labels;
};

/// For all entities; `selected`: the entity with displayed axes, none: -1.
[[nodiscard]] Overlays overlays(const PoseFrame& frame, std::span<const EntityOutline> outline, const Inspection& seen,
                                const OverlayOptions& options, int selected);

/// [m] world, of an entity in that frame; nothing if it has no mass.
[[nodiscard]] std::optional<Vec3d> center_of_mass(const Model& model, std::span<const Vec3d> r,
                                                  std::span<const Mat3d> R);
/// [m] world: the point where the ground's forces on an entity act without a tipping moment (zero moment point, on level ground the
/// center of pressure); nothing if the ground does not support it.
[[nodiscard]] std::optional<Vec3d> zero_moment_point(const PoseFrame& frame, int entity);
/// From green (0) by yellow (0.5) to red (1 and more).
[[nodiscard]] Color color_of_load(double share);
/// Corners of the convex hull in x and y, counterclockwise.
[[nodiscard]] std::vector<Vec3d> hull_on_ground(std::vector<Vec3d> points);
/// The same color for the same level everywhere.
[[nodiscard]] Color color_of_level(std::string_view level);
/// One of a set of easily distinguished colors.
[[nodiscard]] Color curve_color(std::size_t number);

}  // namespace murosimf::viewer
