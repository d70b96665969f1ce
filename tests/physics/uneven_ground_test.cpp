// Height fields and meshes as ground: what is flat in them is a plane, what is round a bowl, and nothing falls through.
#include <cmath>
#include <fstream>
#include <functional>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "murosimf/collision/queries.h"
#include "murosimf/model/properties.h"
#include "murosimf/scene/scene.h"
#include "tests/fixtures.h"
#include "tests/law.h"
#include "tests/temp_folder.h"
#include "tests/written_scene.h"

namespace murosimf {
namespace {

constexpr double g = 9.81;  // [m/s^2]

using Height = std::function<double(double x, double y)>;

/// A table of n x n heights over a square of `size` [m], whose middle is at x = y = 0.
std::string write_heights(const std::string& name, int n, double size, const Height& height) {
  const auto file = fixtures::temp_folder() / (name + ".csv");
  std::ofstream out(file);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const auto place = [&](int k) { return size * (static_cast<double>(k) / (n - 1) - 0.5); };
      out << (j > 0 ? "," : "") << fmt::format("{:.17g}", height(place(j), -place(i)));
    }
    out << "\n";
  }
  return file.string();
}

std::string ground_of(const std::string& file, double size, double z, const std::string& material = "carpet") {
  return fmt::format(
      "[[bodies]]\nname = 'ground'\nshape = 'heightfield'\nstatic = true\nfile = '{}'\nsize = [{}, {}]\nposition = [0, "
      "0, {}]\n"
      "material = '{}'\n",
      file, size, size, z, material);
}

std::string body_of(const std::string& shape, double x, double y, double z, const std::string& more = "") {
  return fmt::format("[[bodies]]\nname = 'body'\n{}\nmass = 0.5\nposition = [{}, {}, {}]\n{}\n", shape, x, y, z, more);
}

/// Half of an octahedron, higher than deep: what its hull stands on is a face.
std::string write_mesh() {
  const auto file = fixtures::temp_folder() / "top.obj";
  std::ofstream(file) << "v 0.1 0.01 0\nv -0.1 0 0\nv 0 0.1 0\nv 0.02 -0.1 0\nv 0 0 0.15\n"
                         "f 1 3 5\nf 3 2 5\nf 2 4 5\nf 4 1 5\nf 4 2 3\nf 4 3 1\n";
  return file.string();
}

struct Body {
  explicit Body(const std::string& text, double rate = 1000)
      : scene(fixtures::write_scene(fmt::format("rate = {}\nair.density = 0\nfield.goals = false\n{}", rate, text))),
        body(scene.simulation().world().entity("body").base()) {
    scene.simulation().initialize();
  }
  void run(double seconds) { scene.simulation().run(from_seconds(seconds)); }
  [[nodiscard]] Vec3d place() const { return body.get(properties::position); }
  [[nodiscard]] Vec3d velocity() const { return body.get(properties::linear_velocity); }

  scene::Scene scene;
  ObjectAccess body;
};

struct Kind {
  std::string name, shape;
};
void PrintTo(const Kind& kind, std::ostream* stream) { *stream << kind.name; }

std::vector<Kind> kinds() {
  return {{"sphere", "shape = 'sphere'\nradius = 0.05"},
          {"box", "shape = 'box'\nsize = [0.25, 0.13, 0.1]"},
          {"turned_box", "shape = 'box'\nsize = [0.25, 0.13, 0.1]\nheading_deg = 27"},
          {"capsule", "shape = 'capsule'\nradius = 0.05\nlength = 0.3\npitch_deg = 90"},
          {"cylinder", "shape = 'cylinder'\nradius = 0.08\nlength = 0.1"},
          {"wheel", "shape = 'cylinder'\nradius = 0.08\nlength = 0.1\nroll_deg = 90"},
          {"hull", "shape = 'mesh'\nfile = '" + write_mesh() + "'"}};
}

class OnFlatHeights : public testing::TestWithParam<Kind> {};
INSTANTIATE_TEST_SUITE_P(Shapes, OnFlatHeights, testing::ValuesIn(kinds()),
                         [](const auto& info) { return info.param.name; });

