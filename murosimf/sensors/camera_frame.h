/// camera_frame.h - what a camera shows: its last picture, with the instant at which that was exposed.
///
///     const sensors::CameraFrame& frame = sensors::read_frame(setup, "camera");   // an algorithm, in its constructor
///     if (frame.number != last_) look_at(frame.color, frame.info->lens);    // in its step
///
/// A camera draws only if its frames are requested: an algorithm that reads them, want_frames, or `always_on` in the
/// robot's or scene's file; or while they are asked for (offer_frames). Frames are no part of the state hash: looking
/// changes nothing.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/imaging/image.h"
#include "murosimf/imaging/lens.h"
#include "murosimf/world/setup.h"

namespace murosimf::sensors {

struct CameraSpec;  // camera_spec.h

/// What does not change while a camera runs.
struct CameraInfo {
  std::string name{};                 ///< unique on its robot
  imaging::Lens lens;                 ///< the true one
  Duration period{};                  ///< between two frames
  int link = 0;                       ///< object that it moves with: a base or joint
  Vec3d position;                     ///< [m] of the pinhole in the frame of the link, true
  Mat3d orientation;                  ///< optical axes to those of the link, true: with the mounting error
  Mat3d nominal;                      ///< the same without the error, as control software may believe it
  std::vector<std::string> labels{};  ///< names of what LabelImages show (view_source.h)
  bool has_color = true, has_depth = false, has_labels = false;
  std::string mosaic{};                      ///< Bayer pattern, "rggb"; empty: none
  std::shared_ptr<const CameraSpec> spec{};  ///< complete, for other producers of its pictures (camera_model.h)
};

/// Layers that the camera does not have are empty.
struct CameraFrame {
  Duration time{};           ///< simulated, at which the exposure of its first row began; it may have come later
  std::uint64_t number = 0;  ///< of its sample, from 1, also if samples before were not drawn; 0: none has come
  imaging::ColorImage color{};
  imaging::GrayImage mosaic{};  ///< behind a Bayer filter; then there are no colors
  imaging::DepthImage depth{};  ///< [m] along the optical axis, infinite where nothing is
  imaging::LabelImage labels{};
  std::shared_ptr<const CameraInfo> info{};
  bool wanted = false;           ///< its frames are requested
  bool offered = false;          ///< they may be asked for
  bool asked = false;            ///< they are drawn at present, if offered; may change between two steps
  bool draws = false;            ///< of its last sample, or as it starts: a frame comes of it
  std::function<void()> heed{};  ///< its camera takes note of the above: of requests that come after its start
};

void append_hash(Hasher& hasher, const CameraFrame& frame);
void state(StateArchive& archive, CameraFrame& frame);
/// Of its instant and all pixels. The same for any number of threads.
[[nodiscard]] std::uint64_t hash_of(const CameraFrame& frame);

/// For the camera itself: creates its frame. Throws SetupError if the robot has a camera of that name.
[[nodiscard]] CameraFrame& write_frame(Setup& setup, CameraInfo info);

/// For algorithms of the robot, in their constructors; the camera draws from then on. It must be attached before. Throws
/// SetupError with the nearest name if there is none.
[[nodiscard]] const CameraFrame& read_frame(Setup& setup, std::string_view camera);

/// From outside, before the simulation is initialized or between two steps: the camera draws from then on, also after a reset. Throws SetupError
/// with the nearest name.
const CameraFrame& want_frames(Entity& entity, std::string_view camera);

/// From outside, at the same times: the camera draws while `asked` is set, for observers that come and go.
/// Pictures are those of a camera that draws all the time. Throws SetupError with the nearest name.
CameraFrame& offer_frames(Entity& entity, std::string_view camera);

/// Those of all cameras of an entity, in the order of their names.
[[nodiscard]] std::vector<const CameraFrame*> frames_of(const Entity& entity);

}  // namespace murosimf::sensors
