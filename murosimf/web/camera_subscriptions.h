/// camera_subscriptions.h - pictures of any camera of a running scene, for who looks on.
///
///     CameraSubscriptions cameras(session);
///     cameras.want({"blue1.camera"});                  // from now on; others are no longer looked through
///     if (const auto seen = cameras.seen("blue1.camera")) show(*seen->frame);
///
/// A camera that draws for itself (control software reads it, `always_on`) shows the pictures that it has. Any other is looked through
/// here: its lens, blur, exposure, noise and mosaic (sensors/camera_model.h), of where everything is at this moment, without what takes time:
/// exposure, rolling shutter, delay. That is done in a thread of its own, of copies of poses, so the simulation is what it would be without
/// it; it waits for copies alone, and once for a renderer. Nothing is done, and no thread begun, while nobody wants a picture.
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
  std::uint64_t number = 0;                           ///< of pictures of this camera so far; another one: it is new
  std::shared_ptr<const sensors::CameraFrame> frame;  ///< null: there is none yet
  bool own = false;                                   ///< it draws for itself
  std::string trouble{};                              ///< why there is no picture, in one line; empty: all is well
};

class CameraSubscriptions {
 public:
  /// The session must outlive it.
  explicit CameraSubscriptions(session::Session& session);
  ~CameraSubscriptions();
  CameraSubscriptions(const CameraSubscriptions&) = delete;
  CameraSubscriptions& operator=(const CameraSubscriptions&) = delete;

  /// By "ROBOT.CAMERA". One thread.
  void want(const std::set<std::string>& cameras);
  /// Of a camera that is wanted; nothing: it has not been looked for yet.
  [[nodiscard]] std::optional<SeenPicture> seen(const std::string& camera) const;
  /// How many pictures were drawn here so far.
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
