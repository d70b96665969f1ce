#include "murosimf/dataset/painter.h"

#include <cmath>

#include "murosimf/dataset/annotate.h"
#include "murosimf/dataset/frame_record.h"
#include "murosimf/dataset/jpeg_bytes.h"
#include "murosimf/dataset/random_camera.h"
#include "murosimf/dataset/random_light.h"
#include "murosimf/dataset/summary.h"
#include "murosimf/imaging/depth_numbers.h"
#include "murosimf/model/error.h"
#include "murosimf/render/png_bytes.h"

namespace murosimf::dataset {
namespace {

/// Depths and labels of a picture with motion blur are those of the middle of its first part (sensors/camera_model.h).
Viewpoint viewpoint_of(const sensors::CameraSpec& camera, const sensors::CameraMotion& motion) {
  const double ahead = 0.5 * camera.exposure_time / camera.motion_samples, rate = norm(motion.angular_velocity);
  Mat3d axes = motion.orientation;
  if (ahead * rate > 0) axes = rotation((1 / rate) * motion.angular_velocity, ahead * rate) * axes;
  return {imaging::Lens(camera.lens), motion.position + ahead * motion.velocity, axes * sensors::optical_axes};
}

}  // namespace

Painter::Painter(const Studio& studio, std::unique_ptr<render::SoftwareRenderer> renderer)
    : studio_(&studio), renderer_(std::move(renderer)), yolo_classes_(yolo_classes(studio.stage->categories())) {}

void Painter::paint(std::uint64_t picture) {
  const Studio& studio = *studio_;
  const Randomisation& r = *studio.randomisation;
  Dice dice(studio.seed, "picture", picture);
  const std::size_t lens = dice.one_of(studio.lenses.size());
  const sensors::CameraSpec camera = random_camera(r.sensor, studio.lenses[lens], dice);
  if (const auto [kept, is_new] =
          keepers_.try_emplace(lens, sensors::CameraSpec{.lens = camera.lens}, RandomStream(0, ""));
      is_new) {
    kept->second.open();
  }
  Arrangement arrangement = arrange(*studio.stage, r, imaging::Lens(camera.lens), studio.seed, picture);
  if (camera.exposure_time == 0) arrangement.motion.angular_velocity = {};
  const RandomLight light = random_light(r.light, r.field, dice);
  renderer_->set_light(light.light, static_cast<int>(r.picture.samples));
  const render::ShownMoment moment{&arrangement.frame, {}, arrangement.colors, arrangement.panels};
  renderer_->show(&moment);
  sensors::CameraModel model(camera, RandomStream(studio.seed, "dataset/pixels"));
  model.open();
  model.take(*renderer_, arrangement.motion, picture, picture_);
  const Viewpoint view = viewpoint_of(camera, arrangement.motion);
  const Annotated annotated = annotate(*studio.stage, arrangement, picture_.view, view, renderer_->scene(),
                                       static_cast<std::uint64_t>(r.picture.least_pixels));
  renderer_->show(nullptr);
  write_layers(picture, lens, picture_.view, dice);
  const Folder& folder = *studio.folder;
  folder.write(Folder::layer("instances", picture), render::png_bytes(annotated.instances));
  folder.write(Folder::layer("classes", picture), render::png_bytes(annotated.classes));
  folder.write(folder.yolo(picture),
               yolo_text(annotated.annotations, yolo_classes_, camera.lens.width, camera.lens.height));
  // last: with it the picture is complete
  folder.write(Folder::frame(picture), frame_json(folder, {picture, arrangement.camera, light.preset, studio.normals},
                                                  view, annotated.annotations));
}

void Painter::write_layers(std::uint64_t picture, std::size_t lens, const sensors::View& view, Dice& dice) {
  const PictureRanges& ranges = studio_->randomisation->picture;
  const Folder& folder = *studio_->folder;
  const int quality = static_cast<int>(std::lround(dice.in(ranges.jpeg_quality)));
  folder.write(folder.image(picture),
               ranges.format == "jpeg" ? jpeg_bytes(view.color, quality) : render::png_bytes(view.color));
  folder.write(Folder::layer("depth", picture), render::png_bytes(imaging::millimeters(view.depth)));
  if (studio_->normals) {
    folder.write(Folder::layer("normals", picture), render::png_bytes(normals_of(view.depth, view.labels, rays(lens))));
  }
}

const imaging::Image<Vec3d>& Painter::rays(std::size_t lens) {
  const auto known = rays_.find(lens);
  if (known != rays_.end()) return known->second;
  return rays_.emplace(lens, rays_of(imaging::Lens(studio_->lenses[lens]))).first->second;
}

}  // namespace murosimf::dataset
