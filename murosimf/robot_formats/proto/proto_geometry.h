/// proto_geometry.h - shapes of a PROTO file: for collisions (boundingObject) and for drawing (Shape).
///
/// Box, Sphere, Capsule and Cylinder (height of the straight part, axis along z; along y before R2022a, which turned them), Mesh and
/// IndexedFaceSet as their convex hulls. Group, Pose and Transform place them; a `scale` that differs between directions is for meshes.
/// Source: Webots reference manual, nodes of these names, "boundingObject" of Solid; change log of R2022a.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "murosimf/robot_formats/mass_properties.h"
#include "murosimf/robot_formats/mesh/mesh_library.h"
#include "murosimf/robot_formats/proto/proto_log.h"
#include "murosimf/robot_formats/reader_options.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats::proto {

/// A frame in that of a body; lengths along its axes are multiplied by `scale`.
struct Placing {
  Transformd place;
  Vec3d scale{1, 1, 1};  ///< [1] below 0: mirrored
};

/// Whether the scale is the same in all directions, without mirroring.
[[nodiscard]] bool is_even(const Vec3d& scale);

/// The frame of a Group, Pose or Transform in `outer`. Throws SetupError for a scale of 0, and for a turn inside a scale that differs
/// between directions, which would shear.
[[nodiscard]] Placing placed_in(const Placing& outer, const Node& node);

class ProtoGeometry {
 public:
  /// `upright`: the axes of cylinders and capsules are along y.
  ProtoGeometry(robot_formats::RobotDescription& description, const robot_formats::ReaderOptions& options, bool upright,
                ProtoLog& log)
      : description_(description), part_per_group_(options.part_per_group), upright_(upright), log_(log) {}

  /// Adds the shapes of a boundingObject to the body. Returns each as a solid of density 1 kg/m^3, body axes.
  std::vector<robot_formats::MassProperties> add_bounding(const Node& node, const Placing& at,
                                                          robot_formats::BodyDescription& body);
  /// Adds a Shape for drawing.
  void add_visual(const Node& shape, const Placing& at, robot_formats::BodyDescription& body);
  /// Counts a node. Throws SetupError for more nodes than a robot has: a few lines with USE can mean billions.
  void count(const Node& node);

 private:
  struct Part {
    Shape shape;
    Transformd place;
    std::string mesh{};  ///< its mesh, if it is a part of one
    Vec3d middle{};
  };

  [[nodiscard]] std::optional<Part> primitive(const Node& geometry, const Placing& at) const;
  [[nodiscard]] std::vector<Part> convex_parts(const Node& geometry, const Placing& at);
  [[nodiscard]] std::vector<Part> mesh_parts(const Node& geometry, const Placing& at);
  [[nodiscard]] std::optional<robot_formats::MeshDescription> find_mesh(const Node& mesh, const Vec3d& scale);
  void add_visual_mesh(const Node& mesh, const Placing& at, const Color& color, robot_formats::BodyDescription& body);
  [[nodiscard]] Color color_of(const Node& shape);

  robot_formats::RobotDescription& description_;
  std::vector<std::string> part_per_group_;
  bool upright_;
  ProtoLog& log_;
  robot_formats::mesh::MeshLibrary library_;
  std::size_t seen_ = 0;  ///< number of nodes
};

}  // namespace murosimf::robot_formats::proto
