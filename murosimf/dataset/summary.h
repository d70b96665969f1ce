/// summary.h - files of a data set that are of all its pictures: COCO's annotations, YOLO's data.yaml.
#pragma once

#include "murosimf/dataset/folder.h"
#include "murosimf/dataset/stage.h"

namespace murosimf::dataset {

/// YOLO's numbers 0, 1, ... by category; -1: it has none, as the ground, whose box is the picture.
[[nodiscard]] std::vector<int> yolo_classes(const std::vector<Category>& categories);

/// Writes annotations.json, annotations_train.json, annotations_val.json and data.yaml of the first `pictures`, which are all there. Throws
/// SetupError.
void write_summary(const Folder& folder, const std::vector<Category>& categories, std::uint64_t pictures);

}  // namespace murosimf::dataset
