/// annotation.h - what one picture says about each thing that is seen in it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/dataset/projected_box.h"
#include "murosimf/imaging/image.h"
#include "murosimf/math/transform.h"

namespace murosimf::dataset {

/// As COCO counts: not in the picture, in the picture behind something, seen.
enum class Seen { not_at_all, hidden, seen };

struct Keypoint {
  imaging::Pixel pixel{};  ///< imaging/image.h
  Seen seen = Seen::not_at_all;
};

struct Annotation {
  std::uint16_t instance = 0, category = 0;
  std::string name;              ///< "blue1"
  bool own = false;              ///< the robot that carries the camera: its arms and feet are seen
  PixelBox box;                  ///< of the pixels that show it
  std::optional<PixelBox> full;  ///< of all of it (ProjectedBox)
  std::uint64_t area = 0;        ///< [px] that show it
  std::string runs;              ///< mask (run_lengths.h)
  std::vector<Keypoint> keypoints;
  std::optional<Transformd> pose;  ///< [m] of its base in the world; nothing: it is the field's
};

struct Annotated {
  std::vector<Annotation> annotations;
  imaging::NumberImage instances;  ///< of each pixel; 0: none
  imaging::GrayImage classes;      ///< of each pixel (stage.h)
};

}  // namespace murosimf::dataset
