/// mjcf_texture.h - textures of an MJCF file: mean colors of those that it defines itself (`builtin`), the color of a geom from afar, and files
/// of the others.
///
/// flat is rgb1, checker and gradient are half rgb1 and half rgb2. Textures from files have no mean color here: they are read when a mesh
/// is drawn that has places for them (type "2d"); others are not.
/// Source: MuJoCo documentation, XML reference, "texture".
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/files/xml_element.h"
#include "murosimf/model/shape.h"
#include "murosimf/robot_formats/mjcf/mjcf_frame.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats::mjcf {

class MjcfTextures {
 public:
  /// Reads all textures of the file `file`. Throws SetupError for impossible colors.
  MjcfTextures(const std::filesystem::path& file, const files::XmlElement& root, const MjcfCompiler& compiler);

  /// [1] Red, green, blue of a texture; nothing if it comes from a file. Throws SetupError for an unknown one, at `user`.
  [[nodiscard]] std::optional<Vec3d> mean_color(const std::string& name, const files::XmlElement& user) const;
  /// The file of a texture of type "2d"; empty for others. Throws SetupError for an unknown one, at `user`.
  [[nodiscard]] std::filesystem::path picture(const std::string& name, const files::XmlElement& user) const;

 private:
  struct Texture {
    std::optional<Vec3d> mean;
    std::filesystem::path picture;
  };
  [[nodiscard]] const Texture& find(const std::string& name, const files::XmlElement& user) const;

  std::map<std::string, Texture> textures_;
};

/// Names the kinds of textures from files that no picture shows.
void name_undrawn_textures(const files::XmlElement& root, std::vector<robot_formats::Unused>& unused);

}  // namespace murosimf::robot_formats::mjcf
