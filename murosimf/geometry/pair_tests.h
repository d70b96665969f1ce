/// pair_tests.h - the exact tests behind `collide`, each for one pair of kinds.
///
/// All give what `collide` gives: true and the manifold (normal from B to A), or false and leave it alone.
#pragma once

#include "murosimf/geometry/manifold.h"
#include "murosimf/model/shape.h"

namespace murosimf::geometry {

bool collide_sphere(const Sphere& a, const Transformd& at_a, const Shape& b, const Transformd& at_b, Manifold& found);
/// B: the plane.
bool collide_with_plane(const Shape& a, const Transformd& at_a, const Transformd& at_b, Manifold& found);
bool collide_capsules(const Capsule& a, const Transformd& at_a, const Capsule& b, const Transformd& at_b,
                      Manifold& found);
bool collide_box_capsule(const Box& a, const Transformd& at_a, const Capsule& b, const Transformd& at_b,
                         Manifold& found);
bool collide_boxes(const Box& a, const Transformd& at_a, const Box& b, const Transformd& at_b, Manifold& found);
/// Any two but planes, by support functions.
bool collide_general(const Shape& a, const Transformd& at_a, const Shape& b, const Transformd& at_b, Manifold& found);

}  // namespace murosimf::geometry
