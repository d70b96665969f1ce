/// renderer_test - drawn objects are where geometry puts them, against rays through the middles of pixels.
#include "murosimf/render/renderer.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "tests/environment_variable.h"
#include "tests/law.h"
#include "tests/render/drawn.h"

namespace murosimf::test {
namespace {

using sensors::Perspective;
using sensors::View;

/// What both renderers draw.
class Drawn : public DrawnBy {};
INSTANTIATE_TEST_SUITE_P(Devices, Drawn, all_devices, name_of_device);

/// Depth at which the ray of a pixel meets a sphere; infinite if it does not.
double depth_of_sphere(const Perspective& view, int u, int v, const Vec3d& center, double radius) {
  const Vec3d ray = ray_of(view, u, v), to = center - view.eye;
  const double b = dot(ray, to), a = dot(ray, ray), root = b * b - a * (dot(to, to) - radius * radius);
  return root < 0 ? INFINITY : (b - std::sqrt(root)) / a;
}

/// The pixels of an object.
struct Blob {
  void see(int u, int v) {
    ++count;
    sum_u += u;
    sum_v += v;
    left = std::min(left, u);
    right = std::max(right, u);
    top = std::min(top, v);
    bottom = std::max(bottom, v);
  }
  double count = 0, sum_u = 0, sum_v = 0;
  int left = 1 << 20, right = -1, top = 1 << 20, bottom = -1;
};

TEST_P(Drawn, ABallIsWhereItsProjectionIs) {
  law::Worst center, size, count;
  for (const double distance : {0.4, 0.9, 3.0, 7.0}) {
    for (const double aside : {0.0, 0.3, -0.6}) {
      const Vec3d place{distance, aside * distance, 0.4 + 0.2 * distance * std::abs(aside)};
      DrawnWorld world(GetParam());
      world.add_ball("ball", 0.07, place);
      const Perspective view = along_x({0, 0, 0.4}, 0.9, 640, 480);
      const View drawn = world.draw(view, {.labels = true});
      Blob seen, expected;
      for (int v = 0; v < view.height; ++v) {
        for (int u = 0; u < view.width; ++u) {
          if (drawn.labels(u, v) == sensors::label_moving_entity) seen.see(u, v);
          if (std::isfinite(depth_of_sphere(view, u, v, place, 0.07))) expected.see(u, v);
        }
      }
      ASSERT_GT(seen.count, 20);
      center.see(std::hypot(seen.sum_u / seen.count - expected.sum_u / expected.count,
                            seen.sum_v / seen.count - expected.sum_v / expected.count),
                 distance, aside);
      // mean diameter of what has this area
      size.see(2 * std::abs(std::sqrt(seen.count / pi) - std::sqrt(expected.count / pi)), distance, aside);
      count.see(std::abs(seen.count / expected.count - 1), distance, aside);
      EXPECT_LE(std::abs(seen.left - expected.left) + std::abs(seen.bottom - expected.bottom), 2);
    }
  }
  const std::string source = "rays through the middles of pixels against the sphere";
  law::expect_below({"a ball in the picture: its center", device_name(), source}, center, 0.5, "px");
  law::expect_below({"a ball in the picture: its diameter", device_name(), source}, size, 0.5, "px");
  law::expect_below({"labels: pixels of a ball, from 0.4 to 7 m", device_name(), source}, count, 0.1, "1");
}

TEST_P(Drawn, DepthsAreThoseOfGroundAndBall) {
  const Vec3d place{3, 0.2, 0.3};
  DrawnWorld world(GetParam());
  world.add_ball("ball", 0.3, place);
  const Perspective view = along_x({0, 0, 0.5}, 0.7, 320, 240);
  const View drawn = world.draw(view, {.depth = true});
  law::Worst ground, ball;
  for (int v = 0; v < view.height; ++v) {
    for (int u = 0; u < view.width; ++u) {
      const Vec3d ray = ray_of(view, u, v);
      const double sphere = depth_of_sphere(view, u, v, place, 0.3);
      const double plane = ray.z < -1e-9 ? -view.eye.z / ray.z : INFINITY;
      // the edge of the ball: its depth changes fast there
      const double edge = norm(cross(place - view.eye, (1 / norm(ray)) * ray)) / 0.3;
      if (std::isfinite(sphere) && edge < 0.8) ball.see(std::abs(drawn.depth(u, v) - sphere), u, v);
      if (edge > 1.02 && plane < 3.5) ground.see(std::abs(drawn.depth(u, v) - plane), u, v);
    }
  }
  law::expect_below({"depth picture: the ground up to 3.5 m", device_name(), "plane and ray"}, ground, 1e-4, "m");
  law::expect_below({"depth picture: a ball of 0.3 m at 3 m", device_name(), "sphere and ray"}, ball, 1e-3, "m");
}

TEST_P(Drawn, NothingIsInfinitelyFar) {
  DrawnWorld world(GetParam());
  Perspective up = along_x({0, 0, 1}, 0.5, 8, 8);
  up.axes = {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}};  // looks up
  const View drawn = world.draw(up);
  EXPECT_TRUE(std::isinf(drawn.depth(4, 4)));
  EXPECT_EQ(drawn.labels(4, 4), sensors::label_background);
}

/// Every form of shape hides the objects behind it along rays. A turned one of each, against a march along the ray.
TEST_P(Drawn, AllShapesAreWhatTheyAre) {
  for (const Shape& shape : fixtures::shapes_of_all_kinds()) {
    if (std::holds_alternative<Plane>(shape)) continue;
    DrawnWorld world(GetParam());
    Shapes shapes{{.shape = shape, .position = {}, .orientation = {}, .surface = {}, .color = {}}};
    const Mat3d turn = rotation_z(0.7) * rotation_y(-0.4) * rotation_x(0.9);
    const Vec3d place{2, 0.1, 3};
    world.add("thing", std::make_shared<const Model>("thing", Chain{}.base("thing").with(properties::shapes, shapes)),
              place, turn);
    const double reach = bounding_radius(shape);
    Perspective view = along_x({2 - 8 * reach, 0.1, 3}, 0.2, 96, 96);
    view.finest = true;
    const View drawn = world.draw(view, {.labels = true});
    int wrong = 0, inside = 0;
    for (int v = 0; v < view.height; ++v) {
      for (int u = 0; u < view.width; ++u) {
        const Vec3d ray = ray_of(view, u, v);
        double nearest = INFINITY;
        for (double t = 6 * reach; t < 10 * reach; t += reach / 100) {
          nearest = std::min(nearest, fixtures::outside(shape, transposed_times(turn, view.eye + t * ray - place)));
        }
        const bool drawn_here = drawn.labels(u, v) == sensors::label_moving_entity;
        inside += nearest <= 0 ? 1 : 0;
        // rays that pass within a hundredth of the surface may go either way
        if (std::abs(nearest) > 0.02 * reach && drawn_here != (nearest <= 0)) ++wrong;
      }
    }
    EXPECT_EQ(wrong, 0) << shape_name(shape);
    EXPECT_GT(inside, 200) << shape_name(shape);
  }
}

TEST_P(Drawn, WhatMovesIsSeenLater) {
  DrawnWorld world(GetParam());
  Entity& ball = world.add_ball("ball", 0.1, {2, 0, 1});
  ball.column(properties::linear_velocity).values.assign(1, {0, -1, 0});
  const Perspective view = along_x({0, 0, 1}, 0.5, 200, 200);
  const auto middle = [&](double ahead) {
    const View drawn = world.draw(view, {.labels = true}, {}, ahead);
    Blob blob;
    for (int v = 0; v < 200; ++v) {
      for (int u = 0; u < 200; ++u) {
        if (drawn.labels(u, v) == sensors::label_moving_entity) blob.see(u, v);
      }
    }
    return blob.sum_u / blob.count;
  };
  EXPECT_NEAR(middle(0.2) - middle(0), 200 * 0.2 / 2.0, 0.5) << "to the right, since y points to the left";
}

TEST_P(Drawn, LinesAreLabelledWhereTheyArePainted) {
  DrawnWorld world(GetParam());
  world.add_field();
  Perspective down = along_x({-1, 0.3, 2}, 0.5, 200, 200);
  down.axes = {{0, -1, 0}, {-1, 0, 0}, {0, 0, -1}};  // from above, x of the world upwards in the picture
  const View drawn = world.draw(down);
  // the center circle crosses the x axis at -0.6 m; from above 200 px are 2 m
  const auto at = [&](double x, double y) {
    return std::pair{static_cast<int>(100 - (y - 0.3) * 100), static_cast<int>(100 - (x + 1) * 100)};
  };
  const auto [u, v] = at(-0.6, 0);
  EXPECT_EQ(drawn.labels(u, v), sensors::label_line);
  EXPECT_GT(drawn.color(u, v).red, 200);
  const auto [gu, gv] = at(-1.0, 0.5);
  EXPECT_EQ(drawn.labels(gu, gv), sensors::label_ground);
  EXPECT_GT(drawn.color(gu, gv).green, drawn.color(gu, gv).red);
}

TEST_P(Drawn, ALineFarAwayIsAsBrightAsItIsWide) {
  // A pixel that a line covers in part shows that part: the sum over a column is the line's width in pixels.
  DrawnWorld world(GetParam());
  world.add_field(false);
  Perspective view = along_x({-6, 0, 1.5}, 0.3, 64, 128);
  view.axes = Mat3d{{0, -1, 0}, {0, 0, -1}, {1, 0, 0}} * rotation_x(-std::atan(1.5 / 6));  // at the halfway line
  const View drawn = world.draw(view);
  const double pixel = (view.bottom - view.top) / view.height;
  const auto tangent = [&](double x) {
    const Vec3d seen = transposed_times(view.axes, Vec3d{x, 0.2, 0} - view.eye);
    return seen.y / seen.z;
  };
  const double width = std::abs(tangent(0.025) - tangent(-0.025)) / pixel;
  ASSERT_LT(width, 3);
  const int u = 8;  // beside the center circle
  const double green = drawn.color(u, 72).red, white = 251;
  double sum = 0;
  for (int v = 58; v < 72; ++v) sum += (drawn.color(u, v).red - green) / (white - green);
  EXPECT_NEAR(sum, width, 0.15 * width);
}

TEST_P(Drawn, LampsShadowsAndNight) {
  DrawnWorld world(GetParam());
  world.add_field();
  world.add_ball("ball", 0.2, {0, 0, 0.5});
  Perspective down = along_x({0, 0, 3}, 0.5, 100, 100);
  down.axes = {{0, -1, 0}, {-1, 0, 0}, {0, 0, -1}};
  const auto ground = [&](const char* light, bool shadows, double x, double y) {
    render::RendererOptions options;
    for (const auto& named : render::lights()) {
      if (named.name == light) options.light = named.light;
    }
    options.light.toward = {0.8, 0, 1};  // the shadow falls to -x
    options.light.patterns = false;      // an even ground
    options.light.shadows = shadows;
    const View drawn = world.draw(down, {}, options);
    return drawn.color(static_cast<int>(50 - 100 * y / 3), static_cast<int>(50 - 100 * x / 3)).green;
  };
  const int lit = ground("hall", true, 0.4, 0.2), dark = ground("hall", true, -0.42, 0.04);
  EXPECT_LT(dark, 0.85 * lit);
  EXPECT_EQ(ground("hall", false, -0.42, 0.04), lit);
  EXPECT_LT(ground("night", false, 0.4, 0.2), 0.5 * lit);
}

TEST_P(Drawn, ManySamplesMakeEdgesSmooth) {
  DrawnWorld world(GetParam());
  world.add_ball("ball", 0.2, {2, 0, 1});
  const Perspective view = along_x({0, 0, 1}, 0.3, 100, 100);
  const auto colors_between = [&](int samples) {
    const View drawn = world.draw(view, {}, {.light = {.shadows = false}, .samples = samples});
    const imaging::Rgb sky = drawn.color(50, 2), below = drawn.color(50, 50);
    int between = 0;
    for (int u = 0; u < 100; ++u) {
      const int red = drawn.color(u, 40).red;
      const bool other = std::abs(red - sky.red) > 12 && std::abs(red - below.red) > 40;
      between += other ? 1 : 0;
    }
    return between;
  };
  EXPECT_GE(colors_between(4), colors_between(1));
  const View both = world.draw(view, {true, true, true}, {.samples = 4});
  EXPECT_EQ(both.labels(50, 50), sensors::label_moving_entity) << "labels have one sample";
  EXPECT_NEAR(both.depth(50, 50), 1.8, 1e-3);
}

TEST_P(Drawn, RowsAloneAreThoseOfTheWholePicture) {
  DrawnWorld world(GetParam());
  world.add_field();
  world.add_ball("ball", 0.2, {2, 0, 0.4});
  Perspective view = along_x({0, 0, 0.6}, 0.6, 120, 90);
  const View whole = world.draw(view);
  view.first_row = 30;
  view.rows = 17;
  const View band = world.draw(view);
  for (int v = 30; v < 47; ++v) {
    for (int u = 0; u < 120; ++u) {
      EXPECT_EQ(whole.color(u, v), band.color(u, v));
      EXPECT_EQ(whole.labels(u, v), band.labels(u, v));
    }
  }
}

TEST_P(Drawn, SaysWhatDraws) {
  const auto renderer = DrawnWorld(GetParam()).make_renderer({});
  EXPECT_NE(renderer->name(), "");
  EXPECT_EQ(renderer->name().ends_with(", software"), renderer->on_processor());
  EXPECT_TRUE(renderer->on_processor() || GetParam() == Device::opengl);
}

/// The renderer for people by this value of MUROSIMF_RENDERER.
std::string renderer_by(const char* value) {
  const EnvironmentVariable renderer("MUROSIMF_RENDERER", value);
  try {
    const World world;
    return render::make_renderer(world, {}, render::appearance_of_shapes, {})->name();
  } catch (const SetupError& error) {
    return error.what();
  }
}

TEST(RendererForPeople, IsOwnWithoutAGraphicsCardAndAsTheEnvironmentSays) {
  const std::string own = DrawnWorld(Device::processor).make_renderer({})->name();
  EXPECT_EQ(renderer_by("software"), own);
  EXPECT_EQ(renderer_by("vulkan"), "MUROSIMF_RENDERER=vulkan: must be 'opengl' or 'software'");
  if (!no_drawing().empty()) {
    EXPECT_EQ(renderer_by(""), own);
    EXPECT_EQ(renderer_by("opengl"), no_drawing());
    return;
  }
  const auto by_opengl = DrawnWorld(Device::opengl).make_renderer({});
  EXPECT_EQ(renderer_by("opengl"), by_opengl->name());
  EXPECT_EQ(renderer_by(""), by_opengl->on_processor() ? own : by_opengl->name());
}

/// A plate across x of 1 m, in `color`.
ModelPtr plate(const Color& color) {
  PlacedShape placed;
  placed.shape = Box{{0.01, 0.5, 0.5}};
  placed.color = color;
  return std::make_shared<const Model>("plate", Chain{}.base("plate").with(properties::shapes, Shapes{placed}));
}

/// The color and depth of the middle of a picture of plates at 1, 2, ... m, in the order in which they are given.
std::pair<imaging::Rgb, double> seen_through(Device device, const std::vector<std::pair<double, Color>>& plates) {
  DrawnWorld world(device);
  for (std::size_t i = 0; i < plates.size(); ++i) {
    world.add("plate_" + std::to_string(i), plate(plates[i].second), {plates[i].first, 0, 0});
  }
  const View drawn = world.draw(along_x({0, 0, 0}, 0.1, 21, 21));
  return {drawn.color(10, 10), drawn.depth(10, 10)};
}

TEST_P(Drawn, WhatIsSeeThroughIsLaidOverWhatIsBehind) {
  const Color red{1, 0, 0}, green{0, 1, 0}, half_blue{0, 0, 1, 0.5}, half_green{0, 1, 0, 0.25};
  const auto red_alone = seen_through(GetParam(), {{2, red}}).first,
             blue_alone = seen_through(GetParam(), {{1, {0, 0, 1}}}).first;
  const auto green_alone = seen_through(GetParam(), {{1, green}}).first;
  const auto expect_level = [](double value, double expected) { EXPECT_NEAR(value, expected, 2); };
  // in either order
  for (const bool swapped : {false, true}) {
    std::vector<std::pair<double, Color>> plates{{2, red}, {1, half_blue}};
    if (swapped) std::swap(plates[0], plates[1]);
    const auto [color, depth] = seen_through(GetParam(), plates);
    expect_level(color.red, 0.5 * red_alone.red);
    expect_level(color.blue, 0.5 * blue_alone.blue + 0.5 * red_alone.blue);
    EXPECT_NEAR(depth, 0.99, 1e-3);
  }
  // two transparent ones: the nearer over the farther
  const auto both = seen_through(GetParam(), {{1, half_green}, {2, half_blue}, {3, red}}).first;
  expect_level(both.red, 0.75 * 0.5 * red_alone.red);
  expect_level(both.blue, 0.75 * 0.5 * blue_alone.blue);
  expect_level(both.green, 0.25 * green_alone.green);
  // behind an opaque one it is invisible, and with alpha 0 it is absent
  EXPECT_EQ(seen_through(GetParam(), {{1, red}, {2, half_blue}}).first, seen_through(GetParam(), {{1, red}}).first);
  const auto [color, depth] = seen_through(GetParam(), {{2, red}, {1, {0, 0, 1, 0}}});
  EXPECT_EQ(color, red_alone);
  EXPECT_NEAR(depth, 1.99, 1e-3);
}

}  // namespace
}  // namespace murosimf::test
