/// tangent_path.h - the shortest way on the ground that keeps clear of round obstacles.
///
/// Circles are replaced by polygons around them, and the shortest way is searched for along straight lines between their
/// corners that cross no circle. With 16 corners it is at most 2 % longer around a circle than the true one, which follows
/// tangents and arcs.
/// Source: visibility graph: Lozano-Perez, Wesley, "An algorithm for planning collision-free paths among polyhedral
///         obstacles", CACM 22 (1979); Dijkstra, "A note on two problems in connexion with graphs", 1959.
#pragma once

#include <span>
#include <vector>

#include "murosimf/math/vec3.h"

namespace murosimf::soccer {

/// All in meters, on the plane z = 0.
struct Disk {
  Vec3d center;
  double radius = 0;
};

/// Bounds of a way.
struct WayBounds {
  double lowest_x = -1e9, highest_x = 1e9, lowest_y = -1e9, highest_y = 1e9;
};

class WayAround {
 public:
  /// Reserves memory for `most_disks` disks.
  explicit WayAround(std::size_t most_disks);

  /// The way from `start` to `goal`, both included; valid until the next call. Empty if there is none. A start or goal within a disk
  /// makes that disk smaller, to just beside it. Corners out of bounds are not used. Only the first `most_disks` disks count.
  [[nodiscard]] std::span<const Vec3d> find(const Vec3d& start, const Vec3d& goal, std::span<const Disk> disks,
                                            const WayBounds& bounds = {}) noexcept;

  /// Largest number of points of a way.
  [[nodiscard]] std::size_t most_points() const noexcept { return way_.capacity(); }

 private:
  struct Corner {
    Vec3d place;
    double cost;       // [m] from the start
    std::size_t from;  // previous corner of the way
    bool done;
  };
  void set_disks(const Vec3d& start, const Vec3d& goal, std::span<const Disk> disks) noexcept;
  void add_corners(const WayBounds& bounds) noexcept;
  [[nodiscard]] bool is_free(const Vec3d& place) const noexcept;
  [[nodiscard]] bool is_free(const Vec3d& a, const Vec3d& b) const noexcept;
  [[nodiscard]] bool search() noexcept;

  std::size_t most_disks_;
  std::vector<Disk> disks_;
  std::vector<Corner> corners_;  // start, goal, and those of the polygons
  std::vector<Vec3d> way_;
};

}  // namespace murosimf::soccer
