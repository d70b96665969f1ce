#include "murosimf/recording/recorded_picture.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "murosimf/imaging/depth_numbers.h"
#include "murosimf/imaging/lens_fit.h"
#include "murosimf/math/assert.h"
#include "murosimf/recording/foxglove_messages.h"
#include "murosimf/recording/frame_writer.h"
#include "murosimf/render/image_png.h"

namespace murosimf::recording {
namespace {

/// foxglove.CompressedImage
std::string message_of(const RecordedCamera& camera, const CameraPicture& picture) {
  std::string bytes;
  ProtobufWriter out(bytes);
  put_time(out, 1, picture.taken);
  out.bytes(2, render::image_png(picture.mosaic.empty() ? picture.color : render::shown(picture.mosaic)));
  out.text(3, "png");
  out.text(4, camera.frame);
  return bytes;
}

/// foxglove.RawImage, of little-endian numbers
std::string message_of(const RecordedCamera& camera, Duration taken, const imaging::NumberImage& image) {
  std::string bytes, numbers;
  numbers.reserve(2 * image.pixels().size());
  for (const std::uint16_t number : image.pixels()) {
    numbers += static_cast<char>(number & 255);
    numbers += static_cast<char>(number >> 8);
  }
  ProtobufWriter out(bytes);
  put_time(out, 1, taken);
  out.fixed32(2, static_cast<std::uint32_t>(image.width()));
  out.fixed32(3, static_cast<std::uint32_t>(image.height()));
  out.text(4, "16UC1");
  out.fixed32(5, 2 * static_cast<std::uint32_t>(image.width()));
  out.bytes(6, numbers);
  out.text(7, camera.frame);
  return bytes;
}

/// The fields of foxglove.CameraCalibration except its time.
std::string calibration_of(const RecordedCamera& camera) {
  const Distortion told = distortion_of(camera.shown->info->lens);
  const imaging::LensSpec& lens = told.lens;
  std::string bytes;
  ProtobufWriter out(bytes);
  out.fixed32(2, static_cast<std::uint32_t>(lens.width));
  out.fixed32(3, static_cast<std::uint32_t>(lens.height));
  out.text(4, told.model);
  out.packed_numbers(5, told.coefficients);
  out.packed_numbers(6, std::array{lens.fx, lens.skew, lens.cx, 0.0, lens.fy, lens.cy, 0.0, 0.0, 1.0});
  out.packed_numbers(7, std::array{1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0});
  out.packed_numbers(8, std::array{lens.fx, lens.skew, lens.cx, 0.0, 0.0, lens.fy, lens.cy, 0.0, 0.0, 0.0, 1.0, 0.0});
  out.text(9, camera.frame);
  return bytes;
}

/// The fields of foxglove.FrameTransform except its time.
std::string place_of(const RecordedCamera& camera) {
  const sensors::CameraInfo& info = *camera.shown->info;
  std::string bytes;
  ProtobufWriter out(bytes);
  out.text(2, camera.link);
  out.text(3, camera.frame);
  put_vector(out, 4, rounded(info.position, pose_step));
  put_rotation(out, 5, info.orientation);
  return bytes;
}

/// The field `timestamp`, with which each of them begins.
std::string stamp(Duration time) {
  std::string bytes;
  ProtobufWriter out(bytes);
  put_time(out, 1, time);
  return bytes;
}

}  // namespace

Distortion distortion_of(const imaging::Lens& lens) {
  constexpr std::size_t plane = 5, angles = 4;  // numbers of coefficients that readers expect
  Distortion told{lens.spec().model, lens.spec().coefficients, lens.spec()};
  // a lens by table has no model of OpenCV: the nearest equidistant one is recorded
  if (told.model == "ray_polynomial") {
    told.lens = imaging::fit_lens(lens, "equidistant").spec;
    told.coefficients = told.lens.coefficients;
    told.model = "equidistant";
  }
  if (told.model == "perspective") told.model = "plumb_bob";
  if (told.model == "plumb_bob") told.coefficients.resize(plane);
  if (told.model == "equidistant") {
    told.model = "kannala_brandt";
    told.coefficients.resize(angles);
  }
  return told;
}

/// Cameras are drawn only if something reads them: the recording does.
void want_pictures(World& world) {
  for (const auto& entity : world.entities()) want_pictures(*entity);
}

void want_pictures(Entity& entity) {
  for (const sensors::CameraFrame* frame : sensors::frames_of(entity)) {
    (void)sensors::want_frames(entity, frame->info->name);
  }
}

void offer_pictures(World& world) {
  for (const auto& entity : world.entities()) {
    for (const sensors::CameraFrame* frame : sensors::frames_of(*entity)) {
      (void)sensors::offer_frames(*entity, frame->info->name);
    }
  }
}

std::vector<RecordedCamera> recorded_cameras(const std::vector<RecordedEntity>& entities) {
  std::vector<RecordedCamera> cameras;
  add_cameras_of(entities, cameras);
  return cameras;
}

/// Cameras are placed relative to the link that carries them.
void add_cameras_of(std::span<const RecordedEntity> entities, std::vector<RecordedCamera>& cameras) {
  for (const RecordedEntity& one : entities) {
    for (const sensors::CameraFrame* frame : sensors::frames_of(*one.entity)) {
      const auto link = std::ranges::find(one.links, frame->info->link, &RecordedEntity::Link::object);
      if (link == one.links.end()) continue;
      cameras.push_back({.topic = fmt::format("/cameras/{}/{}", one.name, frame->info->name),
                         .frame = fmt::format("{}/{}/optical", one.name, frame->info->name),
                         .link = link->frame,
                         .shown = frame});
    }
  }
}

void take_pictures(std::vector<RecordedCamera>& cameras, RecordedFrame& frame) {
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    const sensors::CameraFrame& shown = *cameras[i].shown;
    if (shown.number == cameras[i].number) continue;
    cameras[i].number = shown.number;
    if (shown.color.empty() && shown.mosaic.empty() && shown.depth.empty() && shown.labels.empty())
      continue;  // drawing is impossible here
    frame.pictures.push_back({.camera = i,
                              .taken = shown.time,
                              .color = shown.color,
                              .mosaic = shown.mosaic,
                              .depth = imaging::millimeters(shown.depth),
                              .labels = shown.labels});
  }
}

