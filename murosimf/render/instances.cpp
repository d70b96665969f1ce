#include "murosimf/render/instances.h"

#include <algorithm>
#include <cmath>

#include "murosimf/math/assert.h"

namespace murosimf::render {
namespace {

constexpr std::array roundness{8, 16, 32, 64};  // segments
constexpr int shadow_level = 1;
constexpr double largest_error = 0.25;          // [px]
constexpr double largest_depth_error = 0.5e-3;  // [m]

enum RoundForm : std::size_t { sphere, half_sphere, tube, cylinder, round_forms };

std::size_t render_mesh_of(const Drawable& drawable, std::size_t level, const MeshCatalog& catalog) {
  MUROSIMF_ASSERT(level < roundness.size());
  const std::size_t box = round_forms * roundness.size();
  switch (drawable.form) {
    case Form::sphere: return (drawable.paneled ? catalog.first_ball : sphere * roundness.size()) + level;
    case Form::half_sphere: return half_sphere * roundness.size() + level;
    case Form::tube: return tube * roundness.size() + level;
    case Form::cylinder: return cylinder * roundness.size() + level;
    case Form::box: return box;
    case Form::mesh: return catalog.first_mesh + static_cast<std::size_t>(drawable.mesh);
  }
  return box;
}

/// The coarsest level at which a circle is off by less than `error`, in units of its radius. A polygon of n sides is off
/// by up to (pi / n)^2 / 3 from the circle of the same area.
std::size_t level_for(double error) {
  for (std::size_t i = 0; i + 1 < roundness.size(); ++i) {
    const double angle = pi / roundness[i];
    if (0.34 * angle * angle < error) return i;
  }
  return roundness.size() - 1;
}

/// The visible volume of a projection, bounded by planes: n . p > offset inside, n of unit length.
class Frustum {
 public:
  explicit Frustum(const Projection& projection) : parallel_(projection.parallel) {
    const sensors::Perspective& view = projection.window;
    if (parallel_) {
      planes_ = {Vec3d{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
      offsets_ = {view.left, -view.right, view.top, -view.bottom};
      return;
    }
    const auto unit = [](const Vec3d& v) { return (1 / norm(v)) * v; };
    planes_ = {unit({1, 0, -view.left}), unit({-1, 0, view.right}), unit({0, 1, -view.top}),
               unit({0, -1, view.bottom})};
    const double x = std::max(-view.left, view.right), y = std::max(-view.top, view.bottom);
    corner_stretch_ = 1 + x * x + y * y;
  }
  [[nodiscard]] bool may_see(const Vec3d& middle, double radius) const {
    MUROSIMF_ASSERT(radius >= 0);
    if (!parallel_ && middle.z < -radius) return false;
    for (std::size_t i = 0; i < planes_.size(); ++i) {
      // Written so that a position that is not finite is invisible.
      if (!(dot(planes_[i], middle) - offsets_[i] > -radius)) return false;
    }
    return true;
  }
  /// [m] The longest outward shift of the outline of a sphere that stays below `error` [px] in the picture; `pixels` to
  /// a unit of the window.
  [[nodiscard]] double allowed(double error, double pixels, const Vec3d& middle, double radius) const {
    MUROSIMF_ASSERT(error > 0 && pixels > 0);
    if (parallel_) return error / pixels;
    const double near = std::max(0.01, norm(middle) - radius);
    return error * near / (pixels * stretch(middle, radius));
  }

 private:
  /// [1] by which things look larger than they would on the axis, at most, in the part of the picture that shows a
  /// sphere: 1 / cos^2 of the angle.
  [[nodiscard]] double stretch(const Vec3d& middle, double radius) const {
    const double square = dot(middle, middle), tangent = square - radius * radius;
    if (tangent <= 0) return corner_stretch_;
    const double cosine = (middle.z * std::sqrt(tangent) - radius * std::hypot(middle.x, middle.y)) / square;
    return cosine > 0 ? std::min(corner_stretch_, 1 / (cosine * cosine)) : corner_stretch_;
  }

  bool parallel_;
  std::array<Vec3d, 4> planes_;
  std::array<double, 4> offsets_{};  // [m] through the eye: none
  double corner_stretch_ = 1;
};

std::uint8_t byte_of(double share) { return static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0))); }

std::array<float, 4> row(double x, double y, double z, double w) {
  return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z), static_cast<float>(w)};
}

Instance instance_of(const Drawable& drawable, const Transformd& at) {
  const Mat3d& R = at.orientation;
  const Vec3d &s = drawable.scale, &p = at.position;
  const auto inverse_square = [](double scale) { return static_cast<float>(1 / (scale * scale)); };
  return {row(s.x * R.x.x, s.y * R.y.x, s.z * R.z.x, p.x),
          row(s.x * R.x.y, s.y * R.y.y, s.z * R.z.y, p.y),
          row(s.x * R.x.z, s.y * R.y.z, s.z * R.z.z, p.z),
          {inverse_square(s.x), inverse_square(s.y), inverse_square(s.z)},
          {byte_of(drawable.color.red), byte_of(drawable.color.green), byte_of(drawable.color.blue),
           byte_of(drawable.color.alpha)},
          drawable.label};
}

