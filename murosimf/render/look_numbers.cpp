#include <algorithm>
#include <cmath>

#include "murosimf/math/assert.h"
#include "murosimf/render/look.h"

namespace murosimf::render {
namespace {

constexpr double wall_share = 0.9;  // [1] of the light of a level surface that walls get

std::vector<double> numbers(const Color& color) { return {color.red, color.green, color.blue}; }

/// How far the closed lines reach to each side [m]: outside of them the field is darker.
std::array<double, 2> reach_of_lines(const Markings* markings) {
  std::array<double, 2> reach{};
  for (const Stroke& stroke : markings ? markings->strokes : std::vector<Stroke>{}) {
    if (stroke.points.size() < 3 || !(norm(stroke.points.back() - stroke.points.front()) < 1e-9)) continue;
    for (const Vec3d& p : stroke.points) {
      reach = {std::max(reach[0], std::abs(p.x) + stroke.width / 2),
               std::max(reach[1], std::abs(p.y) + stroke.width / 2)};
    }
  }
  return reach;
}

}  // namespace

std::vector<LookNumber> look_numbers(const Light& light, const Markings* markings) {
  const Surroundings& around = light.surroundings;
  std::array<double, 3> on_walls = brightness_upwards(light, true);
  for (double& one : on_walls) one *= wall_share;
  const std::array<double, 2> lines = reach_of_lines(markings);
  const Vec3d sun = (1 / norm(light.toward)) * light.toward;
  const bool outdoors = around.kind == Surroundings::Kind::outdoors;
  MUROSIMF_ASSERT(light.pool >= 0 && around.height > 0 && light.field.stripe_width > 0);
  return {{"lines_reach", {lines[0], lines[1]}},
          {"stripe", {light.field.stripe_width, light.field.stripe_contrast}},
          {"pile_scale", {1 / (pile_texel * pile_side)}},
          {"pool", {light.pool > 0 ? 1 / (light.pool * light.pool) : 0}},
          {"haze", {outdoors ? 1.0 : 0.0}},
          {"wall", numbers(shown_in(around.wall, on_walls))},
          {"dado", numbers(shown_in(around.dado, on_walls))},
          {"ceiling", numbers(shown_in(around.ceiling, on_walls))},
          {"pane", numbers(around.window)},
          {"tube", numbers(around.tube)},
          {"wall_height", {around.height}},
          {"zenith", numbers(around.zenith)},
          {"horizon", numbers(around.horizon)},
          {"hedge", numbers(around.hedge)},
          {"sun", numbers(around.sun)},
          {"sun_toward", {sun.x, sun.y, sun.z}}};
}

}  // namespace murosimf::render
