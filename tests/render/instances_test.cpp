/// instances_test - objects of a view: no visible one is left out, and round ones have enough sides.
#include "murosimf/render/instances.h"

#include <cmath>
#include <set>

#include "murosimf/math/random.h"
#include "tests/render/drawn.h"

namespace murosimf::test {
namespace {

using render::InstanceGroup;
using render::InstanceList;
using render::RenderScene;
using sensors::Perspective;

struct Ball {
  Vec3d place;
  double radius = 0;
};

class Uniform {
 public:
  double operator()(double low, double high) { return low + (high - low) * stream_.uniform(next_++); }

 private:
  RandomStream stream_{7, "instances_test"};
  std::uint64_t next_ = 0;
};

/// A view from anywhere, to anywhere, not symmetric.
Perspective any_view(Uniform& random) {
  Perspective view;
  view.eye = {random(-1, 1), random(-1, 1), random(-1, 1)};
  view.axes = rotation_z(random(-pi, pi)) * rotation_y(random(-pi, pi)) * rotation_x(random(-pi, pi));
  view.left = random(-1.8, -0.1);
  view.right = random(0.1, 1.8);
  view.top = random(-1.5, -0.1);
  view.bottom = random(0.1, 1.5);
  view.width = 320;
  view.height = 240;
  return view;
}

bool sees(const Perspective& view, const Vec3d& point) {
  const Vec3d p = transposed_times(view.axes, point - view.eye);
  return p.z > 0 && p.x > view.left * p.z && p.x < view.right * p.z && p.y > view.top * p.z && p.y < view.bottom * p.z;
}

/// Points all over a sphere, by the golden angle.
Vec3d on_sphere(int i, int count) {
  const double z = 1 - (2 * i + 1.0) / count, r = std::sqrt(1 - z * z), angle = 2.399963 * i;
  return {r * std::cos(angle), r * std::sin(angle), z};
}

struct Drawn {
  std::set<std::uint32_t> labels;
  std::map<std::uint32_t, std::size_t> triangles;  // by label
};

class Instances : public testing::Test {
 protected:
  Drawn draw(const std::vector<Ball>& balls, const render::Projection& view, bool depths = false) {
    DrawnWorld world;
    for (const Ball& ball : balls)
      world.add_ball("b" + std::to_string(world.moving_entities.size()), ball.radius, ball.place);
    RenderScene render_scene(world.world, world.moving_entities);
    render_scene.locate();
    const auto catalog = render::solid_catalog(render_scene.meshes());
    list_.fill(render_scene, view, depths, 0, catalog);
    Drawn drawn;
    for (const InstanceGroup& group : list_.groups()) {
      for (const auto& instance : list_.instances().subspan(group.first, group.count)) {
        EXPECT_TRUE(drawn.labels.insert(instance.label).second) << "once";
        drawn.triangles[instance.label] = catalog.meshes[group.solid].triangle_count();
      }
    }
    return drawn;
  }
  InstanceList list_;
};

TEST_F(Instances, LeaveNothingOutThatCanBeSeen) {
  Uniform random;
  int visible = 0, dropped = 0, total = 0;
  for (int i = 0; i < 20; ++i) {
    const Perspective view = any_view(random);
    std::vector<Ball> balls;
    for (int k = 0; k < 60; ++k) {
      balls.push_back({{random(-4, 4), random(-4, 4), random(-4, 4)}, random(0.02, 0.9)});
    }
    const Drawn drawn = draw(balls, view);
    for (std::size_t k = 0; k < balls.size(); ++k) {
      const bool is_drawn = drawn.labels.contains(sensors::label_moving_entity + static_cast<std::uint32_t>(k));
      bool is_seen = false;
      for (int p = 0; p < 500 && !is_seen; ++p) {
        is_seen = sees(view, balls[k].place + balls[k].radius * on_sphere(p, 500));
      }
      EXPECT_TRUE(is_drawn || !is_seen) << "ball " << k << " of view " << i;
      visible += is_seen ? 1 : 0;
      dropped += is_drawn ? 0 : 1;
      ++total;
    }
  }
  EXPECT_GT(visible, 100);
  EXPECT_GT(dropped, (total - visible) / 2) << "most of what cannot be seen";
}

/// A sphere is in a parallel picture if its middle is less than its radius away from the picture's rectangle.
TEST_F(Instances, OfParallelRaysAreAllThatTouchThePicture) {
  Uniform random;
  int visible = 0;
  for (int i = 0; i < 20; ++i) {
    const render::ParallelView view{.center = {random(-1, 1), random(-1, 1), random(-1, 1)},
                                    .axes = rotation_z(random(-pi, pi)) * rotation_y(random(-pi, pi)) *
                                            rotation_x(random(-pi, pi)),
                                    .pixel = random(0.002, 0.02),
                                    .width = 320,
                                    .height = 240};
    std::vector<Ball> balls;
    for (int k = 0; k < 60; ++k) {
      balls.push_back({{random(-4, 4), random(-4, 4), random(-4, 4)}, random(0.02, 0.9)});
    }
    const Drawn drawn = draw(balls, view);
    for (std::size_t k = 0; k < balls.size(); ++k) {
      const Vec3d p = transposed_times(view.axes, balls[k].place - view.center);
      const double aside = std::max(0.0, std::abs(p.x) - 160 * view.pixel);
      const double above = std::max(0.0, std::abs(p.y) - 120 * view.pixel);
      const bool is_drawn = drawn.labels.contains(sensors::label_moving_entity + static_cast<std::uint32_t>(k));
      if (std::hypot(aside, above) < balls[k].radius) {
        EXPECT_TRUE(is_drawn) << "ball " << k << " of view " << i;
        ++visible;
      } else if (std::max(aside, above) > balls[k].radius) {
        EXPECT_FALSE(is_drawn) << "ball " << k << " of view " << i;
      }
    }
  }
  EXPECT_GT(visible, 100);
}

TEST_F(Instances, LeaveOutWhatIsBehindAndWhoLooks) {
  const Perspective view = along_x({0, 0, 0}, 0.5, 100, 100);
  const Drawn drawn = draw({{{-2, 0, 0}, 0.5}, {{2, 0, 0}, 0.5}, {{2, 3, 0}, 0.5}, {{0.2, 0, 0}, 0.5}}, view);
  EXPECT_EQ(drawn.labels,
            (std::set<std::uint32_t>{sensors::label_moving_entity + 1, sensors::label_moving_entity + 3}));

  DrawnWorld world;
  world.add_ball("own", 0.1, {1, 0, 0});
  world.add_ball("other", 0.1, {2, 0, 0});
  RenderScene render_scene(world.world, world.moving_entities);
  render_scene.locate();
  Perspective own = view;
  own.without = world.moving_entities[0];
  list_.fill(render_scene, own, false, 0, render::solid_catalog(render_scene.meshes()));
  ASSERT_EQ(list_.instances().size(), 1u);
  EXPECT_EQ(list_.instances()[0].label, sensors::label_moving_entity + 1u);
}

/// Sides of a round solid, which has segments (segments - 2) triangles of a sphere.
double segments_of(std::size_t sphere_triangles) { return 1 + std::sqrt(1.0 + static_cast<double>(sphere_triangles)); }

/// [1] by which a polygon of the circle's area is off from it.
double off_circle(double segments) {
  const double r = std::sqrt(2 * pi / (segments * std::sin(2 * pi / segments)));
  return std::max(r - 1, 1 - r * std::cos(pi / segments));
}

/// [px] by which the outline of a sphere in the picture is off if its radius is off by a share.
double off_in_picture(const Perspective& view, const Ball& ball, double share) {
  const Vec3d middle = transposed_times(view.axes, ball.place - view.eye);
  const double d = norm(middle), sine = ball.radius / d, cosine = std::sqrt(1 - sine * sine);
  const Vec3d forward = (1 / d) * middle;
  const Vec3d side = (1 / std::hypot(middle.x, middle.z)) * Vec3d{middle.z, 0, -middle.x}, up = cross(forward, side);
  const auto pixel = [&](const Vec3d& p) {
    return Vec3d{p.x / p.z * view.width / (view.right - view.left), p.y / p.z * view.height / (view.bottom - view.top),
                 0};
  };
  double worst = 0;
  for (int i = 0; i < 32; ++i) {
    const Vec3d across = std::cos(i * pi / 16) * side + std::sin(i * pi / 16) * up;
    const Vec3d out = cosine * across - sine * forward;  // at the outline, across the line of sight
    const Vec3d edge = middle + ball.radius * out;
    if (edge.z <= 0 || !sees(view, view.eye + view.axes * edge)) continue;
    worst = std::max(worst, norm(pixel(edge + share * ball.radius * out) - pixel(edge)));
  }
  return worst;
}

TEST_F(Instances, RoundThingsAreOffByAQuarterOfAPixelAtMost) {
  Uniform random;
  std::set<std::size_t> levels;
  for (int i = 0; i < 300; ++i) {
    Perspective view = any_view(random);
    view.width = view.height = static_cast<int>(random(40, 1200));
    const double far = random(0.5, 12);
    const Vec3d ray{random(view.left, view.right), random(view.top, view.bottom), 1};
    const Ball ball{view.eye + view.axes * (far * ray), random(0.02, 0.3)};
    const Drawn drawn = draw({ball}, view);
    ASSERT_EQ(drawn.triangles.size(), 1u);
    const double segments = segments_of(drawn.triangles.begin()->second);
    levels.insert(drawn.triangles.begin()->second);
    if (segments < 63) {
      EXPECT_LT(off_in_picture(view, ball, off_circle(segments)), 0.26) << segments << " segments, " << far << " m";
    }
  }
  EXPECT_EQ(levels.size(), 4u) << "all levels are there";
}

TEST_F(Instances, OfParallelRaysAreAsRoundWhereverTheyAre) {
  std::set<std::size_t> levels;
  for (const double pixel : {0.0005, 0.002, 0.01, 0.1}) {
    std::set<std::size_t> triangles;
    for (const double distance : {-50.0, 0.0, 0.5, 50.0}) {
      const render::ParallelView view{.pixel = pixel, .width = 100, .height = 100};
      triangles.insert(draw({{{0, 0, distance}, 0.1}}, view).triangles.begin()->second);
    }
    ASSERT_EQ(triangles.size(), 1u);
    levels.insert(*triangles.begin());
    const double segments = segments_of(*triangles.begin());
    if (segments < 63) {
      EXPECT_LT(0.1 * off_circle(segments) / pixel, 0.26) << pixel;
    }
  }
  EXPECT_GE(levels.size(), 3u);
}

TEST_F(Instances, DepthsAndMeasuringAskForMore) {
  const Perspective view = along_x({0, 0, 0}, 0.5, 60, 60);
  const auto triangles = [&](double distance, bool depths, bool finest) {
    Perspective other = view;
    other.finest = finest;
    return draw({{{distance, 0, 0}, 0.1}}, other, depths).triangles.begin()->second;
  };
  std::size_t last = triangles(0.3, false, false);
  for (double distance = 0.4; distance < 10; distance += 0.2) {
    const std::size_t now = triangles(distance, false, false);
    EXPECT_LE(now, last) << "never more farther away";
    last = now;
    EXPECT_LT(0.1 * off_circle(segments_of(triangles(distance, true, false))), 0.52e-3);
    EXPECT_EQ(segments_of(triangles(distance, false, true)), 64);
  }
  EXPECT_EQ(segments_of(last), 8);
}

}  // namespace
}  // namespace murosimf::test
