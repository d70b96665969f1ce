/// drawn.h - small worlds for the renderers; tests are skipped where one does not work.
#pragma once

#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"
#include "murosimf/render/opengl_renderer.h"
#include "murosimf/render/software_renderer.h"
#include "murosimf/scene_file/field.h"
#include "tests/fixtures.h"

namespace murosimf::test {

/// What draws.
enum class Device { opengl, processor };

/// The reason why OpenGL does not draw here; empty if it does.
inline std::string no_drawing() {
  static const std::string reason = [] {
    try {
      const World empty;
      const render::OpenGlRenderer renderer(empty, {}, render::appearance_of_shapes);
      return std::string();
    } catch (const SetupError& error) {
      return std::string(error.what());
    }
  }();
  return reason;
}

/// Tests of what both renderers draw.
class DrawnBy : public testing::TestWithParam<Device> {
 protected:
  void SetUp() override {
    if (GetParam() == Device::opengl && !no_drawing().empty()) GTEST_SKIP() << no_drawing();
  }
  /// For the rows of the table of laws.
  static std::string device_name() { return GetParam() == Device::opengl ? "OpenGL" : "camera"; }
};

inline const auto all_devices = testing::Values(Device::opengl, Device::processor);
inline std::string name_of_device(const testing::TestParamInfo<Device>& device) {
  return device.param == Device::opengl ? "opengl" : "processor";
}

struct DrawnWorld {
  explicit DrawnWorld(Device draws = Device::opengl) : device(draws) {}

  Entity& add(const std::string& name, ModelPtr model, const Vec3d& place, const Mat3d& turn = {}) {
    Entity& entity = world.add(name, std::move(model));
    entity.column(properties::position).values.assign(entity.model().size(), place);
    entity.column(properties::orientation).values.assign(entity.model().size(), turn);
    entity.column(properties::linear_velocity).values.assign(entity.model().size(), {});
    entity.column(properties::angular_velocity).values.assign(entity.model().size(), {});
    moving_entities.push_back(&entity);
    return entity;
  }
  Entity& add_ball(const std::string& name, double radius, const Vec3d& place) {
    return add(name, std::make_shared<const Model>(fixtures::ball_model(radius, 0.4)), place);
  }
  void add_field(bool goals = true) {
    world.add("field", scene_file::field_model(scene_file::kid_size_2008, "carpet", {}, {.goals = goals}));
  }

  /// `view`: a sensors::Perspective or a render::ParallelView.
  template <class AnyView>
  sensors::View draw(const AnyView& view, const sensors::Layers& layers = {true, true, true},
                     render::RendererOptions options = {.light = {.shadows = false}}, double ahead = 0) {
    sensors::View drawn;
    const auto renderer = make_renderer(options);
    renderer->locate();
    renderer->draw(view, layers, ahead, drawn);
    EXPECT_EQ(renderer->trouble(), "");
    return drawn;
  }

  [[nodiscard]] std::unique_ptr<render::Renderer> make_renderer(const render::RendererOptions& options) const {
    constexpr auto appearance = render::appearance_of_shapes;
    if (device == Device::processor)
      return std::make_unique<render::SoftwareRenderer>(world, moving_entities, appearance, options);
    return std::make_unique<render::OpenGlRenderer>(world, moving_entities, appearance, options);
  }

  Device device;
  World world;
  std::vector<Entity*> moving_entities;
};

/// From `eye` along x, x of the picture to -y; `half`: tangent of half the fov, to all sides.
inline sensors::Perspective along_x(const Vec3d& eye, double half, int width, int height) {
  sensors::Perspective view;
  view.eye = eye;
  view.axes = {{0, -1, 0}, {0, 0, -1}, {1, 0, 0}};
  view.right = half;
  view.left = -half;
  view.bottom = half * height / width;
  view.top = -view.bottom;
  view.width = width;
  view.height = height;
  return view;
}

/// The world ray of the middle of a pixel, z forward 1.
inline Vec3d ray_of(const sensors::Perspective& view, int u, int v) {
  const double x = view.left + (u + 0.5) * (view.right - view.left) / view.width;
  const double y = view.top + (v + 0.5) * (view.bottom - view.top) / view.height;
  return view.axes * Vec3d{x, y, 1};
}

}  // namespace murosimf::test