// On the lines of the grid and beside them. A tenth of a millimeter is how far bodies press points in.
TEST_P(OnFlatHeights, RestAsHighAsOnAPlane) {
  const std::string ground = ground_of(write_heights("flat", 41, 4, [](double, double) { return 0.0; }), 4, 0.5);
  for (const Vec3d& at : {Vec3d{0, 0, 0}, Vec3d{0.5, 0.313, 0}, Vec3d{-0.317, 0.209, 0}}) {
    Body on_plane(body_of(GetParam().shape, at.x, at.y, 0.02)),
        on_heights(body_of(GetParam().shape, at.x, at.y, 0.52) + ground);
    on_plane.run(2);
    on_heights.run(2);
    EXPECT_LT(norm(on_heights.velocity()), 1e-3);
    EXPECT_NEAR(on_heights.place().z - 0.5, on_plane.place().z, 1e-4) << at.x << " " << at.y;
    EXPECT_GT(on_plane.place().z, 0.02);
  }
}

// Over forty edges of cells of 5 cm, and over diagonals: none catches it. One percent of the way, or of a cell.
TEST_P(OnFlatHeights, SlideAndRollAsOnAPlane) {
  const std::string ground = ground_of(write_heights("wide", 81, 4, [](double, double) { return 0.0; }), 4, 0.5);
  const std::string motion = "velocity = [1.5, 0.4, 0]";
  const auto start = [&](double z) { return body_of(GetParam().shape, -1.503, -0.31, z, motion); };
  Body on_plane(start(0)), on_heights(start(0.5) + ground);
  const Vec3d plane_start = on_plane.place(), heights_start = on_heights.place();
  for (int i = 0; i < 10; ++i) {
    on_plane.run(0.1);
    on_heights.run(0.1);
    const Vec3d way = on_plane.place() - plane_start, other = on_heights.place() - heights_start;
    EXPECT_LT(norm(way - other), 0.01 * norm(way) + 5e-4) << i;
  }
  EXPECT_GT(norm(on_plane.place() - plane_start), 0.1);
}

// A ball of radius r that rolls without resistance in a bowl of radius R: (1 + 2/5) (R - r) phi'' = -g sin phi. At 0.2 rad a circle makes
// the period longer by phi^2 / 16, 0.25 %; a parabola is flatter there, by 3 / 2 phi^2 of its curvature, 6 % at the ends alone.
TEST(InABowl, ABallRollsWithThePeriodOfAPendulum) {
  constexpr double R = 1, r = 0.05, phi = 0.2;
  const auto bowl = [](double x, double y) { return (x * x + y * y) / (2 * R); };
  const std::string ground = ground_of(write_heights("bowl", 201, 2, bowl), 2, 0.1);
  const double x = (R - r) * std::sin(phi);
  Body ball(body_of(fmt::format("shape = 'sphere'\nradius = {}", r), x, 0.003, 0.1 + bowl(x, 0) + 1e-3) + ground +
                "[[materials]]\npair = ['plastic', 'carpet']\nfriction = 1\nrolling = 0\ntorsional = 0\n",
            2000);
  // of two passages in the same direction
  std::vector<double> passages;
  double before = x;
  for (int i = 0; i < 12000 && passages.size() < 2; ++i) {
    ball.run(5e-4);
    const double now = ball.place().x;
    if (before > 0 && now <= 0) passages.push_back(5e-4 * (i + before / (before - now)));
    before = now;
  }
  ASSERT_EQ(passages.size(), 2U);
  const double period = 2 * pi * std::sqrt(1.4 * (R - r) / g);
  EXPECT_NEAR(passages[1] - passages[0], period, 0.02 * period);
  EXPECT_LT(std::abs(ball.place().y), 0.01);
}

/// A plane of a mesh of two hundred triangles that rises along x, and what slides on it.
std::string slope(double angle) {
  const auto file = fixtures::temp_folder() / "slope.obj";
  std::ofstream out(file);
  constexpr int n = 11;
  const auto at = [](int k) { return 4.0 * k / (n - 1) - 2; };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) out << fmt::format("v {} {} {:.12f}\n", at(j), at(i), std::tan(angle) * at(j));
  }
  for (int i = 0; i + 1 < n; ++i) {
    for (int j = 0; j + 1 < n; ++j) {
      const int a = i * n + j + 1;
      out << fmt::format("f {} {} {} {}\n", a, a + 1, a + n + 1, a + n);
    }
  }
  return fmt::format(
      "[[bodies]]\nname = 'slope'\nshape = 'mesh'\nstatic = true\nfile = '{}'\nposition = [0, 0, 3]\nmaterial = "
      "'plastic'\n"
      "[[materials]]\npair = ['plastic', 'plastic']\nfriction = 0.4\n",
      file.string());
}

