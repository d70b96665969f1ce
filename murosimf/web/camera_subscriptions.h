/// camera_subscriptions.h - pictures of any camera of a running scene, for observers.
///
///     CameraSubscriptions cameras(session);
///     cameras.want({"blue1.camera"});                  // from now on; others are unsubscribed
///     if (const auto seen = cameras.seen("blue1.camera")) show(*seen->frame);
///
/// A camera that draws for itself (control software reads it, `always_on`) provides its own pictures. Any other is drawn
/// here: with its lens, blur, exposure, noise and mosaic (sensors/camera_model.h), of the present poses, without effects that take time:
/// exposure, rolling shutter, delay. That is done in a separate thread, from copies of poses, so the simulation is not
/// affected; it waits for copies only, and once for a renderer. Without subscriptions nothing is done, and no thread is started.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "murosimf/sensors/camera_frame.h"
#include "murosimf/session/session.h"

namespace murosimf::web {

struct SeenPicture {
  std::uint64_t number = 0;                           ///< of pictures of this camera so far; changes with each new one
  std::shared_ptr<const sensors::CameraFrame> frame;  ///< null: none yet
  bool own = false;                                   ///< it draws for itself
  std::string trouble{};                              ///< reason why there is no picture, in one line; empty: no error
};

class CameraSubscriptions {
 public:
  /// The session must outlive it.
  explicit CameraSubscriptions(session::Session& session);
  ~CameraSubscriptions();
  CameraSubscriptions(const CameraSubscriptions&) = delete;
  CameraSubscriptions& operator=(const CameraSubscriptions&) = delete;

  /// Cameras by "ROBOT.CAMERA". One thread.
  void want(const std::set<std::string>& cameras);
  /// The last picture of a subscribed camera; nothing: not drawn yet.
  [[nodiscard]] std::optional<SeenPicture> seen(const std::string& camera) const;
  /// Number of pictures drawn here so far.
  [[nodiscard]] std::uint64_t drawn() const;

 private:
  struct Found;
  struct Visit;
  struct Eye;
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

/// Throws SetupError with the nearest name if there is no such camera. Between two steps.
void check_camera(const scene::Scene& scene, const std::string& camera);

}  // namespace murosimf::web
