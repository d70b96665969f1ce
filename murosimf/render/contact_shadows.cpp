#include "murosimf/render/contact_shadows.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "murosimf/math/assert.h"

namespace murosimf::render {
namespace {

constexpr double darkest = 0.5;                           // [1]
constexpr double border = 0.012, border_by_height = 0.8;  // [m], [1]
constexpr double round_core = 0.3, round_border = 0.75;   // [1] of a sphere's radius

/// [m] Half of the extent of a turned box along a unit vector.
double reach_along(const std::array<Vec3d, 3>& axes, const Vec3d& half, const Vec3d& direction) {
  return half.x * std::abs(dot(axes[0], direction)) + half.y * std::abs(dot(axes[1], direction)) +
         half.z * std::abs(dot(axes[2], direction));
}

/// The direction on the ground of the longest side that is not the upright one.
Vec3d direction_on_ground(const std::array<Vec3d, 3>& axes, const Vec3d& half) {
  const std::array<double, 3> sizes{half.x, half.y, half.z};
  Vec3d best{1, 0, 0};
  double longest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double level = std::hypot(axes[i].x, axes[i].y);
    if (level * sizes[i] <= longest || level < 0.5) continue;
    longest = level * sizes[i];
    best = (1 / level) * Vec3d{axes[i].x, axes[i].y, 0};
  }
  return best;
}

/// What throws one shadow: a shape, or the pieces of a mesh in all its colors.
struct Caster {
  int owner, object;
  Form form;
  Transformd pose;
  Vec3d low, high;  ///< [m] of the box around it, in the axes of `pose`
};

/// Whether a piece belongs to the mesh of the caster before it.
bool belongs_to(const Caster& caster, const Drawable& piece, const Transformd& pose) {
  return piece.form == Form::mesh && caster.form == Form::mesh && piece.owner == caster.owner &&
         piece.object == caster.object && norm(pose.position - caster.pose.position) == 0;
}

std::vector<Caster> casters(const RenderScene& render_scene, double ahead, const Entity* without) {
  std::vector<Caster> found;
  render_scene.for_drawables(ahead, [&](const Drawable& piece, const Transformd& pose) {
    if (piece.color.alpha < 1 || (without && render_scene.owner(piece) == without)) return;
    const Vec3d low = piece.box_middle - piece.box_half, high = piece.box_middle + piece.box_half;
    if (found.empty() || !belongs_to(found.back(), piece, pose)) {
      found.push_back({piece.owner, piece.object, piece.form, pose, low, high});
      return;
    }
    Caster& all = found.back();
    all.low = {std::min(all.low.x, low.x), std::min(all.low.y, low.y), std::min(all.low.z, low.z)};
    all.high = {std::max(all.high.x, high.x), std::max(all.high.y, high.y), std::max(all.high.z, high.z)};
  });
  return found;
}

}  // namespace

std::vector<ContactShadow> contact_shadows(const RenderScene& render_scene, double ahead, const Entity* without) {
  std::vector<ContactShadow> shadows;
  for (const Caster& caster : casters(render_scene, ahead, without)) {
    const Mat3d& R = caster.pose.orientation;
    const std::array<Vec3d, 3> axes{R.x, R.y, R.z};
    const Vec3d half = 0.5 * (caster.high - caster.low);
    const Vec3d middle = caster.pose.position + R * (0.5 * (caster.low + caster.high));
    const double low = middle.z - reach_along(axes, half, {0, 0, 1});
    // written so that a position that is not finite has none
    if (!(low < contact_height && middle.z > 0)) continue;
    const double near = 1 - std::max(0.0, low) / contact_height;
    ContactShadow shadow{.middle = {middle.x, middle.y, 0}, .along = {1, 0, 0}, .darkness = darkest * near};
    if (caster.form == Form::sphere || caster.form == Form::half_sphere) {
      shadow.half_length = shadow.half_width = round_core * half.x;
      shadow.reach = round_border * half.x;
    } else {
      shadow.along = direction_on_ground(axes, half);
      shadow.half_length = reach_along(axes, half, shadow.along);
      shadow.half_width = reach_along(axes, half, {-shadow.along.y, shadow.along.x, 0});
      shadow.reach = border + border_by_height * std::max(0.0, low);
    }
    MUROSIMF_ASSERT(shadow.reach > 0);
    shadows.push_back(shadow);
  }
  return shadows;
}

}  // namespace murosimf::render
