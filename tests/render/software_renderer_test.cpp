/// software_renderer_test - cameras' pictures are those of OpenGL, and have the same bits everywhere.
#include "murosimf/render/software_renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "murosimf/math/hash.h"
#include "murosimf/math/random.h"
#include "murosimf/render/software/coverage.h"
#include "tests/render/drawn.h"

namespace murosimf::test {
namespace {

using sensors::Perspective;
using sensors::View;

PlacedShape plate(const Vec3d& half_size, const Color& color) {
  PlacedShape placed;
  placed.shape = Box{half_size};
  placed.color = color;
  return placed;
}

Entity& add_shape(DrawnWorld& world, const std::string& name, const PlacedShape& shape, const Vec3d& place,
                  const Mat3d& turn = {}) {
  return world.add(name,
                   std::make_shared<const Model>(name, Chain{}.base(name).with(properties::shapes, Shapes{shape})),
                   place, turn);
}

/// A field with nets, balls, solids of all forms, one of them seen through, and one that begins behind the eye.
void fill(DrawnWorld& world) {
  world.world.add("field",
                  scene_file::field_model(scene_file::kid_size_2023, "carpet", {}, {.goals = true, .nets = true}));
  world.add_ball("ball", 0.07, {1, 0.1, 0.07});
  add_shape(world, "clear", plate({0.01, 0.3, 0.3}, {0, 0, 1, 0.5}), {3, -0.8, 0.3});
  add_shape(world, "beam", plate({1.5, 0.02, 0.02}, {0.8, 0.5, 0.2}), {0.5, 0.3, 0.6}, rotation_z(0.1));
  int number = 0;
  for (const Shape& shape : fixtures::shapes_of_all_kinds()) {
    if (std::holds_alternative<Plane>(shape)) continue;
    const double y = 0.3 * number - 0.9;
    PlacedShape placed;
    placed.shape = shape;
    placed.color = {0.7, 0.3, 0.3};
    add_shape(world, "shape_" + std::to_string(number), placed, {2.5, y, 0.4}, rotation_x(0.7 * y) * rotation_z(y));
    ++number;
  }
}

render::RendererOptions in_light(std::string_view name, bool shadows) {
  render::RendererOptions options;
  for (const render::NamedLight& named : render::lights()) {
    if (named.name == name) options.light = named.light;
  }
  options.light.shadows = shadows;
  return options;
}

int difference(const imaging::Rgb& a, const imaging::Rgb& b) {
  return std::max({std::abs(a.red - b.red), std::abs(a.green - b.green), std::abs(a.blue - b.blue)});
}

/// What two pictures differ in, in shares of all pixels.
struct Differences {
  Differences(const View& a, const View& b) {
    const double pixel = 1.0 / (a.color.width() * a.color.height());
    for (int v = 0; v < a.color.height(); ++v) {
      for (int u = 0; u < a.color.width(); ++u) {
        const int apart = difference(a.color(u, v), b.color(u, v));
        mean += pixel * apart;
        if (apart > 10) color += pixel;
        if (a.labels(u, v) != b.labels(u, v)) label += pixel;
        const double away = std::abs(double{a.depth(u, v)} - double{b.depth(u, v)});
        if (a.depth(u, v) != b.depth(u, v) && !(away < 1e-4 * std::max(1.0F, a.depth(u, v)))) depth += pixel;
      }
    }
  }
  double mean = 0;  ///< [1 of 255]
  double color = 0, label = 0, depth = 0;
};

class SoftwareRendererAgainstOpenGl : public testing::Test {
 protected:
  void SetUp() override {
    if (!no_drawing().empty()) GTEST_SKIP() << no_drawing();
    fill(by_opengl_);
    fill(by_processor_);
  }
  template <class AnyView>
  Differences differences(const AnyView& view, const render::RendererOptions& options) {
    return {by_opengl_.draw(view, {true, true, true}, options), by_processor_.draw(view, {true, true, true}, options)};
  }

