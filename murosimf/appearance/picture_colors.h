/// picture_colors.h - pictures of the materials of meshes, and mean colors of triangles from them.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/imaging/mip_picture.h"
#include "murosimf/robot_formats/mesh/mesh_file.h"

namespace murosimf::appearance {

using PicturePtr = std::shared_ptr<const imaging::MipPicture>;

/// Pictures of meshes; each file is read once.
class MeshPictures {
 public:
  /// `most_pixels`: of all pictures together, 4 bytes each; those beyond count as ones that cannot be read.
  explicit MeshPictures(std::size_t most_pixels = 64'000'000) : pixels_left_(most_pixels) {}
  /// A PNG or JPEG file; null if it cannot be read, with a line in `notes`.
  [[nodiscard]] PicturePtr read(const std::filesystem::path& file, std::vector<std::string>& notes);
  /// The picture that the file of a mesh names; null if there is none that can be read, with a line in `notes`. Read are .png, .jpg and
  /// .jpeg files in the folder of the mesh, in folders below it, and in folders beside it ("../textures/skin.png").
  [[nodiscard]] PicturePtr find(const std::filesystem::path& mesh, const std::string& name,
                                std::vector<std::string>& notes);
  /// By material of the mesh's file; null for those without a picture that can be read.
  [[nodiscard]] std::vector<PicturePtr> of_materials(const std::filesystem::path& mesh,
                                                     const robot_formats::mesh::MeshFile& file,
                                                     std::vector<std::string>& notes);

 private:
  std::map<std::filesystem::path, PicturePtr> pictures_;  // null: cannot be read
  std::size_t pixels_left_;
};

/// [1, sRGB] Mean of the light of a picture in a triangle, which the picture repeats under.
[[nodiscard]] Color mean_color(const imaging::ColorImage& picture, const robot_formats::mesh::PicturePlaces& places);

constexpr std::size_t most_picture_colors = 64;  ///< of the triangles of a mesh

/// By triangle: the mean color of the picture of its material in it, times the color of the material; nothing for those without a picture.
/// Colors are made a little coarser where there are more than `most_picture_colors`.
[[nodiscard]] std::vector<std::optional<Color>> picture_colors(const std::filesystem::path& mesh,
                                                               const robot_formats::mesh::MeshFile& file,
                                                               MeshPictures& pictures, std::vector<std::string>& notes);

/// The same of a picture for the whole mesh, times `color`; nothing at all for a mesh without places in pictures.
[[nodiscard]] std::vector<std::optional<Color>> picture_colors(const imaging::ColorImage& picture,
                                                               const robot_formats::mesh::MeshFile& file,
                                                               const Color& color);

}  // namespace murosimf::appearance
