#include "murosimf/collision/ground_finder.h"

#include <algorithm>

#include "murosimf/geometry/collide.h"
#include "murosimf/geometry/descent.h"
#include "murosimf/geometry/ray.h"
#include "murosimf/math/assert.h"

namespace murosimf::collision {
namespace {

constexpr double margin_on_ground = 8e-3;  // [m] of volumes above uneven ground: pairs stay valid for several steps
constexpr std::uint64_t features_of_pair = std::uint64_t{1} << 32;

/// `v` in the plane across the unit vector `normal`, with length 1; zero if it has no direction there.
Vec3d direction_in_plane(const Vec3d& v, const Vec3d& normal) {
  const Vec3d inside = tangential(v, normal);
  const double size = norm(inside);
  return size > 1e-9 * norm(v) ? (1.0 / size) * inside : Vec3d{};
}

double round_radius(const Shape& shape) {
  const Sphere* sphere = std::get_if<Sphere>(&shape);
  return sphere ? sphere->radius : 0;
}

}  // namespace

std::vector<GroundPlane> ground_planes(const Entity* environment) {
  std::vector<GroundPlane> planes;
  if (!environment) return planes;
  const Model& model = environment->model();
  for (const CollidingShape& plane : colliding_planes(model)) {
    const PlacedShape& placed = plane.placed;
    const FixedObject place = model.placement(plane.object);
    const Mat3d R = place.turn * placed.orientation;
    const double height = dot(R.z, place.offset + place.turn * placed.position);
    planes.push_back({R.z, height, direction_in_plane(R * placed.surface.friction_direction, R.z), placed.surface,
                      plane.object, placed.contact_type, placed.contact_affinity});
  }
  return planes;
}

GroundFinder::GroundFinder(const Entity& entity, const Entity* environment)
    : shapes_(&ground_shapes(entity.model())),
      planes_(ground_planes(environment)),
      environment_(static_compound_of(environment)),
      own_(compound_of(entity, {.volume = entity.options().collision.volume,
                                .margin = environment_->uneven_grounds().empty() ? 0 : margin_on_ground})),
      own_kinds_(own_.shapes(), SurfaceKinds::Of::model),
      static_kinds_(environment_->compound().shapes(), SurfaceKinds::Of::object),
      all_touch_planes_(own_.all_touch() && std::all_of(planes_.begin(), planes_.end(), is_usual<GroundPlane>)) {}

std::size_t GroundFinder::most_on_planes() const { return 8 * shapes_->size() * planes_.size(); }

void GroundFinder::find(std::span<const Vec3d> r, std::span<const Mat3d> R, std::vector<ContactPoint>& found,
                        TestCounts& tests) noexcept {
  find_on_planes(r, R, found, tests);
  find_on_statics(r, R, found, tests);
}

void GroundFinder::find_on_planes(std::span<const Vec3d> r, std::span<const Mat3d> R, std::vector<ContactPoint>& found,
                                  TestCounts& tests) const noexcept {
  MUROSIMF_ASSERT(r.size() == R.size());
  const std::span<const GroundShape> shapes(*shapes_);
  std::uint64_t feature = 0;
  for (std::size_t k = 0; k < planes_.size(); ++k) {
    const GroundPlane& plane = planes_[k];
    tests.volumes += static_cast<std::int64_t>(shapes.size());
    for (const GroundShape& shape : shapes) {
      if (is_out_of_reach(shape, r[shape.object], plane)) continue;
      if (!(all_touch_planes_ || may_touch(shape.placed, plane))) continue;
      const std::size_t first = found.size();
      if (find_ground_contacts(shape, r[shape.object], R[shape.object], plane, found)) ++tests.objects;
      for (std::size_t i = first; i < found.size(); ++i) {
        found[i].surface = surface(k, static_cast<std::size_t>(&shape - shapes.data()));
        found[i].feature += feature;
      }
    }
    feature += features_of_all(shapes);
  }
}

void GroundFinder::find_on_statics(std::span<const Vec3d> r, std::span<const Mat3d> R, std::vector<ContactPoint>& found,
                                   TestCounts& tests) noexcept {
  MUROSIMF_ASSERT(r.size() == R.size() && !r.empty());
  if (environment_->empty() || !is_near_statics_(*environment_, r[0], own_.reach(), tests.volumes)) return;
  if (!(has_candidates_ && own_.still_fits(r, R))) find_candidates(r, R, tests);
  geometry::Manifold manifold;
  for (std::size_t i = 0; i < candidates_.size(); ++i) {
    const auto& [other, own] = candidates_[i];
    if (const StaticCompound::Ground* ground = environment_->ground_of(other)) {
      const auto begin = candidates_.cbegin() + static_cast<std::ptrdiff_t>(i);
      const auto end =
          std::find_if(begin, candidates_.cend(), [&](const auto& pair) { return !ground->has(pair.first); });
      find_on_ground(*ground, r, R, {begin, end}, found, tests);
      i = static_cast<std::size_t>(end - candidates_.cbegin()) - 1;
      continue;
    }
    ++tests.objects;
    const Shape& shape = own_.shapes()[own].placed.shape;
    const Shape& obstacle = environment_->shape(other).placed.shape;
    if (geometry::collide(shape, own_.pose(own, r, R), obstacle, environment_->pose(other), manifold)) {
      sort_by_feature(manifold);
      add_contacts(own, other, manifold, found);
    }
  }
}

void GroundFinder::find_candidates(std::span<const Vec3d> r, std::span<const Mat3d> R, TestCounts& tests) noexcept {
  own_.refit(r, R);
  candidates_.clear();
  const auto add = [&](int other, int own) {
    candidates_.emplace_back(other, own);
    return true;
  };
  tests.volumes += for_pairs(environment_->compound(), own_, only_touching(environment_->compound(), own_, add));
  std::sort(candidates_.begin(), candidates_.end());  // the order of contacts must not depend on the trees' shapes
  for (const StaticCompound::Ground& ground : environment_->uneven_grounds()) {
    const auto is_of = [&](const auto& pair) { return ground.has(pair.first); };
    const auto begin = std::find_if(candidates_.begin(), candidates_.end(), is_of);
    std::sort(begin, std::find_if_not(begin, candidates_.end(), is_of),
              [](const auto& a, const auto& b) { return std::pair(a.second, a.first) < std::pair(b.second, b.first); });
  }
  has_candidates_ = !environment_->uneven_grounds().empty();
}

/// Features are those of the own shape's points, not of triangles: a foot that slides over edges keeps the memory of its friction.
void GroundFinder::find_on_ground(const StaticCompound::Ground& ground, std::span<const Vec3d> r,
                                  std::span<const Mat3d> R, std::span<const std::pair<int, int>> candidates,
                                  std::vector<ContactPoint>& found, TestCounts& tests) noexcept {
  const std::size_t shapes = own_.shapes().size();
  for (std::size_t i = 0; i < candidates.size();) {
    const int own = candidates[i].second;
    triangles_.clear();
    for (; i < candidates.size() && candidates[i].second == own; ++i) {
      triangles_.push_back(candidates[i].first - ground.first);
    }
    tests.objects += static_cast<std::int64_t>(triangles_.size());
    const CollidingShape& shape = own_.shapes()[own];
    find_relief_contacts(shape.placed.shape, own_.pose(own, r, R), *ground.relief, ground.at, triangles_, on_ground_);
    const std::uint64_t pair = static_cast<std::uint64_t>(ground.first) * shapes + static_cast<std::uint64_t>(own);
    for (const ReliefContact& touch : on_ground_) {
      ContactPoint& c = found.emplace_back();
      c.object = shape.object;
      c.feature = (1 + pair) * features_of_pair + touch.feature;
      c.surface = surface(planes_.size() + static_kinds_.of(ground.first), own);
      c.point = touch.point;
      c.normal = touch.normal;
      c.depth = touch.depth;
      c.radius = touch.radius;
    }
  }
}

void GroundFinder::add_contacts(int own, int other, const geometry::Manifold& manifold,
                                std::vector<ContactPoint>& found) const noexcept {
  const std::size_t pair = static_cast<std::size_t>(other) * own_.shapes().size() + static_cast<std::size_t>(own);
  for (int k = 0; k < manifold.count; ++k) {
    ContactPoint& c = found.emplace_back();
    c.object = own_.shapes()[own].object;
    c.feature = (1 + pair) * features_of_pair + manifold.points[k].feature;  // after those of planes
    c.surface = surface(planes_.size() + static_kinds_.of(other), own);
    c.point = manifold.points[k].point;
    c.normal = manifold.normal;
    c.depth = manifold.points[k].depth;
    c.radius = round_radius(own_.shapes()[own].placed.shape);
  }
}

bool GroundFinder::are_of_same_shapes(const ContactPoint& a, const ContactPoint& b) noexcept {
  return a.feature / features_of_pair == b.feature / features_of_pair;
}

bool GroundFinder::is_on_plane(const ContactPoint& point) noexcept { return point.feature < features_of_pair; }

/// By the environment's kinds, each plane being one, then by the entity's: as for_meetings() counts.
std::uint32_t GroundFinder::surface(std::size_t other_kind, std::size_t own_shape) const noexcept {
  MUROSIMF_ASSERT(own_shape < own_.shapes().size());
  return static_cast<std::uint32_t>(other_kind * own_kinds_.surfaces().size() + own_kinds_.of(own_shape));
}

namespace {

/// The highest surface that is not above a limit [m].
struct Highest {
  double limit = 0;
  bool found = false;
  double height = 0;  ///< [m] the plane z = 0 where none is found
  Vec3d normal{0, 0, 1};

