/// folder.h - files of a data set by number of the picture.
///
///     images/train/000012.jpg     colors              depth/000012.png    [mm], 16 bits       labels/train/000012.txt   YOLO
///     instances/000012.png        16 bits             classes/000012.png  8 bits              frames/000012.json        all that is known
///     normals/000012.png          if wanted           manifest.json, annotations*.json, data.yaml
///
/// A picture is complete when its file in frames is there.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace murosimf::dataset {

class Folder {
 public:
  /// `validation`: share of pictures that are not for training, chosen by the seed.
  Folder(std::filesystem::path root, std::string extension, double validation, std::uint64_t seed)
      : root_(std::move(root)), extension_(std::move(extension)), validation_(validation), seed_(seed) {}

  [[nodiscard]] const std::filesystem::path& root() const { return root_; }
  // Make what is missing: the root, which gets its manifest first; then all others. Throw SetupError: cannot make 'folder': reason.
  void make_root() const;
  void make(bool normals) const;

  /// Removes half-written files of a call that was killed, of the names that files::PartFile gives them, as far as that is possible. Other
  /// folders are left alone.
  void remove_parts() const;

  /// "train" or "val".
  [[nodiscard]] const char* part_of(std::uint64_t picture) const;
  // Names in the root.
  [[nodiscard]] std::string image(std::uint64_t picture) const;
  [[nodiscard]] std::string yolo(std::uint64_t picture) const;
  /// `kind`: "depth", "instances", "classes", "normals".
  [[nodiscard]] static std::string layer(const char* kind, std::uint64_t picture);
  [[nodiscard]] static std::string frame(std::uint64_t picture);

  /// Those of the first `pictures` that are not complete.
  [[nodiscard]] std::vector<std::uint64_t> missing(std::uint64_t pictures) const;
  /// Throws SetupError.
  void write(const std::string& name, const std::string& bytes) const;
  /// The same for a file that this command has read.
  void replace(const std::string& name, const std::string& bytes) const;

 private:
  std::filesystem::path root_;
  std::string extension_;
  double validation_;
  std::uint64_t seed_;
};

}  // namespace murosimf::dataset
