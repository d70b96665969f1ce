// Depths and distances against FCL (the Flexible Collision Library), where it is installed.
//
// What FCL itself reaches, found by comparing it with dense samples:
// - distance: closed forms for sphere, box, capsule and cylinder against a sphere and for two capsules (1e-9 m here, for
//   their square roots); all others by libccd's GJK, which stops at 1e-6 m of the distance or 1e-10 m^2 of its square.
// - depth: closed forms where a sphere or a half space meets anything but an ellipsoid (1e-9 m); two boxes by a test of
//   15 axes that prefers faces by 5 percent, so that its depth is never less than the least one; all others by EPA
//   with a tolerance of 1e-6 in the square of the depth, which is no oracle: they are not compared.
#include <gtest/gtest.h>

#include <fcl/fcl.h>

#include "murosimf/geometry/collide.h"
#include "murosimf/geometry/distance.h"
#include "tests/geometry/pairs.h"

namespace murosimf::geometry {
namespace {

using namespace pairs;

using Geometry = std::shared_ptr<fcl::CollisionGeometryd>;

struct ToFcl {
  Geometry operator()(const Sphere& s) const { return std::make_shared<fcl::Sphered>(s.radius); }
  Geometry operator()(const Box& s) const {
    return std::make_shared<fcl::Boxd>(2 * s.half_size.x, 2 * s.half_size.y, 2 * s.half_size.z);
  }
  Geometry operator()(const Capsule& s) const { return std::make_shared<fcl::Capsuled>(s.radius, 2 * s.half_length); }
  Geometry operator()(const Cylinder& s) const { return std::make_shared<fcl::Cylinderd>(s.radius, 2 * s.half_length); }
  Geometry operator()(const Ellipsoid& s) const {
    return std::make_shared<fcl::Ellipsoidd>(s.semi_axes.x, s.semi_axes.y, s.semi_axes.z);
  }
  Geometry operator()(const Plane&) const { return std::make_shared<fcl::Halfspaced>(fcl::Vector3d(0, 0, 1), 0.0); }
  Geometry operator()(const Convex& s) const {
    auto vertices = std::make_shared<std::vector<fcl::Vector3d>>();
    for (const Vec3d& v : s.hull->vertices) vertices->emplace_back(v.x, v.y, v.z);
    auto faces = std::make_shared<std::vector<int>>();
    for (const auto& face : s.hull->faces) {
      faces->push_back(static_cast<int>(face.size()));
      faces->insert(faces->end(), face.begin(), face.end());
    }
    return std::make_shared<fcl::Convexd>(vertices, static_cast<int>(s.hull->faces.size()), faces);
  }
};

fcl::CollisionObjectd object(const Shape& shape, const Transformd& at) {
  fcl::Transform3d pose = fcl::Transform3d::Identity();
  const Mat3d& R = at.orientation;
  pose.linear() << R.x.x, R.y.x, R.z.x, R.x.y, R.y.y, R.z.y, R.x.z, R.y.z, R.z.z;
  pose.translation() << at.position.x, at.position.y, at.position.z;
  return {std::visit(ToFcl{}, shape), pose};
}

double fcl_distance(const Shape& a, const Transformd& at_a, const Shape& b, const Transformd& at_b) {
  const auto first = object(a, at_a), second = object(b, at_b);
  fcl::DistanceRequestd request;
  request.gjk_solver_type = fcl::GST_LIBCCD;
  request.distance_tolerance = 1e-10;
  fcl::DistanceResultd result;
  return fcl::distance(&first, &second, request, result);
}

/// Negative if they do not touch.
double fcl_depth(const Shape& a, const Transformd& at_a, const Shape& b, const Transformd& at_b) {
  const auto first = object(a, at_a), second = object(b, at_b);
  fcl::CollisionRequestd request(16, true);
  request.gjk_solver_type = fcl::GST_LIBCCD;
  fcl::CollisionResultd result;
  fcl::collide(&first, &second, request, result);
  double deepest = -1;
  for (std::size_t i = 0; i < result.numContacts(); ++i) {
    deepest = std::fmax(deepest, result.getContact(i).penetration_depth);
  }
  return deepest;
}

double our_depth(const Shape& a, const Transformd& at_a, const Shape& b, const Transformd& at_b) {
  Manifold found;
  if (!collide(a, at_a, b, at_b, found)) return -1;
  double deepest = 0;
  for (int i = 0; i < found.count; ++i) deepest = std::fmax(deepest, found.points[i].depth);
  return deepest;
}

template <class Kind>
bool is(const Shape& shape) {
  return std::holds_alternative<Kind>(shape);
}

bool closed_form_distance(const Shape& a, const Shape& b) {
  if (is<Capsule>(a) && is<Capsule>(b)) return true;
  const Shape& other = is<Sphere>(a) ? b : a;
  return (is<Sphere>(a) || is<Sphere>(b)) && !is<Ellipsoid>(other) && !is<Convex>(other);
}

bool closed_form_depth(const Shape& a, const Shape& b) {
  const Shape& other = is<Sphere>(a) ? b : a;
  return (is<Sphere>(a) || is<Sphere>(b)) && !is<Ellipsoid>(other) && !is<Convex>(other);
}

TEST(AgainstFcl, DistanceOfShapesThatAreApart) {
  Dice dice("fcl distance");
  for (const Shape& a : all_kinds()) {
    for (const Shape& b : all_kinds()) {
      double worst = 0;
      for (int i = 0; i < 200; ++i) {
        const Transformd at_a = random_pose(dice, 0.4), at_b = random_pose(dice, 0.4);
        const double ours = distance(a, at_a, b, at_b).distance;
        if (ours < 1e-3) continue;
        worst = std::fmax(worst, std::abs(ours - fcl_distance(a, at_a, b, at_b)));
      }
      EXPECT_LT(worst, closed_form_distance(a, b) ? 1e-9 : 1e-6) << shape_name(a) << '-' << shape_name(b);
    }
  }
}

TEST(AgainstFcl, DepthWhereItIsClosedForm) {
  Dice dice("fcl depth");
  for (const Shape& a : all_kinds()) {
    for (const Shape& b : all_kinds()) {
      if (!closed_form_depth(a, b)) continue;
      for (int i = 0; i < 200; ++i) {
        const Transformd at_a = random_pose(dice, 0.15), at_b = random_pose(dice, 0.15);
        const double ours = our_depth(a, at_a, b, at_b);
        EXPECT_NEAR(ours, fcl_depth(a, at_a, b, at_b), 1e-9) << shape_name(a) << '-' << shape_name(b);
      }
    }
  }
}

TEST(AgainstFcl, DepthBelowAPlane) {
  Dice dice("fcl plane");
  for (const Shape& a : all_kinds()) {
    for (int i = 0; i < 200; ++i) {
      const Transformd at_a = random_pose(dice, 0.1), at_b = random_pose(dice, 0.1);
      const double ours = our_depth(a, at_a, Plane{}, at_b);
      EXPECT_NEAR(ours, fcl_depth(a, at_a, Plane{}, at_b), 1e-9) << shape_name(a);
    }
  }
}

TEST(AgainstFcl, BoxesAreNeverDeeper) {
  Dice dice("fcl boxes");
  int equal = 0;
  const Shape a = Box{{0.06, 0.1, 0.15}}, b = Box{{0.1, 0.08, 0.05}};
  for (int i = 0; i < 1000; ++i) {
    const Transformd at_a = random_pose(dice, 0.12), at_b = random_pose(dice, 0.12);
    const double ours = our_depth(a, at_a, b, at_b), theirs = fcl_depth(a, at_a, b, at_b);
    ASSERT_EQ(ours > 0, theirs > 0);
    if (ours < 0) continue;
    EXPECT_LT(ours, theirs + 1e-9);
    EXPECT_LT(theirs, 1.06 * ours + 1e-9);
    if (std::abs(ours - theirs) < 1e-9) ++equal;
  }
  EXPECT_GT(equal, 500);
}

}  // namespace
}  // namespace murosimf::geometry
