#include "murosimf/io/urdf_sensor.h"

#include <fmt/format.h>

#include "murosimf/io/urdf_value.h"

namespace murosimf::io {
namespace {

/// The number of an element inside; `fallback` if there is none.
double child_number(const XmlElement& parent, const char* tag, double fallback = 0) {
  const auto child = only_child(parent, tag);
  return child ? text_number(*child) : fallback;
}

/// Also from the element `name` of each plugin of the sensor.
double distortion(const XmlElement& sensor, const std::optional<XmlElement>& lens, const char* in_lens,
                  const char* in_plugin) {
  if (lens && only_child(*lens, in_lens)) return child_number(*lens, in_lens);
  for (const XmlElement& plugin : sensor.children("plugin")) {
    if (only_child(plugin, in_plugin)) return child_number(plugin, in_plugin);
  }
  return 0;
}

int pixels(const XmlElement& image, const char* tag) {
  const double number = child_number(image, tag);
  if (!(number >= 0 && number <= 1e5)) image.fail(fmt::format("{} of the image is {}; write pixels", tag, number));
  return static_cast<int>(number);
}

DraftCamera read_camera(const XmlElement& sensor, const XmlElement& element) {
  DraftCamera camera;
  camera.horizontal_view = child_number(element, "horizontal_fov");
  if (const auto image = only_child(element, "image")) {
    camera.width = pixels(*image, "width");
    camera.height = pixels(*image, "height");
  }
  const auto lens = only_child(element, "distortion");
  camera.k1 = distortion(sensor, lens, "k1", "distortionK1");
  camera.k2 = distortion(sensor, lens, "k2", "distortionK2");
  camera.k3 = distortion(sensor, lens, "k3", "distortionK3");
  camera.p1 = distortion(sensor, lens, "p1", "distortionT1");
  camera.p2 = distortion(sensor, lens, "p2", "distortionT2");
  return camera;
}

Place read_pose(const XmlElement& sensor) {
  const auto pose = only_child(sensor, "pose");
  if (!pose || pose->text().empty()) return {};
  const auto p = needed_numbers(*pose, pose->text(), 6, "<pose>");
  return {{p[0], p[1], p[2]}, from_roll_pitch_yaw({p[3], p[4], p[5]})};
}

}  // namespace

double text_number(const XmlElement& element) {
  const std::string text = element.text();
  const std::string value = text.empty() ? element.attribute("value").value_or("") : text;
  return needed_numbers(element, value, 1, fmt::format("<{}>", element.tag()))[0];
}

DraftSensor read_sensor(const XmlElement& sensor, const std::string& frame) {
  DraftSensor draft{sensor.attribute("type").value_or(""),
                    sensor.attribute("name").value_or(""),
                    frame,
                    sensor.where(),
                    read_pose(sensor),
                    child_number(sensor, "update_rate"),
                    {}};
  const auto cameras = sensor.children("camera");
  if (!cameras.empty()) draft.camera = read_camera(sensor, cameras[0]);
  return draft;
}

}  // namespace murosimf::io
