/// pictured_test - surfaces that show pictures, by both renderers.
#include <cmath>
#include <tuple>

#include "murosimf/imaging/mip_picture.h"
#include "murosimf/imaging/srgb.h"
#include "murosimf/math/random.h"
#include "tests/render/drawn.h"

namespace murosimf::test {
namespace {

using imaging::ColorImage;
using imaging::Rgb;
using sensors::Perspective;
using sensors::View;

constexpr Rgb red{255, 0, 0}, green{0, 255, 0}, blue{0, 0, 255}, white{255, 255, 255}, black{0, 0, 0};

/// Red and green above, blue and white below.
ColorImage quarters(int half) {
  ColorImage image(2 * half, 2 * half);
  for (int v = 0; v < 2 * half; ++v) {
    for (int u = 0; u < 2 * half; ++u) image(u, v) = v < half ? (u < half ? red : green) : (u < half ? blue : white);
  }
  return image;
}

/// Squares of `side` pixels.
ColorImage checker(int size, int side) {
  ColorImage image(size, size);
  for (int v = 0; v < size; ++v) {
    for (int u = 0; u < size; ++u) image(u, v) = (u / side + v / side) % 2 == 0 ? white : black;
  }
  return image;
}

/// A square of 2 m at x = 0 that faces -x; seen from there, its picture, `repeats` times, begins at its lower left corner.
geometry::TriangleMesh square(float repeats) {
  return {{{0, 1, -1}, {0, -1, -1}, {0, -1, 1}, {0, 1, 1}},
          {{0, 1, 2}, {0, 2, 3}},
          {{{{0, 0}, {repeats, 0}, {repeats, repeats}}}, {{{0, 0}, {repeats, repeats}, {0, repeats}}}}};
}

/// A square in front of the eye; without a picture it has the color alone.
struct Pictured {
  std::shared_ptr<const imaging::MipPicture> picture;
  Color color{1, 1, 1};
  float repeats = 1;
  double distance = 2, tilt = 0;  // [m], [rad] of the upper side away from the eye

