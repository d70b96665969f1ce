#include "murosimf/imaging/lens_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <gtest/gtest.h>

#include "murosimf/model/error.h"
#include "tests/law.h"

namespace murosimf::imaging {
namespace {

Lens barrel() {
  return Lens({.model = "plumb_bob",
               .width = 160,
               .height = 120,
               .fx = 104,
               .fy = 103,
               .cx = 79,
               .cy = 57,
               .coefficients = {-0.28, 0.08, 0.0007, -0.0003}});
}

/// Nothing is bent, but rows and columns are not at right angles.
Lens sheared() {
  LensSpec spec{.width = 160, .height = 120, .fx = 104, .fy = 103, .cx = 79, .cy = 57};
  spec.skew = 9;
  return Lens(spec);
}

/// 170 degrees from corner to corner.
Lens fisheye() {
  return Lens({.model = "equidistant",
               .width = 160,
               .height = 120,
               .fx = 67,
               .fy = 67,
               .cx = 80,
               .cy = 60,
               .coefficients = {0.0}});
}

/// A lens that looks backwards too: all six faces. There is nothing in the corners.
Lens world_queries() {
  return Lens({.model = "equidistant",
               .width = 361,
               .height = 361,
               .fx = 63,
               .fy = 63,
               .cx = 180,
               .cy = 180,
               .coefficients = {0.0}});
}

/// A smooth pattern on the sphere around the camera, as colors from 0 to 255 before rounding.
Vec3d pattern(const Vec3d& ray) {
  return {127.5 + 127 * std::sin(3 * ray.x + 1), 127.5 + 127 * std::sin(3 * ray.y + ray.z),
          127.5 + 127 * std::cos(2 * ray.z - ray.x)};
}

Rgb rounded(const Vec3d& c) {
  const auto byte = [](double x) { return static_cast<std::uint8_t>(std::lround(x)); };
  return {byte(c.x), byte(c.y), byte(c.z)};
}

/// The ray of a view's pixel in the camera's frame, with z = 1 in the view's.
Vec3d view_ray(const ViewWindow& view, int u, int v) {
  return view.axes * Vec3d{view.left + (u + 0.5) / view.width * (view.right - view.left),
                           view.top + (v + 0.5) / view.height * (view.bottom - view.top), 1};
}

/// What a renderer makes of `value`(ray in the camera's frame with z = 1 in the view's).
template <class Pixel, class Value>
std::vector<Image<Pixel>> rendered(const LensMap& map, const Value& value) {
  std::vector<Image<Pixel>> pictures;
  for (const ViewWindow& view : map.views()) {
    Image<Pixel> picture(view.width, view.height);
    for (int v = 0; v < view.height; ++v) {
      for (int u = 0; u < view.width; ++u) picture(u, v) = value(view_ray(view, u, v));
    }
    pictures.push_back(std::move(picture));
  }
  return pictures;
}

Vec3d unit(const Vec3d& v) { return 1 / norm(v) * v; }

Rgb color_along(const Vec3d& ray) { return rounded(pattern(unit(ray))); }

double distance(const Rgb& seen, const Vec3d& color) {
  return std::max({std::fabs(seen.red - color.x), std::fabs(seen.green - color.y), std::fabs(seen.blue - color.z)});
}

/// The largest difference between the pattern through the lens and its formula.
law::Worst pattern_error(const Lens& lens, const LensMap& map) {
  const auto views = rendered<Rgb>(map, color_along);
  ColorImage picture(map.width(), map.height());
  map.apply(std::span<const ColorImage>(views), picture, {0, picture.height()});
  law::Worst worst;
  for (int v = 0; v < picture.height(); ++v) {
    for (int u = 0; u < picture.width(); ++u) {
      const auto ray = lens.ray({double(u), double(v)});
      worst.see(distance(picture(u, v), ray ? pattern(*ray) : Vec3d{}), u, v);
    }
  }
  return worst;
}

TEST(LensMap, ShowsThePatternWhereTheFormulaHasIt) {
  struct Case {
    const char* name;
    Lens lens;
    std::size_t views;
  };
  for (const auto& [name, lens, views] :
       {Case{"plumb_bob, one view", barrel(), 1}, Case{"perspective with skew, one view", sheared(), 1},
        Case{"equidistant, 170 deg, five faces", fisheye(), 5},
        Case{"equidistant, 360 deg, six faces", world_queries(), 6}}) {
    const LensMap map(lens);
    EXPECT_EQ(map.views().size(), views) << name;
    EXPECT_FALSE(map.plain());
    // half a level of rounding in the view, half in the picture, 1/512 px in the place, and the pattern's curvature
    law::expect_below({.law = "picture through a lens: color of a pattern on the sphere",
                       .level = name,
                       .source = "the pattern's formula along the pixel's ray"},
                      pattern_error(lens, map), 2.5, "of 255");
  }
}

TEST(LensMap, LeavesPlainPicturesAsTheyAre) {
  const Lens lens({.width = 64, .height = 48, .fx = 50, .fy = 51, .cx = 30, .cy = 25});
  const LensMap map(lens);
  EXPECT_TRUE(map.plain());
  ASSERT_EQ(map.views().size(), 1U);
  EXPECT_EQ(map.views()[0].width, 64);
  EXPECT_EQ(map.views()[0].height, 48);
  const auto views = rendered<Rgb>(map, color_along);
  ColorImage picture(64, 48);
  map.apply(std::span<const ColorImage>(views), picture, {0, 48});
  for (int v = 0; v < 48; ++v) {
    for (int u = 0; u < 64; ++u) {
      ASSERT_EQ(picture(u, v), views[0](u, v));
      ASSERT_LE(distance(picture(u, v), pattern(lens.ray({double(u), double(v)}).value())), 0.5 + 1e-9);
    }
  }
}

TEST(LensMap, HasFinerViewsIfAsked) {
  const auto coarse = LensMap(barrel(), 0.5), fine = LensMap(barrel(), 2);
  EXPECT_NEAR(double(fine.views()[0].width) / coarse.views()[0].width, 4, 0.2);
  law::Worst wrong = pattern_error(barrel(), fine);
  EXPECT_LT(law::Measured(wrong).value, 1.6);
  EXPECT_THROW(LensMap(barrel(), 0), SetupError);
  EXPECT_THROW(LensMap(barrel(), std::nan("")), SetupError);
}

TEST(LensMap, IsAsFineAsTheLensInItsCenter) {
  const ViewWindow view = LensMap(barrel()).views()[0];
  EXPECT_NEAR(view.width / (view.right - view.left), 104, 1);
  EXPECT_NEAR(view.height / (view.bottom - view.top), 104, 1);
}

TEST(LensMap, ReadsOnlyTheRowsThatABandNeeds) {
  const LensMap map(fisheye());
  auto views = rendered<Rgb>(map, color_along);
  ColorImage whole(map.width(), map.height()), band(map.width(), map.height());
  map.apply(std::span<const ColorImage>(views), whole, {0, whole.height()});
  const Rows rows{40, 7};
  for (std::size_t i = 0; i < views.size(); ++i) {
    const Rows needed = map.needed(i, rows);
    for (int v = 0; v < views[i].height(); ++v) {
      if (v >= needed.first && v < needed.first + needed.count) continue;
      std::ranges::fill(views[i].row(v), Rgb{1, 2, 3});
    }
  }
  map.apply(std::span<const ColorImage>(views), band, rows);
  for (int v = 0; v < band.height(); ++v) {
    const bool inside = v >= rows.first && v < rows.first + rows.count;
    for (int u = 0; u < band.width(); ++u) ASSERT_EQ(band(u, v), inside ? whole(u, v) : Rgb{}) << u << ' ' << v;
  }
}

/// Everything in the picture lies on the inside of a box around the camera, whose planes are exact in 1 / z.
float box_depth(const Vec3d& ray) {  // z in the view's frame is 1, so the factor is that depth
  const double s = std::max({std::fabs(ray.x) / 2.1, std::fabs(ray.y) / 1.4, std::fabs(ray.z) / 3.7});
  return static_cast<float>(1 / s);
}

/// The wall of the box that a ray meets: +-1, +-2 or +-3 for x, y, z; 0 if there is no ray.
int wall(const std::optional<Vec3d>& ray) {
  if (!ray) return 0;
  const double x = std::fabs(ray->x) / 2.1, y = std::fabs(ray->y) / 1.4, z = std::fabs(ray->z) / 3.7;
  if (x >= y && x >= z) return ray->x > 0 ? 1 : -1;
  if (y >= z) return ray->y > 0 ? 2 : -2;
  return ray->z > 0 ? 3 : -3;
}

/// All around a pixel the lens sees the same wall.
bool amid_a_wall(const Lens& lens, int u, int v) {
  const int here = wall(lens.ray({double(u), double(v)}));
  for (const double du : {-1.5, 0.0, 1.5}) {
    for (const double dv : {-1.5, 0.0, 1.5}) {
      if (wall(lens.ray({u + du, v + dv})) != here) return false;
    }
  }
  return here != 0;
}

TEST(LensMap, KeepsDepthExactOnPlanes) {
  for (const Lens& lens : {barrel(), fisheye(), world_queries()}) {
    const LensMap map(lens, 2);
    const auto views = rendered<float>(map, box_depth);
    DepthImage picture(map.width(), map.height());
    map.apply(std::span<const DepthImage>(views), picture, {0, picture.height()});
    int pixels = 0;
    law::Worst worst;
    for (int v = 0; v < picture.height(); ++v) {
      for (int u = 0; u < picture.width(); ++u) {
        if (!amid_a_wall(lens, u, v)) continue;
        ++pixels;
        const Vec3d ray = lens.ray({double(u), double(v)}).value();
        const double range = box_depth(ray);
        worst.see(std::fabs(picture(u, v) - range * ray.z) / range, u, v);
      }
    }
    EXPECT_GT(pixels, picture.width() * picture.height() / 2);
    law::expect_below({.law = "picture through a lens: depth of planes",
                       .level = fmt::format("{}, {} views", lens.spec().model, map.views().size()),
                       .source = "box around the camera"},
                      worst, 2e-4, "of the range");
  }
}

TEST(LensMap, TakesTheNearestDepthAtEdges) {
  const LensMap map(barrel());
  const auto wall = [](const Vec3d& ray) { return ray.x < 0.1 ? 2.0F : std::numeric_limits<float>::infinity(); };
  const auto views = rendered<float>(map, wall);
  DepthImage picture(map.width(), map.height());
  map.apply(std::span<const DepthImage>(views), picture, {0, picture.height()});
  for (const float depth : picture.pixels()) EXPECT_TRUE(depth == 2 || std::isinf(depth)) << depth;
}

TEST(LensMap, TakesTheNearestLabel) {
  const Lens lens = fisheye();
  const LensMap map(lens, 2);
  const auto label = [](const Vec3d& ray) {
    const Vec3d r = unit(ray);
    return static_cast<std::uint16_t>(1 + std::floor(4 + 4 * r.x) + 10 * std::floor(4 + 4 * r.y));
  };
  const auto views = rendered<std::uint16_t>(map, label);
  LabelImage picture(map.width(), map.height());
  map.apply(std::span<const LabelImage>(views), picture, {0, picture.height()});
  int others = 0;
  for (int v = 0; v < picture.height(); ++v) {
    for (int u = 0; u < picture.width(); ++u) {
      // a label that is right half a pixel of the view away is right
      bool right = false;
      for (const double du : {-0.4, 0.0, 0.4}) {
        for (const double dv : {-0.4, 0.0, 0.4}) right |= label(lens.ray({u + du, v + dv}).value()) == picture(u, v);
      }
      if (!right) ++others;
    }
  }
  EXPECT_EQ(others, 0);
}

TEST(LensMap, IsBlackBeyondTheFold) {
  LensSpec spec = barrel().spec();
  spec.coefficients = {-0.5, 0, 0, 0};  // folds inside the picture
  const Lens lens(spec);
  const LensMap map(lens);
  const auto colors = rendered<Rgb>(map, [](const Vec3d&) { return Rgb{200, 100, 50}; });
  const auto depths = rendered<float>(map, [](const Vec3d&) { return 1.0F; });
  const auto labels = rendered<std::uint16_t>(map, [](const Vec3d&) { return std::uint16_t{7}; });
  const Rows all{0, map.height()};
  ColorImage color(map.width(), map.height(), {9, 9, 9});
  DepthImage depth(map.width(), map.height());
  LabelImage label(map.width(), map.height(), 9);
  map.apply(std::span<const ColorImage>(colors), color, all);
  map.apply(std::span<const DepthImage>(depths), depth, all);
  map.apply(std::span<const LabelImage>(labels), label, all);
  int blind = 0;
  for (int v = 0; v < map.height(); ++v) {
    for (int u = 0; u < map.width(); ++u) {
      const bool seen = lens.ray({double(u), double(v)}).has_value();
      blind += seen ? 0 : 1;
      ASSERT_EQ(color(u, v), seen ? (Rgb{200, 100, 50}) : Rgb{});
      ASSERT_EQ(depth(u, v), seen ? 1.0F : std::numeric_limits<float>::infinity());
      ASSERT_EQ(label(u, v), seen ? 7 : 0);
    }
  }
  EXPECT_GT(blind, 100);
}

}  // namespace
}  // namespace murosimf::imaging
