/// port_pictures.h - pictures of a robot's cameras for its control software: bytes, by the name CAMERA.LAYER.
///
///     CAMERA.color    rgb8, or bayer_rggb8 and the like of a camera with a Bayer mosaic
///     CAMERA.depth    32FC1: [m] along the optical axis, infinite where nothing is
///     CAMERA.labels   16UC1: what is seen (sensors/view_source.h)
///
/// The layers are those that the camera has. Formats are named as ROS does (sensor_msgs/image_encodings.h): 8-bit channels, float,
/// 16-bit numbers of this machine's order, rows from the top without gaps.
#pragma once

#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/control_software/guard/guarded_row.h"
#include "murosimf/control_software/murosimf_controller.h"
#include "murosimf/sensors/camera_frame.h"
#include "murosimf/world/setup.h"

namespace murosimf::control_software {

class PortPictures {
 public:
  /// `setup` must live until close(), and the rows, to which it adds, as long as this.
  PortPictures(Setup& setup, GuardedRows& rows) : setup_(&setup), rows_(&rows) {}

  /// Called while the robot is set up: the camera draws from then on. A requested picture can be requested again later. Throws SetupError:
  /// there is no such camera or layer (with the nearest), or set-up is over.
  [[nodiscard]] const murosimf_picture* find(std::string_view name);
  void close() { setup_ = nullptr; }
  void refresh() noexcept;
  /// Called after a state was loaded: pictures with equal numbers may differ.
  void forget() noexcept;

 private:
  struct Shown {
    std::string name, format, layer;
    const sensors::CameraFrame* frame;
    const GuardedRow* row;  // what software sees
  };
  void make(std::string_view name);
  static void refresh(Shown& shown) noexcept;

  Setup* setup_;
  GuardedRows* rows_;
  std::deque<Shown> shown_;  // stay where they are
};

}  // namespace murosimf::control_software
