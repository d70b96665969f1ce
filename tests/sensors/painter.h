/// painter.h - a test double of a camera's source of pictures: it paints the requested pose and time.
#pragma once

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "murosimf/sensors/camera.h"
#include "tests/sensors/range_rig.h"

namespace murosimf::test {

/// Red: 1000 times the time ahead. Green and blue: the direction of the pixel in the world, y and z. Depth: 2 along the
/// axis. Labels: the number of the call.
class Painter final : public sensors::ViewSource {
 public:
  void draw(const sensors::Perspective& view, const sensors::Layers& layers, double ahead,
            sensors::View& into) noexcept override {
    looks.push_back({view, layers, ahead});
    const auto fit = [&](auto& image) {
      if (image.width() != view.width || image.height() != view.height) {
        image = std::remove_reference_t<decltype(image)>(view.width, view.height);
      }
    };
    if (layers.color) fit(into.color);
    if (layers.depth) fit(into.depth);
    if (layers.labels) fit(into.labels);
    const int rows = view.rows > 0 ? view.rows : view.height;
    for (int v = view.first_row; v < view.first_row + rows; ++v) {
      for (int u = 0; u < view.width; ++u) {
        const double x = view.left + (u + 0.5) * (view.right - view.left) / view.width;
        const double y = view.top + (v + 0.5) * (view.bottom - view.top) / view.height;
        const Vec3d ray = view.axes * ((1 / std::sqrt(x * x + y * y + 1)) * Vec3d{x, y, 1});
        const auto byte = [](double share) { return static_cast<std::uint8_t>(std::lround(127.5 + 127.5 * share)); };
        if (layers.color)
          into.color(u, v) = {static_cast<std::uint8_t>(std::lround(1000 * ahead)), byte(ray.y), byte(ray.z)};
        if (layers.depth) into.depth(u, v) = 2;
        if (layers.labels) into.labels(u, v) = static_cast<std::uint16_t>(looks.size());
      }
    }
  }

  struct Look {
    sensors::Perspective view;
    sensors::Layers layers;
    double ahead;
  };
  std::vector<Look> looks;
};

inline sensors::SensorSpec camera(const std::map<std::string, double>& numbers = {}) {
  sensors::SensorSpec spec;
  spec.name = "eye";
  spec.type = "camera";
  spec.rate = 50;
  spec.numbers = {{"width", 40}, {"height", 30}, {"fov", 1.0}, {"always_on", 1}};
  for (const auto& [key, number] : numbers) spec.numbers[key] = number;
  return spec;
}

struct CameraRig : RangeRig {
  const sensors::CameraFrame& attach_camera(Entity& robot, const sensors::SensorSpec& spec) {
    reading = &component_files::attach_sensor(simulation, robot, spec,
                                              {1, moving_entities, [this] { return &painter; }}, rate)
                   .reading();
    return *sensors::frames_of(robot).at(0);
  }
  Painter painter;
  const sensors::Reading* reading = nullptr;
};

}  // namespace murosimf::test
