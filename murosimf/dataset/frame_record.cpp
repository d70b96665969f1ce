#include "murosimf/dataset/frame_record.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace murosimf::dataset {
namespace {

using nlohmann::json;

/// To a thousandth of a pixel: more is noise of the projection, and long.
double rounded(double pixels) { return std::round(1000 * pixels) / 1000; }

json vector_of(const Vec3d& v) { return {v.x, v.y, v.z}; }

/// Rows of the matrix.
json matrix_of(const Mat3d& m) { return {{m.x.x, m.y.x, m.z.x}, {m.x.y, m.y.y, m.z.y}, {m.x.z, m.y.z, m.z.z}}; }

json box_of(const PixelBox& box) {
  return {rounded(box.left), rounded(box.top), rounded(box.right - box.left), rounded(box.bottom - box.top)};
}

json camera_of(const FrameRecord& record, const Viewpoint& view) {
  const imaging::LensSpec& lens = view.lens.spec();
  return {{"name", record.camera},
          {"model", lens.model},
          {"K", {{lens.fx, lens.skew, lens.cx}, {0, lens.fy, lens.cy}, {0, 0, 1}}},
          {"distortion", lens.coefficients},
          {"position", vector_of(view.eye)},
          {"rotation", matrix_of(view.axes)},
          {"frames", "rotation: optical axes (x right, y down, z forward) to world axes (z up); position: world, m"}};
}

json image_of(const Folder& folder, const FrameRecord& record, const Viewpoint& view) {
  json image{{"id", record.picture + 1},
             {"file_name", folder.image(record.picture)},
             {"width", view.lens.spec().width},
             {"height", view.lens.spec().height},
             {"part", folder.part_of(record.picture)},
             {"depth", Folder::layer("depth", record.picture)},
             {"instances", Folder::layer("instances", record.picture)},
             {"classes", Folder::layer("classes", record.picture)},
             {"light", record.light},
             {"camera", camera_of(record, view)}};
  if (record.normals) image["normals"] = Folder::layer("normals", record.picture);
  return image;
}

json annotation_of(const Annotation& annotation, const imaging::LensSpec& lens) {
  json one{{"category_id", annotation.category},
           {"instance", annotation.instance},
           {"name", annotation.name},
           {"bbox", box_of(annotation.box)},
           {"bbox_full", annotation.full ? box_of(*annotation.full) : json()},
           {"area", annotation.area},
           {"iscrowd", 0},
           {"segmentation", {{"size", {lens.height, lens.width}}, {"counts", annotation.runs}}}};
  if (annotation.pose) {
    one["position"] = vector_of(annotation.pose->position);
    one["rotation"] = matrix_of(annotation.pose->orientation);
  }
  if (annotation.own) one["own"] = true;
  if (annotation.keypoints.empty()) return one;
  json keypoints = json::array();
  int count = 0;
  for (const Keypoint& point : annotation.keypoints) {
    const bool there = point.seen != Seen::not_at_all;
    keypoints.push_back(there ? rounded(point.pixel.u) : 0.0);
    keypoints.push_back(there ? rounded(point.pixel.v) : 0.0);
    keypoints.push_back(static_cast<int>(point.seen));
    count += there ? 1 : 0;
  }
  one["keypoints"] = std::move(keypoints);
  one["num_keypoints"] = count;
  return one;
}

}  // namespace

std::string frame_json(const Folder& folder, const FrameRecord& record, const Viewpoint& view,
                       const std::vector<Annotation>& annotations) {
  json frame{{"image", image_of(folder, record, view)}, {"annotations", json::array()}};
  for (const Annotation& one : annotations) frame["annotations"].push_back(annotation_of(one, view.lens.spec()));
  return frame.dump() + "\n";
}

std::string yolo_text(const std::vector<Annotation>& annotations, const std::vector<int>& class_of, int width,
                      int height) {
  std::string text;
  for (const Annotation& one : annotations) {
    const int number = class_of.at(one.category);
    if (number < 0 || one.own) continue;
    const PixelBox& box = one.box;
    text += fmt::format("{} {:.6f} {:.6f} {:.6f} {:.6f}\n", number, 0.5 * (box.left + box.right) / width,
                        0.5 * (box.top + box.bottom) / height, (box.right - box.left) / width,
                        (box.bottom - box.top) / height);
  }
  return text;
}

}  // namespace murosimf::dataset
