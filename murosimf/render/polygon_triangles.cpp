#include "murosimf/render/polygon_triangles.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "murosimf/math/assert.h"

namespace murosimf::render {
namespace {

struct Flat {
  double x = 0, y = 0;
  friend bool operator==(const Flat&, const Flat&) = default;
};

/// Twice the area of a polygon along its normal (Newell).
Vec3d newell(std::span<const Vec3d> corners) {
  Vec3d sum;
  // From a corner of the polygon: far from the origin the products would cancel.
  for (std::size_t i = 0; i < corners.size(); ++i) {
    sum += cross(corners[i] - corners[0], corners[(i + 1) % corners.size()] - corners[0]);
  }
  return sum;
}

/// Projects along the axis that is nearest to the normal; counterclockwise.
std::vector<Flat> flattened(std::span<const Vec3d> corners) {
  const Vec3d n = newell(corners);
  const double x = std::abs(n.x), y = std::abs(n.y), z = std::abs(n.z);
  std::vector<Flat> flat;
  flat.reserve(corners.size());
  for (const Vec3d& p : corners) {
    if (z >= x && z >= y) {
      flat.push_back(n.z < 0 ? Flat{p.y, p.x} : Flat{p.x, p.y});
    } else if (x >= y) {
      flat.push_back(n.x < 0 ? Flat{p.z, p.y} : Flat{p.y, p.z});
    } else {
      flat.push_back(n.y < 0 ? Flat{p.x, p.z} : Flat{p.z, p.x});
    }
  }
  return flat;
}

/// Twice the area of a triangle; positive if it is counterclockwise.
double turn(const Flat& a, const Flat& b, const Flat& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The rest of a polygon, as a ring.
class Ring {
 public:
  explicit Ring(std::vector<Flat> corners) : corners_(std::move(corners)) {
    const auto n = static_cast<std::uint32_t>(corners_.size());
    for (std::uint32_t i = 0; i < n; ++i) {
      before_.push_back((i + n - 1) % n);
      after_.push_back((i + 1) % n);
    }
    for (std::uint32_t i = 0; i < n; ++i) {
      if (turn_at(i) < 0) concave_.push_back(i);
    }
  }

  [[nodiscard]] std::uint32_t before(std::uint32_t i) const {
    MUROSIMF_ASSERT(i < before_.size());
    return before_[i];
  }
  [[nodiscard]] std::uint32_t after(std::uint32_t i) const {
    MUROSIMF_ASSERT(i < after_.size());
    return after_[i];
  }
  [[nodiscard]] double turn_at(std::uint32_t i) const {
    return turn(corners_[before_[i]], corners_[i], corners_[after_[i]]);
  }
  /// Whether the triangle of a convex corner contains no other corner: only concave ones can lie in it.
  [[nodiscard]] bool is_ear(std::uint32_t i) const {
    const Flat &a = corners_[before_[i]], &b = corners_[i], &c = corners_[after_[i]];
    // Corners of the triangle may occur again in another place of the border: they are skipped by value.
    for (const std::uint32_t other : concave_) {
      const Flat& p = corners_[other];
      if (p == a || p == b || p == c) continue;
      if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return false;
    }
    return true;
  }
  void cut(std::uint32_t i) {
    const std::uint32_t a = before_[i], c = after_[i];
    MUROSIMF_ASSERT(after_[a] == i && before_[c] == i);
    after_[a] = c;
    before_[c] = a;
    // Cutting may make the neighbors convex, never concave.
    std::erase_if(concave_,
                  [&](std::uint32_t one) { return one == i || ((one == a || one == c) && turn_at(one) >= 0); });
  }

 private:
  std::vector<Flat> corners_;
  std::vector<std::uint32_t> before_, after_, concave_;
};

}  // namespace

std::vector<std::array<std::uint32_t, 3>> polygon_triangles(std::span<const Vec3d> corners) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  MUROSIMF_ASSERT(corners.size() <= std::numeric_limits<std::uint32_t>::max());
  if (corners.size() < 3) return triangles;
  Ring ring(flattened(corners));
  auto left = corners.size();
  std::uint32_t at = 0;
  std::size_t passed = 0;  // corners since the last one that was cut
  while (left > 2) {
    const double turns = ring.turn_at(at);
    // Where the border crosses itself there may be no ear: then any corner is cut off, so that the loop ends.
    if (turns == 0 || (turns > 0 && ring.is_ear(at)) || passed > left) {
      if (turns != 0) triangles.push_back({ring.before(at), at, ring.after(at)});
      const std::uint32_t next = ring.after(at);
      ring.cut(at);
      --left;
      passed = 0;
      at = next;
      continue;
    }
    ++passed;
    at = ring.after(at);
  }
  MUROSIMF_ASSERT(triangles.size() <= corners.size() - 2);
  return triangles;
}

bool is_convex(std::span<const Vec3d> corners) {
  if (corners.size() < 4) return true;
  const std::vector<Flat> flat = flattened(corners);
  for (std::size_t i = 0; i < flat.size(); ++i) {
    if (turn(flat[i], flat[(i + 1) % flat.size()], flat[(i + 2) % flat.size()]) < 0) return false;
  }
  return true;
}

}  // namespace murosimf::render
