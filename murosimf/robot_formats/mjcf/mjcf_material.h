/// mjcf_material.h - materials of an MJCF file, and the colors of its geoms.
///
/// A geom has the color of its own `rgba` where that is not the format's gray (0.5 0.5 0.5 1), else that of its material, or of the
/// material of its mesh. The mean color of a texture that the file makes itself multiplies that of the material; one from a file of type "2d"
/// colors meshes for the eye, repeated as `texrepeat` says from its upper left corner on, as MuJoCo draws it; no other texture is drawn.
/// Source: MuJoCo documentation, XML reference, "asset/material" and "geom".
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>

#include "murosimf/model/shape.h"
#include "murosimf/robot_formats/mjcf/mjcf_defaults.h"
#include "murosimf/robot_formats/mjcf/mjcf_frame.h"

namespace murosimf::robot_formats::mjcf {

class MjcfMaterials {
 public:
  /// Throws SetupError for a material without a name or with a taken one.
  MjcfMaterials(const std::filesystem::path& file, const files::XmlElement& root, const MjcfDefaults& defaults,
                const MjcfCompiler& compiler);

  /// The color of a geom. `of_mesh`: material of the geom's mesh, or empty. Throws SetupError for an unknown material.
  [[nodiscard]] Color color_of(const MjcfAttributes& geom, const std::string& of_mesh = {}) const;
  struct Picture {
    std::filesystem::path file;          ///< empty: none
    std::array<double, 2> repeat{1, 1};  ///< VisualMesh
  };
  /// The picture of a geom that is a mesh. Throws SetupError likewise.
  [[nodiscard]] Picture picture_of(const MjcfAttributes& geom, const std::string& of_mesh) const;

 private:
  struct Material {
    Color color;
    Picture picture;
  };
  [[nodiscard]] const Material* find(const MjcfAttributes& geom, const std::string& of_mesh) const;

  std::map<std::string, Material, std::less<>> materials_;
};

}  // namespace murosimf::robot_formats::mjcf