/// A pose of the world in the axes of the eye.
Transformd seen_from(const Transformd& pose, const Vec3d& eye, const Mat3d& axes) {
  return {transposed_times(axes, pose.position - eye), transpose(axes) * pose.orientation};
}

}  // namespace

MeshCatalog solid_catalog(std::span<const RenderMesh> meshes) {
  MeshCatalog catalog;
  for (auto* make : {unit_sphere, unit_half_sphere, unit_tube, unit_cylinder}) {
    for (const int segments : roundness) catalog.meshes.push_back(make(segments));
  }
  catalog.meshes.push_back(unit_box());
  catalog.first_mesh = catalog.meshes.size();
  catalog.meshes.insert(catalog.meshes.end(), meshes.begin(), meshes.end());
  catalog.first_ball = catalog.meshes.size();
  for (const int segments : roundness) catalog.meshes.push_back(unit_sphere(segments));
  MUROSIMF_ASSERT(catalog.first_ball == catalog.first_mesh + meshes.size());
  return catalog;
}

void InstanceList::begin(const MeshCatalog& catalog) {
  unsorted_.clear();
  clear_.clear();
  render_mesh_of_.clear();
  first_of_.assign(catalog.meshes.size() + 1, 0);
  first_ball_ = catalog.first_ball;
}

void InstanceList::add(std::size_t solid, const Drawable& drawable, const Transformd& optical) {
  MUROSIMF_ASSERT(solid + 1 < first_of_.size());
  if (drawable.color.alpha < 1) {
    clear_.emplace_back(solid, instance_of(drawable, optical));
    return;
  }
  unsorted_.push_back(instance_of(drawable, optical));
  render_mesh_of_.push_back(solid);
  ++first_of_[solid + 1];
}

void InstanceList::fill(const RenderScene& render_scene, const Projection& projection, bool depths, double ahead,
                        const MeshCatalog& catalog) {
  begin(catalog);
  const sensors::Perspective& view = projection.window;
  const Frustum frustum(projection);
  const double pixels = std::max(view.width / (view.right - view.left), view.height / (view.bottom - view.top));
  MUROSIMF_ASSERT(pixels > 0);
  render_scene.for_drawables(ahead, [&](const Drawable& drawable, const Transformd& pose) {
    if (view.without && render_scene.owner(drawable) == view.without) return;
    const Transformd optical = seen_from(pose, view.eye, view.axes);
    if (!frustum.may_see(optical.position, drawable.radius)) return;
    const double size =
        std::max({drawable.scale.x, drawable.scale.y, drawable.form == Form::sphere ? drawable.scale.z : 0});
    double error = frustum.allowed(largest_error, pixels, optical.position, drawable.radius);
    if (depths) error = std::min(error, largest_depth_error);
    const std::size_t level = view.finest ? roundness.size() - 1 : level_for(error / size);
    add(render_mesh_of(drawable, level, catalog), drawable, optical);
  });
  sort();
}

void InstanceList::fill_all(const RenderScene& render_scene, const Vec3d& eye, const Mat3d& axes, double ahead,
                            const MeshCatalog& catalog) {
  begin(catalog);
  render_scene.for_drawables(ahead, [&](const Drawable& drawable, const Transformd& pose) {
    add(render_mesh_of(drawable, shadow_level, catalog), drawable, seen_from(pose, eye, axes));
  });
  sort();
}

/// Sorts by solid; pieces of one solid keep their order (counting sort).
void InstanceList::sort() {
  MUROSIMF_ASSERT(unsorted_.size() == render_mesh_of_.size());
  groups_.clear();
  ball_groups_ = 0;
  for (std::size_t solid = 0; solid + 1 < first_of_.size(); ++solid) {
    const std::size_t count = first_of_[solid + 1];
    first_of_[solid + 1] += first_of_[solid];
    if (count > 0) groups_.push_back({solid, first_of_[solid], count});
    if (count > 0 && solid >= first_ball_) ++ball_groups_;
  }
  sorted_.resize(unsorted_.size());
  for (std::size_t i = 0; i < unsorted_.size(); ++i) {
    MUROSIMF_ASSERT(first_of_[render_mesh_of_[i]] < sorted_.size());
    sorted_[first_of_[render_mesh_of_[i]]++] = unsorted_[i];
  }
  append_clear();
}

void InstanceList::append_clear() {
  solid_groups_ = groups_.size();
  const auto depth = [](const std::pair<std::size_t, Instance>& one) { return one.second.row_z[3]; };
  // Farthest first; stable, so that pictures of equal scenes are equal.
  std::stable_sort(clear_.begin(), clear_.end(), [&](const auto& a, const auto& b) { return depth(a) > depth(b); });
  for (const auto& [solid, instance] : clear_) {
    groups_.push_back({solid, sorted_.size(), 1});
    sorted_.push_back(instance);
  }
  MUROSIMF_ASSERT(solid_groups_ + clear_.size() == groups_.size());
}

}  // namespace murosimf::render
