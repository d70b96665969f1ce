/// look_test - patterns and surroundings are where they belong, and change nothing that is measured.
#include "murosimf/render/look.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include "murosimf/render/contact_shadows.h"
#include "tests/render/drawn.h"

namespace murosimf::test {
namespace {

using sensors::View;

class Look : public DrawnBy {};
INSTANTIATE_TEST_SUITE_P(Devices, Look, all_devices, name_of_device);

render::RendererOptions in_light(std::string_view name) {
  render::RendererOptions options;
  for (const render::NamedLight& named : render::lights()) {
    if (named.name == name) options.light = named.light;
  }
  options.light.shadows = false;
  return options;
}

/// A field with nets, a ball and a plate that is seen through.
void fill(DrawnWorld& world) {
  world.world.add("field",
                  scene_file::field_model(scene_file::kid_size_2023, "carpet", {}, {.goals = true, .nets = true}));
  world.add_ball("ball", 0.07, {2, 0.1, 0.07});
  PlacedShape plate;
  plate.shape = Box{{0.01, 0.3, 0.3}};
  plate.color = {0, 0, 1, 0.5};
  world.add("plate",
            std::make_shared<const Model>("plate", Chain{}.base("plate").with(properties::shapes, Shapes{plate})),
            {3, -0.8, 0.3});
}

// Law: looks are for the eye; labels and depths are those of the same scene without patterns, bit for bit.
TEST_P(Look, ChangesNeitherLabelsNorDepths) {
  DrawnWorld world(GetParam());
  fill(world);
  const auto view = along_x({0, 0, 0.5}, 0.9, 320, 240);
  const View plain = world.draw(view);
  for (const render::NamedLight& named : render::lights()) {
    const View drawn = world.draw(view, {true, true, true}, in_light(named.name));
    int wrong = 0, same_color = 0;
    for (int v = 0; v < view.height; ++v) {
      for (int u = 0; u < view.width; ++u) {
        const bool same = drawn.labels(u, v) == plain.labels(u, v) && drawn.depth(u, v) == plain.depth(u, v);
        wrong += same ? 0 : 1;
        same_color += drawn.color(u, v) == plain.color(u, v) ? 1 : 0;
      }
    }
    EXPECT_EQ(wrong, 0) << named.name;
    const double same = static_cast<double>(same_color) / (view.width * view.height);
    EXPECT_EQ(same > 0.05, named.name == "plain") << named.name << ": " << same;
  }
}

// Law: patterns are means over pixels: from far the field has the color that it has without them.
TEST_P(Look, FromFarTheFieldIsAsBrightAsItIs) {
  DrawnWorld world(GetParam());
  world.world.add("field", scene_file::field_model(scene_file::kid_size_2008, "carpet", {}, {.goals = false}));
  auto down = along_x({0.75, 1, 6}, 0.02, 12, 12);  // between lines, in one stripe; pixels of 2 cm
  down.axes = {{0, -1, 0}, {-1, 0, 0}, {0, 0, -1}};
  auto near = down;
  near.eye.z = 0.6;
  render::RendererOptions with = in_light("hall"), without = with;
  without.light.patterns = false;
  const auto mean_and_spread = [&](const sensors::Perspective& view, const render::RendererOptions& options) {
    const View drawn = world.draw(view, {}, options);
    double sum = 0, squares = 0;
    for (const imaging::Rgb& pixel : drawn.color.pixels()) {
      sum += pixel.green;
      squares += pixel.green * pixel.green;
    }
    const double count = static_cast<double>(drawn.color.pixels().size()), mean = sum / count;
    return std::pair{mean, std::sqrt(std::max(0.0, squares / count - mean * mean))};
  };
  const auto [even, none] = mean_and_spread(down, without);
  const auto [far, little] = mean_and_spread(down, with);
  const auto [close, much] = mean_and_spread(near, with);
  EXPECT_LT(none, 0.5);
  EXPECT_NEAR(far, even, 0.08 * even) << "but for the stripe";
  EXPECT_GT(much, 2 * little) << "fibers are seen from near";
}

TEST_P(Look, SurroundingsEndTheVoid) {
  DrawnWorld world(GetParam());
  world.add_field();
  const auto level = along_x({-2, 0, 0.5}, 0.8, 160, 120);
  for (const render::NamedLight& named : render::lights()) {
    const View drawn = world.draw(level, {}, in_light(named.name));
    std::set<std::array<int, 3>> colors;
    for (int u = 0; u < 160; ++u) {
      for (int v = 0; v < 55; ++v) {  // above the horizon
        const imaging::Rgb pixel = drawn.color(u, v);
        colors.insert({pixel.red, pixel.green, pixel.blue});
      }
    }
    EXPECT_EQ(colors.size() > 20, named.name != "plain") << named.name << ": " << colors.size();
  }
}

TEST_P(Look, BallsHavePanels) {
  DrawnWorld world(GetParam());
  PlacedShape ball;
  ball.shape = Sphere{0.2};
  ball.color = {0.9, 0.9, 0.9};
  world.add("ball", std::make_shared<const Model>("ball", Chain{}.base("ball").with(properties::shapes, Shapes{ball})),
            {1.5, 0, 0.5});
  const auto view = along_x({0, 0, 0.5}, 0.13, 200, 200);
  const auto dark_share = [&](const render::RendererOptions& options) {
    const View drawn = world.draw(view, {true, false, true}, options);
    int dark = 0, all = 0;
    for (int v = 0; v < 200; ++v) {
      for (int u = 0; u < 200; ++u) {
        if (drawn.labels(u, v) != sensors::label_moving_entity) continue;
        ++all;
        dark += drawn.color(u, v).green < 80 ? 1 : 0;
      }
    }
    return static_cast<double>(dark) / all;
  };
  render::RendererOptions plain = in_light("hall");
  plain.light.patterns = false;
  EXPECT_LT(dark_share(plain), 0.02);
  // twelve pentagons are 28 % of a truncated icosahedron's surface (its edge is 1): 12 * 1.7205 / 72.607
  EXPECT_NEAR(dark_share(in_light("hall")), 0.284, 0.1);
}

TEST(LookSurfaces, WallsStandAroundTheFieldAndFaceIt) {
  const Markings markings = scene_file::field_markings(scene_file::kid_size_2008);
  const render::Surroundings around{.kind = render::Surroundings::Kind::hall};
  const render::LookSurface walls = render::hall_walls(around, &markings);
  ASSERT_EQ(walls.triangles.size(), 24U);
  const auto place = [&](std::size_t i) {
    const auto& p = walls.corners[walls.triangles[i]].place;
    return Vec3d{p[0], p[1], p[2]};
  };
  for (std::size_t i = 0; i < walls.triangles.size(); i += 3) {
    const Vec3d normal = cross(place(i + 1) - place(i), place(i + 2) - place(i));
    EXPECT_GT(dot(normal, Vec3d{0, 0, 1} - place(i)), 0) << i;
    EXPECT_TRUE(std::abs(place(i).x) > markings.half_length + 1 && std::abs(place(i).y) > markings.half_width + 1);
  }
}

TEST(LookSurfaces, NetsHangBetweenGoalAndGround) {
  const render::GoalNet net{.side = -1, .front = 4.6, .rear = 5.1, .half_width = 1.3, .high = 1.25, .low = 0};
  const render::LookSurface surface = render::hanging_nets({net});
  double lowest = 9, highest = -9;
  for (const render::LookCorner& corner : surface.corners) {
    EXPECT_LE(corner.place[0], -4.6F + 1e-5F);
    EXPECT_GE(corner.place[0], -5.1F - 1e-5F);
    EXPECT_LE(std::abs(corner.place[1]), 1.3F + 1e-5F);
    lowest = std::min(lowest, static_cast<double>(corner.place[2]));
    highest = std::max(highest, static_cast<double>(corner.place[2]));
  }
  EXPECT_NEAR(lowest, 0, 1e-5);
  EXPECT_NEAR(highest, 1.25, 1e-5);
}

TEST(LookSurfaces, ThePileIsEvenInTheMean) {
  const std::vector<std::uint8_t>& pile = render::pile();
  ASSERT_EQ(pile.size(), static_cast<std::size_t>(render::pile_side * render::pile_side));
  EXPECT_NEAR(std::accumulate(pile.begin(), pile.end(), 0.0) / static_cast<double>(pile.size()), 128, 1);
}

TEST(ContactShadows, LieBelowWhatIsCloseToTheGround) {
  DrawnWorld world;
  world.add_ball("low", 0.07, {1, 2, 0.08});
  world.add_ball("high", 0.07, {3, 0, 0.4});
  PlacedShape foot;
  foot.shape = Box{{0.1, 0.04, 0.01}};
  world.add("foot", std::make_shared<const Model>("foot", Chain{}.base("foot").with(properties::shapes, Shapes{foot})),
            {0, 0, 0.01}, rotation_z(0.5));
  render::RenderScene scene(world.world, world.moving_entities);
  scene.locate();
  const auto shadows = render::contact_shadows(scene, 0, nullptr);
  ASSERT_EQ(shadows.size(), 2U);
  EXPECT_EQ(shadows[0].middle.x, 1);
  EXPECT_LT(shadows[0].half_length + shadows[0].reach, 0.08);
  EXPECT_LT(shadows[0].darkness, shadows[1].darkness);
  EXPECT_NEAR(std::abs(dot(shadows[1].along, Vec3d{std::cos(0.5), std::sin(0.5), 0})), 1, 1e-9);
  EXPECT_NEAR(shadows[1].half_length, 0.1, 1e-9);
  EXPECT_NEAR(shadows[1].half_width, 0.04, 1e-9);
  EXPECT_EQ(render::contact_shadows(scene, 0, world.moving_entities[0]).size(), 1U);
}

// A mesh has a piece for each of its colors, and darkens the ground once.
TEST(ContactShadows, AreOneForAMeshInSeveralColors) {
  DrawnWorld world;
  world.add_ball("two_colors", 0.07, {1, 2, 0.01});
  const auto triangle = [](double from, double to) {
    const std::vector<Vec3d> corners{{from, -0.1, 0}, {to, 0, 0}, {from, 0.1, 0.02}};
    const std::vector<std::array<std::uint32_t, 3>> triangles{{0, 1, 2}};
    return render::render_mesh_of({corners, triangles});
  };
  const auto in_two_colors = [&](const Entity& /*entity*/) {
    render::EntityAppearance appearance;
    appearance.meshes.push_back({0, triangle(-0.1, 0), {1, 0, 0}});
    appearance.meshes.push_back({0, triangle(0, 0.3), {0, 0, 1}});
    return appearance;
  };
  render::RenderScene scene(world.world, world.moving_entities, in_two_colors);
  scene.locate();
  const auto shadows = render::contact_shadows(scene, 0, nullptr);
  ASSERT_EQ(shadows.size(), 1U);
  EXPECT_NEAR(shadows[0].middle.x, 1.1, 1e-6);
  EXPECT_NEAR(shadows[0].half_length, 0.2, 1e-6);
}

}  // namespace
}  // namespace murosimf::test
