/// urdf_shape.h - `visual` and `collision` elements of links of a URDF file.
///
/// Meshes that collide become convex hulls. Visual ones are named, not read: the physics does not need them.
#pragma once

#include <map>
#include <string>

#include "murosimf/robot_formats/robot_description.h"
#include "murosimf/robot_formats/urdf/urdf_log.h"
#include "murosimf/robot_formats/urdf/urdf_mesh.h"

namespace murosimf::robot_formats::urdf {

/// A `material`: one with a texture and no color is white.
struct UrdfPaint {
  Color color;
  std::string picture{};  ///< file name of the texture as the file spells it; empty: none
};
/// By name of material, independent of where the file defines them; the first definition counts.
using UrdfPaints = std::map<std::string, UrdfPaint>;
[[nodiscard]] UrdfPaints read_paints(const files::XmlElement& robot);

inline constexpr double standard_friction = 1.0;  ///< [1] default of Gazebo and MuJoCo for URDF files

/// A shape at its place in a body [m, axes of the body], with its `friction` [1] and color.
[[nodiscard]] PlacedShape placed_shape(const Shape& shape, const Transformd& place, const Color& color, bool collides,
                                       double friction = standard_friction);

class UrdfShapes {
 public:
  UrdfShapes(UrdfPaints paints, UrdfMeshes meshes, UrdfLog& log)
      : paints_(std::move(paints)), meshes_(std::move(meshes)), log_(log) {}

  /// Adds the shapes of a link to its body, with the friction that Bullet's `contact` gives the link. Shapes that collide have the color of
  /// the link's first visual. Throws SetupError: impossible sizes, missing or unreadable collision mesh. A missing visual mesh is a warning.
  void add(const files::XmlElement& link, robot_formats::BodyDescription& body);

 private:
  /// A part with a geometry, before it becomes a shape.
  struct Part {
    files::XmlElement element;
    bool collides = false;
    UrdfPaint paint{};
  };
  void add_part(const Part& part, robot_formats::BodyDescription& body);
  void add_mesh(const Part& part, const files::XmlElement& mesh, robot_formats::BodyDescription& body);
  void add_visual_mesh(const Part& part, const files::XmlElement& mesh, robot_formats::BodyDescription& body);
  void add_collision_mesh(const Part& part, const files::XmlElement& mesh, robot_formats::BodyDescription& body);
  [[nodiscard]] UrdfPaint paint_of(const files::XmlElement& visual);

  UrdfPaints paints_;
  UrdfMeshes meshes_;
  UrdfLog& log_;
};

}  // namespace murosimf::robot_formats::urdf