TEST(OnASlopeOfTriangles, ABoxSlidesIfItIsSteeperThanFriction) {
  constexpr double mu = 0.4;
  for (const double angle : {0.3, 0.36, 0.4, 0.5}) {
    const double x = 1.2, z = 3 + std::tan(angle) * x;
    // turned about y, so that its lower side lies on the slope: its lowest corner is half its length down
    const double lowest = z - 0.1 * std::sin(angle);
    Body box(body_of("shape = 'box'\nsize = [0.2, 0.15, 0.1]", x - 0.05 * std::sin(angle), 0.013, lowest,
                     fmt::format("pitch_deg = {}", -angle * 180 / pi)) +
             slope(angle));
    box.run(0.1);
    const Vec3d begin = box.place(), v = box.velocity();
    constexpr double t = 0.5;
    box.run(t);
    const double expected = std::max(0.0, g * (std::sin(angle) - mu * std::cos(angle)));
    const double way = norm(box.place() - begin) - norm(v) * t;
    EXPECT_NEAR(way, 0.5 * expected * t * t, 0.01 * 0.5 * expected * t * t + 1e-3) << angle;
    EXPECT_LT(std::abs(box.place().y - begin.y), 1e-3);
  }
}

// 5 mm up or down from one corner of a cell of 5 cm to the next.
TEST(OverBumps, ARobotWalks) {
  fixtures::Dice dice("bumps");
  const std::string ground =
      ground_of(write_heights("bumps", 101, 5, [&](double, double) { return dice.uniform(0, 0.005); }), 5, 0);
  scene::Scene scene(
      fixtures::write_scene("field.goals = false\n[[robots]]\nname = 'walker'\nmodel = 'kid21'\nlevel = "
                            "'articulated_dynamics'\ncommand = [0.1, 0, 0]\n"
                            "position = [-1, 0, 0.005]\n" +
                            ground));
  const ObjectAccess base = scene.simulation().world().entity("walker").base();
  scene.simulation().initialize();
  const Vec3d begin = base.get(properties::position);
  for (int i = 0; i < 10; ++i) {
    scene.simulation().run(from_seconds(1));
    const Vec3d now = base.get(properties::position);
    ASSERT_GT(now.z, begin.z - 0.05) << "it fell, or through, after " << i + 1 << " s";
    ASSERT_LT(now.z, begin.z + 0.02);
  }
  EXPECT_GT(base.get(properties::position).x, begin.x + 0.3);
}

TEST(OverHeights, RaysMeetTheSurface) {
  const auto hill = [](double x, double y) { return 0.1 * std::cos(2 * x) * std::cos(3 * y); };
  Body body(body_of("shape = 'sphere'\nradius = 0.05", 0, 0, 5) + ground_of(write_heights("hill", 201, 4, hill), 4, 1));
  collision::QueryScene queries(body.scene.simulation().world());
  queries.refresh();
  fixtures::Dice dice("rays");
  for (int i = 0; i < 200; ++i) {
    const double x = dice.uniform(-1.9, 1.9), y = dice.uniform(-1.9, 1.9);
    const auto hit = queries.cast({{x, y, 3}, {0, 0, -1}});
    ASSERT_TRUE(hit);
    // of a grid of 2 cm, a chord leaves the curve by an eighth of its second derivative times the square of the cell, twice
    EXPECT_NEAR(3 - hit->distance, 1 + hill(x, y), 2 * (0.4 + 0.9) * 0.02 * 0.02 / 8) << x << " " << y;
  }
}

// A ball that falls from 20 m, and one of 30 m/s, onto triangles of 5 cm.
TEST(OverHeights, NothingFastFallsThrough) {
  const std::string ground =
      ground_of(write_heights("thin", 41, 2, [](double x, double y) { return 0.05 * std::sin(5 * x + 3 * y); }), 2, 1);
  fixtures::Dice dice("falls");
  for (int i = 0; i < 20; ++i) {
    const Vec3d from = dice.vector(0.3);
    Body ball(body_of("shape = 'sphere'\nradius = 0.04", from.x, from.y, 1.5, "velocity = [1, 0, -30]") + ground);
    double lowest = 2;
    for (int k = 0; k < 20; ++k) {
      ball.run(0.01);
      const Vec3d r = ball.place();
      if (std::abs(r.x) < 1 && std::abs(r.y) < 1) lowest = std::min(lowest, r.z);
    }
    EXPECT_GT(lowest, 0.95) << from.x << " " << from.y;
    EXPECT_GT(ball.velocity().z, -3);
  }
}

}  // namespace
}  // namespace murosimf
