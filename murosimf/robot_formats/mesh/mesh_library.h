/// mesh_library.h - meshes as solids for contact: each file is read once, each hull made once.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "murosimf/geometry/mesh_mass.h"
#include "murosimf/model/shape.h"
#include "murosimf/robot_formats/mesh/mesh_file.h"

namespace murosimf::robot_formats::mesh {

/// One convex part of a mesh.
struct ConvexPart {
  Convex shape;
  Vec3d middle;      ///< [m] of the shape's origin, mesh frame
  double error = 0;  ///< [m] by which the mesh may stand out of it (geometry/hull.h)
};

/// A mesh and the convex parts that replace it in contact.
struct SolidMesh {
  geometry::TriangleMesh triangles;  ///< [m]
  geometry::Seams seams;
  std::vector<ConvexPart> parts;  ///< none if the mesh is flat
  std::string flat;               ///< why there are no parts
};

/// Multiplies all coordinates. An odd number of negative scales reverses the triangles, with their places in pictures, so that the
/// outside remains outside.
void scale_mesh(geometry::TriangleMesh& mesh, const Vec3d& scale);

/// The hull of the whole file or, with `part_per_group`, of each of its objects or groups.
[[nodiscard]] SolidMesh make_solid_mesh(MeshFile file, bool part_per_group);

/// The parts together, at density 1; where they overlap, the overlap counts twice.
[[nodiscard]] geometry::SolidMass hull_mass(const std::vector<ConvexPart>& parts);

/// What looks wrong with a mesh for collisions, one line each: very wide (millimeters?), not closed, concave, or
/// with so many vertices that contact is slow.
[[nodiscard]] std::vector<std::string> mesh_doubts(const SolidMesh& mesh);

class MeshLibrary {
 public:
  /// The mesh of a file with its numbers multiplied by `scale`; the same reference for the same file and scale; the
  /// first call decides about `part_per_group`. Throws SetupError: mesh file, line, what is wrong; and for a scale of
  /// zero.
  [[nodiscard]] const SolidMesh& get(const std::filesystem::path& file, const Vec3d& scale, bool part_per_group);

 private:
  std::map<std::pair<std::filesystem::path, std::array<double, 3>>, SolidMesh> meshes_;
};

}  // namespace murosimf::robot_formats::mesh
