/// mjcf_camera.h - cameras of an MJCF file as numbers of a sensor of type `camera`.
///
/// Size of the picture: `resolution`, else 640 x 480 pixels. Lens: with `sensorsize` the focal lengths and the center of
/// the picture in pixels (fx, fy, cx, cy), else the horizontal fov that belongs to `fovy` at square pixels. The
/// principal point counts from the middle of the sensor, to the right and upward: it shifts the center of the picture the
/// other way, as MuJoCo draws it. cx and cy count from the center of the top left pixel (imaging/image.h).
/// A camera of MJCF looks along -z with y up; the sensor along x with z up.
/// Source: XML reference of the MuJoCo documentation, "body/camera".
#pragma once

#include "murosimf/files/xml_text.h"
#include "murosimf/robot_formats/mjcf/mjcf_defaults.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot_formats::mjcf {

/// Axes of a sensor of type `camera` to those of a camera of MJCF.
constexpr Mat3d camera_axes{{0, 0, -1}, {-1, 0, 0}, {0, 1, 0}};

/// The sensor of a camera, on a frame with the camera's place and the name `frame`. Cameras that are not fixed
/// to their bodies, and those without perspective, get an obstacle. Throws SetupError with file:line for impossible numbers.
[[nodiscard]] robot_formats::SensorDescription read_mjcf_camera(const MjcfAttributes& attributes,
                                                                const std::string& frame);

/// Whether MJCF can express the camera, which has its own frame.
[[nodiscard]] bool is_mjcf_camera(const robot_formats::SensorDescription& sensor);

/// Adds the numbers that read_mjcf_camera reads to the open element, except name and place.
void write_mjcf_camera(files::XmlText& xml, const robot_formats::SensorDescription& camera);

}  // namespace murosimf::robot_formats::mjcf