PictureWriter::PictureWriter(MessageSink& file, FrameWriter& frames, const std::vector<RecordedCamera>& cameras,
                             const std::optional<std::string>& label_table)
    : file_(file), frames_(frames), cameras_(cameras) {
  meet_newcomers(label_table);
}

void PictureWriter::meet_newcomers(const std::optional<std::string>& label_table) {
  if (told_.empty() && !cameras_.empty()) transforms_ = frames_.add_channel("/cameras/tf", "foxglove.FrameTransforms");
  while (told_.size() < cameras_.size()) {
    const RecordedCamera& camera = cameras_[told_.size()];
    const sensors::CameraInfo& info = *camera.shown->info;
    Told told{.calibration = frames_.add_channel(camera.topic + "/calibration", "foxglove.CameraCalibration"),
              .calibrated = calibration_of(camera),
              .placed = place_of(camera)};
    if (info.has_color || !info.mosaic.empty())
      told.picture = frames_.add_channel(camera.topic + "/image", "foxglove.CompressedImage");
    if (label_table && info.has_depth) told.depth = frames_.add_channel(camera.topic + "/depth", "foxglove.RawImage");
    if (label_table && info.has_labels)
      told.labels = frames_.add_channel(camera.topic + "/labels", "foxglove.RawImage", {{"labels", *label_table}});
    told_.push_back(std::move(told));
  }
}

void PictureWriter::write(const RecordedFrame& frame) {
  for (const CameraPicture& picture : frame.pictures) {
    MUROSIMF_ASSERT(picture.camera < told_.size());
    const Told& told = told_[picture.camera];
    const std::string time = stamp(picture.taken);
    std::string placed;
    ProtobufWriter(placed).bytes(1, time + told.placed);
    file_.write(transforms_, frame.time, placed);
    file_.write(told.calibration, frame.time, time + told.calibrated);
    const RecordedCamera& camera = cameras_[picture.camera];
    if (told.picture) file_.write(*told.picture, frame.time, message_of(camera, picture));
    if (told.depth) file_.write(*told.depth, frame.time, message_of(camera, picture.taken, picture.depth));
    if (told.labels) file_.write(*told.labels, frame.time, message_of(camera, picture.taken, picture.labels));
  }
}

}  // namespace murosimf::recording