  void update(double z, const Vec3d& up) noexcept {
    if (z > limit || (found && z <= height)) return;
    found = true;
    height = z;
    normal = up;
  }
};

/// Entries of a vertical ray downwards through `point`, from the limit on, into static shapes.
void see_statics(const StaticCompound& statics, const Vec3d& point, Highest& highest) noexcept {
  const geometry::Ray ray{{point.x, point.y, highest.limit}, {0, 0, -1}};
  const auto wanted = [&](const auto& volume) {
    return geometry::ray_enters(volume, ray, std::numeric_limits<double>::infinity());
  };
  const auto look = [&](int i) {
    const auto entry = geometry::meet(ray, statics.shape(i).placed.shape, statics.pose(i));
    if (entry && entry->distance > 0)
      highest.update(ray.origin.z - entry->distance, entry->normal);  // 0: begins inside
    return true;
  };
  std::visit([&](const auto& tree) { geometry::for_leaves(tree, wanted, look); }, statics.compound().tree());
}

}  // namespace

GroundSurface::GroundSurface(const Entity* environment)
    : planes_(ground_planes(environment)), statics_(static_compound_of(environment)) {
  if (statics_ && statics_->empty()) statics_ = nullptr;
}

GroundBelow GroundSurface::below(const Vec3d& point) noexcept {
  Highest highest{.limit = point.z + highest_step};
  for (const GroundPlane& plane : planes_) {
    const Vec3d& n = plane.normal;
    if (n.z == 1) {
      highest.update(plane.height, n);
    } else if (n.z > 0) {
      highest.update((plane.height - n.x * point.x - n.y * point.y) / n.z, n);
    }
  }
  constexpr double reach = 0.2;  // [m] of a foot
  std::int64_t tests = 0;
  if (statics_ && is_near_(*statics_, point, reach, tests)) see_statics(*statics_, point, highest);
  const Vec3d& normal = highest.normal;
  if (normal.z == 1 || normal.z < steepest) return {highest.height, 0, 0};
  return {highest.height, -normal.x / normal.z, -normal.y / normal.z};
}

}  // namespace murosimf::collision