  [[nodiscard]] View draw(Device device, const Perspective& view, render::RendererOptions options) const {
    DrawnWorld world(device);
    world.add("square", std::make_shared<const Model>("square", Chain{}.base("square")), {distance, 0, 0},
              rotation_y(tilt));
    const auto appearance = [&](const Entity& /*entity*/) {
      render::EntityAppearance own;
      own.meshes.push_back({0, render::render_mesh_of(square(repeats), picture), color, true});
      return own;
    };
    std::unique_ptr<render::Renderer> renderer;
    if (device == Device::processor) {
      renderer = std::make_unique<render::SoftwareRenderer>(world.world, world.moving_entities, appearance, options);
    } else {
      renderer = std::make_unique<render::OpenGlRenderer>(world.world, world.moving_entities, appearance, options);
    }
    renderer->locate();
    View drawn;
    renderer->draw(view, {true, true, true}, 0, drawn);
    EXPECT_EQ(renderer->trouble(), "");
    return drawn;
  }
};

std::shared_ptr<const imaging::MipPicture> shared(const ColorImage& image) {
  return std::make_shared<const imaging::MipPicture>(imaging::mip_picture(image));
}

render::RendererOptions no_ground(int threads = 1) {
  render::RendererOptions options{.light = {.shadows = false}, .ground = false};
  options.threads = threads;
  return options;
}

Color color_of(const Rgb& pixel) { return {pixel.red / 255.0, pixel.green / 255.0, pixel.blue / 255.0}; }

void expect_near(const Rgb& found, const Rgb& expected, int apart, int u, int v) {
  EXPECT_NEAR(found.red, expected.red, apart) << u << ' ' << v;
  EXPECT_NEAR(found.green, expected.green, apart) << u << ' ' << v;
  EXPECT_NEAR(found.blue, expected.blue, apart) << u << ' ' << v;
}

class PicturedBy : public DrawnBy {
 protected:
  const Perspective view_ = along_x({0, 0, 0}, 0.6025, 241, 241);
  /// The color of a plain square in the middle of the picture.
  [[nodiscard]] Rgb plain(const Color& color, double tilt = 0) const {
    return Pictured{nullptr, color, 1, 2, tilt}.draw(GetParam(), view_, no_ground()).color(120, 120);
  }
};

// Law: light falls alike on a surface and on one pixel of its picture in the same color. The square covers pixels 21 to 220; the middles of
// 2 x 2 pixels of its picture are those of pixels.
TEST_P(PicturedBy, QuartersAreWhereTheirPlacesPutThem) {
  for (const int half : {1, 16}) {
    const View drawn = Pictured{shared(quarters(half))}.draw(GetParam(), view_, no_ground());
    for (const auto& [u, v, color] : {std::tuple{70, 70, red}, std::tuple{170, 70, green}, std::tuple{70, 170, blue},
                                      std::tuple{170, 170, white}}) {
      expect_near(drawn.color(u, v), plain(color_of(color)), 3, u, v);
      EXPECT_EQ(drawn.labels(u, v), drawn.labels(120, 120));
      EXPECT_NEAR(drawn.depth(u, v), 2, 1e-5);
    }
  }
}

// Law: the light of a picture times that of the color.
TEST_P(PicturedBy, ColorsMultiplyPictures) {
  Pictured square{shared(quarters(8)), {0.5, 0.25, 1}};
  const View drawn = square.draw(GetParam(), view_, no_ground());
  expect_near(drawn.color(70, 70), plain({0.5, 0, 0}), 3, 70, 70);
  expect_near(drawn.color(170, 170), plain({0.5, 0.25, 1}), 3, 170, 170);
}

// Closed form: the ray of each pixel meets the plane of the square at a place whose field of the checker is known.
TEST_P(PicturedBy, AreSeenInPerspective) {
  const double tilt = 1.0;
  const ColorImage image = checker(64, 8);
  const View drawn = Pictured{shared(image), {1, 1, 1}, 1, 2, tilt}.draw(GetParam(), view_, no_ground());
  const Rgb bright = plain({1, 1, 1}, tilt), dark = plain({0, 0, 0}, tilt);
  const Mat3d turn = rotation_y(tilt);
  int fields = 0;
  for (int v = 0; v < view_.height; ++v) {
    for (int u = 0; u < view_.width; ++u) {
      const Vec3d ray = ray_of(view_, u, v);
      const Vec3d from = transposed_times(turn, Vec3d{-2, 0, 0}), way = transposed_times(turn, ray);
      const Vec3d at = from - (from.x / way.x) * way;
      if (std::abs(at.y) > 1 || std::abs(at.z) > 1) continue;
      const double right = 4 * (1 - at.y), down = 4 * (1 - at.z);  // [fields]
      const auto is_inside = [](double x) { return std::abs(x - std::floor(x) - 0.5) < 0.2; };
      if (!is_inside(right) || !is_inside(down)) continue;
      ++fields;
      const bool light = (static_cast<int>(right) + static_cast<int>(down)) % 2 == 0;
      // where the square is seen at a flat angle the light comes from aside a little
      expect_near(drawn.color(u, v), light ? bright : dark, 12, u, v);
    }
  }
  EXPECT_GT(fields, 1000);
}

// Law: many pixels of a picture in one look like the mean of their light.
TEST_P(PicturedBy, AreMeansOfLightFromAfar) {
  const Pictured far{shared(checker(64, 1)), {1, 1, 1}, 8};
  const View drawn = far.draw(GetParam(), view_, no_ground());
  const double half = imaging::srgb_of_light(0.5);
  for (const int u : {60, 119, 120, 121, 180}) expect_near(drawn.color(u, 100), plain({half, half, half}), 4, u, 100);
}

INSTANTIATE_TEST_SUITE_P(Devices, PicturedBy, all_devices, name_of_device);

ColorImage noise(int width, int height) {
  ColorImage image(width, height);
  const RandomStream random(7, "noise");
  std::uint64_t i = 0;
  for (Rgb& pixel : image.pixels()) {
    const auto byte = [&] { return static_cast<std::uint8_t>(255 * random.uniform(i++)); };
    pixel = {byte(), byte(), byte()};
  }
  return image;
}

// Oracle: OpenGL chooses sizes by differences to neighboring pixels, and a driver may round them.
TEST(Pictured, LookTheSameByOpenGl) {
  if (!no_drawing().empty()) GTEST_SKIP() << no_drawing();
  const Perspective view = along_x({0, 0, 0.1}, 0.6, 240, 180);
  for (const double tilt : {0.0, 0.7, 1.2}) {
    for (const float repeats : {0.2F, 1.5F, 6.0F}) {
      for (const double alpha : {1.0, 0.5}) {
        const Pictured square{shared(noise(60, 37)), {1, 0.9, 0.8, alpha}, repeats, 1.6, tilt};
        const View one = square.draw(Device::opengl, view, no_ground()),
                   other = square.draw(Device::processor, view, no_ground());
        double mean = 0;
        for (int v = 0; v < view.height; ++v) {
          for (int u = 0; u < view.width; ++u) mean += std::abs(one.color(u, v).green - other.color(u, v).green);
        }
        EXPECT_LT(mean / (view.width * view.height), 2) << tilt << ' ' << repeats << ' ' << alpha;
        EXPECT_EQ(one.labels(120, 90), other.labels(120, 90));
      }
    }
  }
}

TEST(Pictured, HaveTheSameBitsWithAnyNumberOfThreads) {
  const Perspective view = along_x({0, 0, 0.1}, 0.6, 320, 240);
  const Pictured square{shared(noise(60, 37)), {1, 0.9, 0.8}, 3, 1.6, 0.8};
  render::RendererOptions one = no_ground(), three = no_ground(3);
  for (const int samples : {1, 4}) {
    one.samples = three.samples = samples;
    const View alone = square.draw(Device::processor, view, one),
               together = square.draw(Device::processor, view, three);
    EXPECT_TRUE(std::ranges::equal(alone.color.pixels(), together.color.pixels()));
  }
}

}  // namespace
}  // namespace murosimf::test
