/// mjcf_material.h - materials of an MJCF file, and the colors of its geoms.
///
/// A geom has the color of its own `rgba` where that is not the format's gray (0.5 0.5 0.5 1), else that of its material, or of the
/// material of its mesh. Textures are not drawn; the mean color of one that the file makes itself multiplies that of the material.
/// Source: MuJoCo documentation, XML reference, "asset/material" and "geom".
#pragma once

#include <map>
#include <string>

#include "murosimf/model/shape.h"
#include "murosimf/robot_formats/mjcf/mjcf_defaults.h"

namespace murosimf::robot_formats::mjcf {

class MjcfMaterials {
 public:
  /// Throws SetupError for a material without a name or with a taken one.
  MjcfMaterials(const files::XmlElement& root, const MjcfDefaults& defaults);

  /// The color of a geom. `of_mesh`: material of the geom's mesh, or empty. Throws SetupError for an unknown material.
  [[nodiscard]] Color color_of(const MjcfAttributes& geom, const std::string& of_mesh = {}) const;

 private:
  std::map<std::string, Color, std::less<>> colors_;
};

}  // namespace murosimf::robot_formats::mjcf
