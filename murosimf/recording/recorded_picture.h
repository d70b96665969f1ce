/// recorded_picture.h - pictures of cameras as Foxglove's messages: pictures (PNG), calibrations, and places of cameras on their robots.
///
/// | topic | message |
/// |---|---|
/// | `/cameras/ROBOT/CAMERA/image` | foxglove.CompressedImage: colors, or the mosaic in shades of gray |
/// | `/cameras/ROBOT/CAMERA/depth` | foxglove.RawImage, 16UC1: [mm] along the optical axis, 0: nothing (imaging/depth_numbers.h) |
/// | `/cameras/ROBOT/CAMERA/labels` | foxglove.RawImage, 16UC1; their meaning is in the metadata of the channel, as JSON |
/// | `/cameras/ROBOT/CAMERA/calibration` | foxglove.CameraCalibration, with every picture |
/// | `/cameras/tf` | foxglove.FrameTransforms: the camera's optical frame on its link, with every picture |
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "murosimf/imaging/lens.h"
#include "murosimf/recording/mcap/message_sink.h"
#include "murosimf/recording/recorded_frame.h"
#include "murosimf/sensors/camera_frame.h"
#include "murosimf/world/world.h"

namespace murosimf::recording {

/// A camera with recorded pictures.
struct RecordedCamera {
  std::string topic;  ///< "/cameras/blue1/camera"
  std::string frame;  ///< of transforms: its optical axes, "blue1/camera/optical"
  std::string link;   ///< link that it is mounted on: "blue1/head"
  const sensors::CameraFrame* shown = nullptr;
  std::uint64_t number = 0;  ///< of its last recorded frame
};

/// Distortion by a model of OpenCV, as Foxglove and ROS expect.
struct Distortion {
  std::string model;  ///< "plumb_bob", "rational_polynomial", "kannala_brandt"
  std::vector<double> coefficients;
  imaging::LensSpec lens;  ///< that it belongs to: a lens by table becomes the nearest equidistant one
};
[[nodiscard]] Distortion distortion_of(const imaging::Lens& lens);

/// Before the scene is initialized: requests pictures of all cameras, which changes no result.
void want_pictures(World& world);
void want_pictures(Entity& entity);
/// The same of cameras that draw only while their frames are asked for (camera_frame.h).
void offer_pictures(World& world);
[[nodiscard]] std::vector<RecordedCamera> recorded_cameras(const std::vector<RecordedEntity>& entities);
void add_cameras_of(std::span<const RecordedEntity> entities, std::vector<RecordedCamera>& cameras);

/// Adds the pictures since the last call.
void take_pictures(std::vector<RecordedCamera>& cameras, RecordedFrame& frame);

class FrameWriter;

/// Writes their messages along with those of a FrameWriter.
class PictureWriter {
 public:
  /// `label_table`: as JSON (scene/scene_labels.h); nothing: neither depths nor labels are written. All other arguments outlive the writer.
  PictureWriter(MessageSink& file, FrameWriter& frames, const std::vector<RecordedCamera>& cameras,
                const std::optional<std::string>& label_table = {});
  void write(const RecordedFrame& frame);
  /// Channels of cameras that have come since.
  void meet_newcomers(const std::optional<std::string>& label_table = {});

 private:
  struct Told {
    std::uint16_t calibration = 0;
    std::optional<std::uint16_t> picture, depth, labels;  // channels of existing layers
    std::string calibrated, placed;                       // messages without time
  };
  MessageSink& file_;
  FrameWriter& frames_;
  const std::vector<RecordedCamera>& cameras_;
  std::vector<Told> told_;  // by camera
  std::uint16_t transforms_ = 0;
};

}  // namespace murosimf::recording
