/// sensors.h - sensors of robots: the last sample of a sensor, the last picture of a camera.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "murosimf/values.h"

namespace murosimf {

namespace api {
struct SceneInside;
struct SensorInside;
struct CameraInside;
}  // namespace api

inline namespace v0 {

/// One quantity of a sensor.
struct SensorOutput {
  std::string name;                 ///< "gyroscope"
  std::string unit;                 ///< SI
  std::vector<std::string> labels;  ///< "x", "y", "z"; of single numbers none
  std::size_t begin = 0, size = 1;  ///< where its numbers stand in Sensor::values()
};

/// Keeps the scene alive inside the library; rules of use are those of handles (world.h).
class MUROSIMF_API Sensor {
 public:
  // moving copies: no handle is ever empty
  Sensor(const Sensor&) = default;
  Sensor& operator=(const Sensor&) = default;

  [[nodiscard]] const std::string& name() const;
  [[nodiscard]] const std::string& type() const;   ///< "imu"
  [[nodiscard]] const std::string& frame() const;  ///< the object that it is mounted on; empty: none in particular
  [[nodiscard]] double period() const;             ///< [s] from sample to sample
  [[nodiscard]] const std::vector<SensorOutput>& outputs() const;

  /// [s] when the last sample that has arrived was taken.
  [[nodiscard]] double time() const;
  /// Number of samples that have arrived so far; 0: values are 0 or those at rest.
  [[nodiscard]] std::uint64_t samples() const;
  /// Values of all outputs, one after the other; NaN: nothing was seen. The memory stays where it is as long as a handle of the scene lives,
  /// and shows every new sample.
  [[nodiscard]] std::span<const double> values() const;
  /// Values of one output. Throws UnknownName.
  [[nodiscard]] std::span<const double> values(std::string_view output) const;

 private:
  friend class Robot;
  explicit Sensor(std::shared_ptr<const api::SensorInside> inside) : inside_(std::move(inside)) {}
  std::shared_ptr<const api::SensorInside> inside_;
};

/// A picture, row by row from the top left.
struct Image {
  int width = 0, height = 0;         ///< [px]
  std::vector<std::uint8_t> rgb;     ///< (height, width, 3) sRGB; empty: without colors
  std::vector<std::uint8_t> mosaic;  ///< (height, width) behind a Bayer filter; empty: there is none
  std::vector<float> depth;  ///< (height, width) [m] along the optical axis, infinite where nothing is; empty: without
  std::vector<std::uint16_t>
      labels;  ///< (height, width) what each pixel shows, as numbers of Camera::labels(); empty: without
};

/// Draws only if it was requested (Robot::camera), from then on, or is `always_on` in its file.
class MUROSIMF_API Camera {
 public:
  // moving copies: no handle is ever empty
  Camera(const Camera&) = default;
  Camera& operator=(const Camera&) = default;

  [[nodiscard]] const std::string& name() const;
  [[nodiscard]] double period() const;  ///< [s] from picture to picture
  /// What the numbers of Image::labels mean.
  [[nodiscard]] const std::vector<std::string>& labels() const;
  /// Number of pictures so far; 0: none.
  [[nodiscard]] std::uint64_t pictures() const;
  /// [s] when the exposure of the last one began.
  [[nodiscard]] double time() const;
  /// A copy of the last one, with the layers that the camera has.
  [[nodiscard]] Image picture() const;

 private:
  friend class Robot;
  explicit Camera(std::shared_ptr<const api::CameraInside> inside) : inside_(std::move(inside)) {}
  std::shared_ptr<const api::CameraInside> inside_;
};

}  // namespace v0
}  // namespace murosimf
