/// recorded_picture.h - what cameras show, as Foxglove's messages: pictures (PNG), calibrations, and where cameras are on their robots.
///
/// | topic | message |
/// |---|---|
/// | `/cameras/ROBOT/CAMERA/image` | foxglove.CompressedImage: colors, or the mosaic in shades of gray |
/// | `/cameras/ROBOT/CAMERA/calibration` | foxglove.CameraCalibration, with every picture |
/// | `/cameras/tf` | foxglove.FrameTransforms: the camera's optical frame on its link, with every picture |
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "murosimf/model/world.h"
#include "murosimf/recording/mcap/message_sink.h"
#include "murosimf/recording/recorded_frame.h"
#include "murosimf/sensors/camera_frame.h"

namespace murosimf::recording {

/// A camera whose pictures are recorded.
struct RecordedCamera {
  std::string topic;  ///< "/cameras/blue1/camera"
  std::string frame;  ///< of transforms: its optical axes, "blue1/camera/optical"
  std::string link;   ///< what it moves with: "blue1/head"
  const sensors::CameraFrame* shown = nullptr;
  std::uint64_t number = 0;  ///< of its frames that are recorded
};

/// Before the scene is initialized: all cameras draw from then on, which changes no result.
void want_pictures(World& world);
/// Those that have colors or a mosaic.
[[nodiscard]] std::vector<RecordedCamera> recorded_cameras(const std::vector<RecordedEntity>& entities);

/// Adds the pictures that have come since the last time.
void take_pictures(std::vector<RecordedCamera>& cameras, RecordedFrame& frame);

class FrameWriter;

/// Writes their messages beside a FrameWriter's.
class PictureWriter {
 public:
  /// All of it outlives the writer.
  PictureWriter(MessageSink& file, FrameWriter& frames, const std::vector<RecordedCamera>& cameras);
  void write(const RecordedFrame& frame);

 private:
  struct Told {
    std::uint16_t picture = 0, calibration = 0;  // channels
    std::string calibrated, placed;              // messages, without their time
  };
  MessageSink& file_;
  const std::vector<RecordedCamera>& cameras_;
  std::vector<Told> told_;  // by camera
  std::uint16_t transforms_ = 0;
};

}  // namespace murosimf::recording
