/// urdf_shape_writer.h - shapes and meshes of a description as collisions and visuals of a URDF file.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "murosimf/files/xml_text.h"
#include "murosimf/robot_formats/robot_description.h"
#include "murosimf/robot_formats/urdf/urdf_writer.h"

namespace murosimf::robot_formats::urdf {

class UrdfShapeWriter {
 public:
  /// All arguments must outlive the object.
  UrdfShapeWriter(const robot_formats::RobotDescription& description, const UrdfWriterOptions& options,
                  files::XmlText& xml, UrdfText& result);

  /// Writes the shapes of a link; `place`: frame of the body in that of the link. A capsule is written as a cylinder and two spheres, which
  /// are the same set of points: most programs that read URDF have no capsule. A body without visuals shows its collision shapes. Parts of one
  /// mesh are one collision: readers split the file again.
  void write(const robot_formats::BodyDescription& body, const Transformd& place);

 private:
  void write_shape(const char* tag, const robot_formats::ShapeDescription& shape, const Transformd& place);
  void write_capsule(const char* tag, const robot_formats::ShapeDescription& shape, const Transformd& place);
  void write_geometry(const robot_formats::ShapeDescription& shape);
  void write_mesh(const std::string& file, const Vec3d& scale);
  void write_visual(const robot_formats::VisualDescription& visual, const Transformd& place);
  void write_color(const Color& color);
  [[nodiscard]] const robot_formats::MeshDescription* mesh_in_file(const std::string& name) const;
  [[nodiscard]] std::string relative_name(const std::filesystem::path& file) const;

  const robot_formats::RobotDescription& description_;
  const UrdfWriterOptions& options_;
  files::XmlText& xml_;
  UrdfText& result_;
};

}  // namespace murosimf::robot_formats::urdf
