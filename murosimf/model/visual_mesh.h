/// visual_mesh.h - visual meshes of a model: their files and places, not their contents.
///
/// No physics depends on them, so no file is opened before the model is drawn (appearance/visual_meshes.h);
/// only then a missing file is an error.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "murosimf/math/mat3.h"
#include "murosimf/model/property.h"
#include "murosimf/model/shape.h"

namespace murosimf {

/// A mesh on an object. A vertex v of the file stands at
///
///     position + orientation * (scale * (file_orientation^T (v - file_position)))
///
/// in the object's frame; `scale` multiplies each of the three numbers.
struct VisualMesh {
  std::string file;        ///< path of an STL, OBJ or COLLADA file
  Vec3d scale{1, 1, 1};    ///< [1]
  Vec3d file_position;     ///< [m] of the mesh frame, in the file's frame
  Mat3d file_orientation;  ///< mesh axes to the file's axes
  Vec3d position;          ///< [m] of the mesh frame, in the object's frame
  Mat3d orientation;       ///< mesh axes to the object's axes
  Color color;
  bool mesh_colors = false;  ///< the materials of the file count, where it has some
  std::string picture{};     ///< path of the picture that colors it, instead of its materials; empty: none
  std::array<double, 2> picture_repeat{
      1, 1};  ///< [1] how often it stands where the file has it once, to the right and down
};

using Visuals = std::vector<VisualMesh>;

namespace properties {

inline constexpr Property<Visuals> visuals{{"visuals", "m", "object", "visual meshes, by their files"}};

}  // namespace properties
}  // namespace murosimf
