/// support.h - the farthest point of a shape in a direction.
#pragma once

#include "murosimf/geometry/manifold.h"
#include "murosimf/model/shape.h"

namespace murosimf::geometry {

/// Farthest point [m] of the shape in direction d (any length but zero); shape frame. A plane has none: zero.
[[nodiscard]] Vec3d support(const Shape& shape, const Vec3d& d);

/// A convex body in the world, as general tests see it: `core` with a margin all round. The core of a capsule is its
/// axis, that of a sphere its center.
class Body {
 public:
  Body(const Shape& shape, const Transformd& at);

  [[nodiscard]] double margin() const { return margin_; }
  [[nodiscard]] const Transformd& pose() const { return *at_; }
  [[nodiscard]] const Shape& shape() const { return *shape_; }
  /// Farthest point of the core [m] along d, world frame.
  [[nodiscard]] Vec3d core_support(const Vec3d& d) const;

 private:
  const Shape* shape_;
  const Transformd* at_;
  double margin_ = 0;
};

}  // namespace murosimf::geometry
