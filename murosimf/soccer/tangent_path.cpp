#include "murosimf/soccer/tangent_path.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "murosimf/math/assert.h"

namespace murosimf::soccer {
namespace {

constexpr int corners_of_disk = 16;
constexpr double inside = 1 - 1e-9;  // corners and edges lie on their own circles, but for rounding

double distance_to_segment(const Vec3d& p, const Vec3d& a, const Vec3d& b) noexcept {
  const Vec3d ab = b - a;
  const double square = dot(ab, ab), t = square > 0 ? std::clamp(dot(p - a, ab) / square, 0.0, 1.0) : 0;
  return norm(Vec3d(p - (a + t * ab)));
}

}  // namespace

WayAround::WayAround(std::size_t most_disks) : most_disks_(most_disks) {
  disks_.reserve(most_disks);
  corners_.reserve(2 + corners_of_disk * most_disks);
  way_.reserve(2 + corners_of_disk * most_disks);
}

std::span<const Vec3d> WayAround::find(const Vec3d& start, const Vec3d& goal, std::span<const Disk> disks,
                                       const WayBounds& bounds) noexcept {
  MUROSIMF_ASSERT(bounds.lowest_x <= bounds.highest_x && bounds.lowest_y <= bounds.highest_y);
  constexpr double far = std::numeric_limits<double>::infinity();
  set_disks(start, goal, disks);
  corners_.clear();
  corners_.push_back({start, 0, 0, false});
  corners_.push_back({goal, far, 0, false});
  add_corners(bounds);
  way_.clear();
  if (!search()) return way_;
  for (std::size_t i = 1; i != 0; i = corners_[i].from) {
    MUROSIMF_ASSERT(corners_[i].from < corners_.size());
    way_.push_back(corners_[i].place);
  }
  way_.push_back(start);
  std::reverse(way_.begin(), way_.end());
  MUROSIMF_ASSERT(way_.size() >= 2);
  return way_;
}

void WayAround::set_disks(const Vec3d& start, const Vec3d& goal, std::span<const Disk> disks) noexcept {
  disks_.clear();
  for (const Disk& disk : disks.first(std::min(disks.size(), most_disks_))) {
    // A little less than the distance: start and goal must not lie on the border.
    const double room = 0.98 * std::min(norm(Vec3d(start - disk.center)), norm(Vec3d(goal - disk.center)));
    disks_.push_back({disk.center, std::min(disk.radius, room)});
  }
}

void WayAround::add_corners(const WayBounds& bounds) noexcept {
  for (const Disk& disk : disks_) {
    const double reach = disk.radius / std::cos(pi / corners_of_disk);  // of a polygon around it
    for (int i = 0; i < corners_of_disk; ++i) {
      const double angle = 2 * pi * i / corners_of_disk;
      const Vec3d place = disk.center + reach * Vec3d{std::cos(angle), std::sin(angle), 0};
      if (place.x < bounds.lowest_x || place.x > bounds.highest_x) continue;
      if (place.y < bounds.lowest_y || place.y > bounds.highest_y) continue;
      if (is_free(place)) corners_.push_back({place, std::numeric_limits<double>::infinity(), 0, false});
    }
  }
}

bool WayAround::is_free(const Vec3d& place) const noexcept {
  return std::all_of(disks_.begin(), disks_.end(),
                     [&](const Disk& disk) { return norm(Vec3d(place - disk.center)) >= inside * disk.radius; });
}

bool WayAround::is_free(const Vec3d& a, const Vec3d& b) const noexcept {
  return std::all_of(disks_.begin(), disks_.end(),
                     [&](const Disk& disk) { return distance_to_segment(disk.center, a, b) >= inside * disk.radius; });
}

/// Searches by Dijkstra's algorithm; true if it reached the goal, which is corner 1. Corners are few: a linear search for the
/// next one is faster than a heap, and equal costs are resolved by the order of corners.
bool WayAround::search() noexcept {
  MUROSIMF_ASSERT(corners_.size() >= 2);
  while (true) {
    std::size_t next = corners_.size();
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      if (corners_[i].done || !std::isfinite(corners_[i].cost)) continue;
      if (next == corners_.size() || corners_[i].cost < corners_[next].cost) next = i;
    }
    if (next == corners_.size()) return false;
    MUROSIMF_ASSERT(!corners_[next].done);
    if (next == 1) return true;
    corners_[next].done = true;
    for (Corner& corner : corners_) {
      const double cost = corners_[next].cost + norm(Vec3d(corner.place - corners_[next].place));
      if (corner.done || cost >= corner.cost || !is_free(corners_[next].place, corner.place)) continue;
      corner.cost = cost;
      corner.from = next;
    }
  }
}

}  // namespace murosimf::soccer
