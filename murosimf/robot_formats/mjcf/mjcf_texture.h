/// mjcf_texture.h - mean colors of the textures that an MJCF file defines itself (`builtin`): the color of a geom from afar.
///
/// flat is rgb1, checker and gradient are half rgb1 and half rgb2. Textures from files have no mean color here: they are not read.
/// Source: MuJoCo documentation, XML reference, "texture".
#pragma once

#include <map>
#include <optional>
#include <string>

#include "murosimf/files/xml_element.h"
#include "murosimf/model/shape.h"

namespace murosimf::robot_formats::mjcf {

class MjcfTextures {
 public:
  /// Reads all textures of the file. Throws SetupError for impossible colors.
  explicit MjcfTextures(const files::XmlElement& root);

  /// [1] Red, green, blue of a texture; nothing if it comes from a file. Throws SetupError for an unknown one, at `user`.
  [[nodiscard]] std::optional<Vec3d> mean_color(const std::string& name, const files::XmlElement& user) const;

 private:
  std::map<std::string, std::optional<Vec3d>> colors_;
};

}  // namespace murosimf::robot_formats::mjcf