 private:
  DrawnWorld by_opengl_{Device::opengl}, by_processor_{Device::processor};
};

// Oracle: OpenGL draws the same by shaders of its own. At edges a pixel may show the neighbor.
TEST_F(SoftwareRendererAgainstOpenGl, DrawsTheSame) {
  const Perspective view = along_x({0, 0, 0.5}, 0.9, 320, 240);
  for (const render::NamedLight& named : render::lights()) {
    for (const bool shadows : {false, true}) {
      const Differences found = differences(view, in_light(named.name, shadows));
      EXPECT_LT(found.mean, 0.6) << named.name << shadows;
      EXPECT_LT(found.color, 0.004) << named.name << shadows;
      EXPECT_LT(found.label, 0.001) << named.name << shadows;
      EXPECT_LT(found.depth, 0.001) << named.name << shadows;
    }
  }
}

TEST_F(SoftwareRendererAgainstOpenGl, DrawsTheSameForPeople) {
  const Perspective view = along_x({0, 0, 0.5}, 0.9, 320, 240);
  for (const char* light : {"hall", "day"}) {
    render::RendererOptions options = in_light(light, true);
    options.samples = 4;
    options.fine = true;
    const Differences found = differences(view, options);
    EXPECT_LT(found.mean, 1) << light;
    EXPECT_LT(found.color, 0.02) << light;
    EXPECT_LT(found.label, 0.001) << light;
  }
}

// The processor's rays meet 500 widths away: lines at the border of the picture are a quarter of a pixel off.
TEST_F(SoftwareRendererAgainstOpenGl, DrawsTheSameByParallelRays) {
  for (const double elevation : {0.0, 0.4, 0.5 * pi}) {
    const render::ParallelView view{
        .center = {1, 0, 0.4}, .axes = render::axes_from(0.4, elevation), .pixel = 0.02, .width = 320, .height = 240};
    render::RendererOptions options = in_light("hall", true);
    options.light.patterns = false;  // the pile is noise: a place that is a little off has another height
    const Differences found = differences(view, options);
    EXPECT_LT(found.mean, 1.2) << elevation;
    EXPECT_LT(found.color, 0.05) << elevation;
    EXPECT_LT(found.label, 0.005) << elevation;
  }
}

// Threads draw some rows each.
TEST(SoftwareRenderer, HasTheSameBitsWithAnyNumberOfThreads) {
  DrawnWorld world(Device::processor);
  fill(world);
  for (const bool rolled : {false, true}) {
    Perspective view = along_x({0, 0, 0.5}, 0.9, 320, 240);
    if (rolled) view.axes = view.axes * rotation_z(0.3);
    render::RendererOptions options = in_light("hall", true);
    options.samples = 4;
    options.fine = true;
    const View one = world.draw(view, {true, true, true}, options);
    options.threads = 3;
    const View three = world.draw(view, {true, true, true}, options);
    EXPECT_TRUE(std::ranges::equal(one.color.pixels(), three.color.pixels()));
    EXPECT_TRUE(std::ranges::equal(one.depth.pixels(), three.depth.pixels()));
    EXPECT_TRUE(std::ranges::equal(one.labels.pixels(), three.labels.pixels()));
  }
}

// The bits of pictures and not only their looks: whoever replaces a formula replaces these, too.
TEST(SoftwareRenderer, HasTheSameBitsOnEveryMachine) {
  DrawnWorld world(Device::processor);
  fill(world);
  const View drawn = world.draw(along_x({0, 0, 0.5}, 0.9, 323, 241), {true, true, true}, in_light("hall", true));
  Hasher hasher;
  for (const imaging::Rgb& pixel : drawn.color.pixels())
    hasher.add(static_cast<std::uint64_t>(pixel.red) << 16 | static_cast<std::uint64_t>(pixel.green) << 8 | pixel.blue);
  EXPECT_EQ(hasher.value(), 7197724309665325083U);
}

// Law: 1 / z of a plane is linear in the picture, however far a triangle reaches beyond it and behind the eye. Corners are exact to 1e-6 m.
TEST(SoftwareRenderer, WhatBeginsBehindTheEyeHasItsDepths) {
  DrawnWorld world(Device::processor);
  add_shape(world, "plate", plate({20, 20, 0.01}, {0.5, 0.5, 0.5}),
            {10, 3, 1 - 0.03});  // its upper side 2 cm below the eye
  Perspective view = along_x({0, 0, 1}, 0.8, 200, 200);
  view.axes = view.axes * rotation_z(0.3) * rotation_x(-0.2);
  const View drawn = world.draw(view, {false, true, false}, {.ground = false});
  int seen = 0;
  for (int v = 0; v < view.height; ++v) {
    for (int u = 0; u < view.width; ++u) {
      const double down = -ray_of(view, u, v).z, depth = 0.02 / down;
      if (!(down > 0.01) || depth < 0.011) continue;
      ++seen;
      ASSERT_NEAR(drawn.depth(u, v) / depth, 1, 1e-4) << u << ' ' << v;
    }
  }
  EXPECT_GT(seen, 5000);
}

// Law: triangles that share edges leave no pixel between them out, and draw none twice but on an edge.
TEST(Coverage, NeighborsLeaveNoPixelOut) {
  using namespace render::software;
  constexpr int side = 61;
  const RandomStream random(1, "coverage");
  for (std::uint64_t round = 0; round < 50; ++round) {
    // a fan about a point, whose corners lie on a circle beyond the picture or are whole pixels
    const bool whole = round % 2 == 0;
    const Corner middle{static_cast<float>(random.uniform(2 * round, 5, 55)),
                        static_cast<float>(random.uniform(2 * round + 1, 5, 55)), 1};
    std::vector<Corner> around;
    for (int i = 0; i < 17; ++i) {
      const double angle = 2 * pi * i / 17;
      Corner corner{static_cast<float>(30 + 60 * std::cos(angle)), static_cast<float>(30 + 60 * std::sin(angle)), 1};
      if (whole) corner = {std::round(corner.u), std::round(corner.v), 1};
      around.push_back(corner);
    }
    const Corner center = whole ? Corner{std::round(middle.u), std::round(middle.v), 1} : middle;
    std::array<int, side * side> drawn{};
    const PixelBox all{0, side - 1, 0, side - 1};
    for (std::size_t i = 0; i < around.size(); ++i) {
      const std::array<Corner, 3> c{center, around[i], around[(i + 1) % around.size()]};
      ASSERT_GT(turn_of(c), 0);
      for_covered(c, Slope{1, 0, 0}, Anchor(c[0], all), all,
                  [&](int v, int u, const Ints& inside, const Floats& /*per_z*/) {
                    for (int k = 0; k < pixel_lanes; ++k) {
                      if (inside[k] != 0) ++drawn[static_cast<std::size_t>(v * side + u + k)];
                    }
                  });
    }
    EXPECT_EQ(*std::ranges::min_element(drawn), 1);
    EXPECT_LT(std::ranges::count_if(drawn, [](int n) { return n > 1; }), whole ? 200 : 10);
  }
}

}  // namespace
}  // namespace murosimf::test
