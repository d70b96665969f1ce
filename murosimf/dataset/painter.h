/// painter.h - draws pictures of a data set, and writes their files.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "murosimf/dataset/arrangement.h"
#include "murosimf/dataset/folder.h"
#include "murosimf/dataset/normals.h"
#include "murosimf/dataset/viewpoint.h"
#include "murosimf/render/software_renderer.h"
#include "murosimf/sensors/camera_model.h"

namespace murosimf::dataset {

/// What all painters share.
struct Studio {
  const Stage* stage = nullptr;
  const Randomisation* randomisation = nullptr;
  const Folder* folder = nullptr;
  std::vector<imaging::LensSpec> lenses;
  std::uint64_t seed = 0;
  bool normals = false;
};

/// One for each thread.
class Painter {
 public:
  Painter(const Studio& studio, std::unique_ptr<render::SoftwareRenderer> renderer);

  /// Throws SetupError: a file that cannot be written.
  void paint(std::uint64_t picture);

 private:
  [[nodiscard]] const imaging::Image<Vec3d>& rays(std::size_t lens);
  void write_layers(std::uint64_t picture, std::size_t lens, const sensors::View& view, Dice& dice);

  const Studio* studio_;
  std::unique_ptr<render::SoftwareRenderer> renderer_;
  std::vector<int> yolo_classes_;
  std::map<std::size_t, sensors::CameraModel> keepers_;  // of maps of lenses, which take long to make
  std::map<std::size_t, imaging::Image<Vec3d>> rays_;
  sensors::CameraPicture picture_;
};

}  // namespace murosimf::dataset
