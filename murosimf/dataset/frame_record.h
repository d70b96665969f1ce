/// frame_record.h - the file of one picture: its image and its annotations, as COCO has them.
#pragma once

#include <string>

#include "murosimf/dataset/annotation.h"
#include "murosimf/dataset/folder.h"

namespace murosimf::dataset {

/// What is written of a picture besides its layers.
struct FrameRecord {
  std::uint64_t picture = 0;
  std::string camera;  ///< "blue1.camera"; empty: a free one
  std::string light;   ///< preset
  bool normals = false;
};

/// JSON: {"image": {...}, "annotations": [...]}.
[[nodiscard]] std::string frame_json(const Folder& folder, const FrameRecord& record, const Viewpoint& view,
                                     const std::vector<Annotation>& annotations);

/// YOLO: a line for each thing, "class x y width height", of its visible box as shares of the picture. `class_of`: 0, 1, ... by category;
/// below 0: it is left out, as is
/// the body of the robot that carries the camera.
[[nodiscard]] std::string yolo_text(const std::vector<Annotation>& annotations, const std::vector<int>& class_of,
                                    int width, int height);

}  // namespace murosimf::dataset
