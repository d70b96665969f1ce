/// visual_meshes.h - reads the files of visual meshes (model/visual_mesh.h) as triangles.
#pragma once

#include <string>
#include <vector>

#include "murosimf/appearance/picture_colors.h"
#include "murosimf/geometry/triangle_mesh.h"
#include "murosimf/model/model.h"
#include "murosimf/model/visual_mesh.h"

namespace murosimf::appearance {

/// All triangles of the mesh, in the frame of its object; corners at the same place are one vertex. Throws SetupError:
/// mesh file, line if there is one, what is wrong, what to do.
[[nodiscard]] geometry::TriangleMesh visual_triangles(const VisualMesh& mesh);

/// How pictures of meshes are shown: pixel by pixel, or by the mean color of each triangle, for receivers that show no pictures.
enum class PictureUse { by_pixel, by_triangle };

/// Triangles of one color or picture, in the frame of their object.
struct VisualPart {
  geometry::TriangleMesh mesh;  ///< with places where it has a picture
  Color color;                  ///< multiplies the picture
  bool as_it_is = false;  ///< the color is that of a material or picture: gray does not mean the entity's own color
  PicturePtr picture{};   ///< null: none
};
/// The same triangles by the colors of the file's materials and by their pictures, where these count; else one part. `notes` gets lines
/// about what is not shown of them. Throws SetupError as visual_triangles().
[[nodiscard]] std::vector<VisualPart> visual_parts(const VisualMesh& mesh, MeshPictures& pictures, PictureUse use,
                                                   std::vector<std::string>& notes);

/// The files of all visual meshes of a model and of the pictures that its own file gives them, one for each use.
[[nodiscard]] std::vector<std::string> visual_files(const Model& model);

/// Triangles of one color or picture that move with an object.
struct SeenMesh {
  int object = 0;               ///< of the model
  geometry::TriangleMesh mesh;  ///< object frame
  Color color;
  bool as_it_is = false;  ///< VisualPart
  PicturePtr picture{};   ///< VisualPart
};

/// A shape other than a mesh.
struct SeenShape {
  int object = 0;  ///< of the model
  PlacedShape placed;
};

/// Parts to draw of a model.
struct Appearance {
  std::vector<SeenMesh> meshes;   ///< of visual meshes and convex polyhedra
  std::vector<SeenShape> shapes;  ///< all others
  double error = 0;               ///< [m] by which surfaces have moved, root mean square; 0: all triangles are there
  std::vector<std::string> warnings;  ///< one line each: meshes that could not be read and are left out
};

constexpr std::size_t usual_triangles = 3000;  ///< of the meshes of a robot in a camera's picture

/// An object with visual meshes is drawn as these, and as those of its shapes that do not collide; another one as
/// all of its shapes. The meshes of the whole model have at most `most` triangles together (geometry/mesh_reduction.h), but for uneven
/// ground, which keeps all of its own (collision/relief/relief.h). Reads files, which takes a while: keep the answer as long as the model.
[[nodiscard]] Appearance appearance_of(const Model& model, std::size_t most = usual_triangles);
/// The same with pictures that several models share.
[[nodiscard]] Appearance appearance_of(const Model& model, std::size_t most, MeshPictures& pictures, PictureUse use);

}  // namespace murosimf::appearance
