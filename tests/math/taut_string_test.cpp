/// taut_string_test - strings around spheres and cylinders, against the shortest of many ways.
#include "murosimf/math/taut_string.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "murosimf/math/random.h"
#include "murosimf/math/scalar.h"

namespace murosimf {
namespace {

double whole(const StringObstacle& obstacle, const Vec3d& a, const Vec3d& b) {
  const auto contact = touch(obstacle, a, b);
  return contact ? norm(contact->first - a) + contact->length + norm(b - contact->second) : norm(b - a);
}

/// Length of the shortest way around a circle of radius 1 from a to b by brute force: over all pairs of points that a and b see, with the
/// arc between them on one side.
double shortest_around(const Vec3d& a, const Vec3d& b, double sense) {
  constexpr int steps = 720;
  double best = 1e9;
  const auto at = [](int i) {
    const double angle = 2 * pi * i / steps;
    return Vec3d{std::cos(angle), std::sin(angle), 0};
  };
  const auto sees = [](const Vec3d& from, const Vec3d& p) { return dot(p, from - p) > -1e-9; };
  for (int i = 0; i < steps; ++i) {
    if (!sees(a, at(i))) continue;
    for (int k = 0; k < steps; ++k) {
      if (!sees(b, at(k))) continue;
      const double turn = 2 * pi * ((k - i + steps) % steps) / steps;
      const double arc = sense > 0 || k == i ? turn : 2 * pi - turn;
      best = std::min(best, norm(at(i) - a) + arc + norm(b - at(k)));
    }
  }
  return best;
}

// The string over a cylinder in the plane across it is the shortest of all ways on its side.
TEST(TautString, IsTheShortestWayAroundACircle) {
  const RandomStream random(3, "strings");
  std::uint64_t drawn = 0;
  int touched = 0;
  for (int i = 0; i < 30; ++i) {
    const auto outside = [&] {
      const double angle = random.uniform(drawn++, -pi, pi), radius = random.uniform(drawn++, 1.1, 3.0);
      return Vec3d{radius * std::cos(angle), radius * std::sin(angle), 0};
    };
    const Vec3d a = outside(), b = outside();
    const auto contact = touch({1, true}, a, b);
    if (!contact) continue;
    ++touched;
    const double sense = cross(a, b).z > 0 ? 1 : -1;
    EXPECT_NEAR(whole({1, true}, a, b), shortest_around(a, b, sense), 1e-4);
    EXPECT_NEAR(norm(contact->first), 1, 1e-12);
    EXPECT_NEAR(dot(contact->first, a - contact->first), 0, 1e-12) << "a tangent";
    EXPECT_NEAR(dot(contact->second, b - contact->second), 0, 1e-12);
    const StringObstacle far_side{1, true, true, -3.0 * (a + b)};
    EXPECT_NEAR(whole(far_side, a, b), shortest_around(a, b, -sense), 1e-4);
  }
  EXPECT_GT(touched, 5);
}

TEST(TautString, IsStraightWhereNothingIsInTheWay) {
  const Vec3d a{-2, 1.5, 0}, b{2, 1.5, 0};
  EXPECT_FALSE(touch({1, true}, a, b));
  EXPECT_FALSE(touch({1, false}, a, b));
  EXPECT_FALSE(touch({1, true, true, {0, 3, 0}}, a, b)) << "it is on its side";
  EXPECT_TRUE(touch({1, true, true, {0, -3, 0}}, a, b)) << "it has to go around";
  EXPECT_FALSE(touch({1, true}, {0.5, 0, 0}, {0, -2, 0})) << "it begins inside";
  EXPECT_FALSE(touch({0, true}, {-1, 0, 0}, {1, 0, 0})) << "nothing is there";
}

// A quarter of a great circle between tangents of length 1: in a plane that is turned.
TEST(TautString, FollowsGreatCircles) {
  const Mat3d turn = rotation(Vec3d{0.6, 0, 0.8}, 0.7);
  const Vec3d a = turn * Vec3d{1, -1, 0}, b = turn * Vec3d{-1, 1, 0};
  const auto contact = touch({1, false}, a, b);
  ASSERT_TRUE(contact);
  EXPECT_NEAR(contact->length, pi / 2, 1e-12);
  EXPECT_NEAR(norm(contact->first - a), 1, 1e-12);
  EXPECT_NEAR(whole({1, false}, a, b), 2 + pi / 2, 1e-12);
}

// On the unrolled cylinder the string is straight: its length is the hypotenuse of that across and that along.
TEST(TautString, IsAHelixOnACylinder) {
  const Vec3d a{1, -1, 0.3}, b{-1, 1, 2.3};
  EXPECT_NEAR(whole({1, true}, a, b), std::hypot(2 + pi / 2, 2.0), 1e-12);
  const auto contact = touch({1, true}, a, b);
  ASSERT_TRUE(contact);
  EXPECT_NEAR(contact->first.z, 0.3 + 2 / (2 + pi / 2), 1e-12);
}

// Through a ring the string takes the shortest way over one of its points.
TEST(TautString, GoesThroughARing) {
  const Vec3d a{-2, 1.5, 0}, b{1.3, 2, 0};
  const StringObstacle ring{1, true, true, {0.1, 0.2, 0}};
  double best = 1e9;
  for (int i = 0; i < 36000; ++i) {
    const Vec3d t{std::cos(2 * pi * i / 36000), std::sin(2 * pi * i / 36000), 0};
    best = std::min(best, norm(t - a) + norm(b - t));
  }
  EXPECT_NEAR(whole(ring, a, b), best, 1e-6);
  EXPECT_GT(best, norm(b - a) + 0.1);
  EXPECT_FALSE(touch(ring, {-2, 0.1, 0}, {2, 0.3, 0})) << "the straight line goes through it";
}

TEST(TautString, RunsThroughPointsAndAroundObstacles) {
  const std::vector<StringPart> parts{{{{1, -1, 0}, {}}}, {{{0, 0, 0}, {}}, {1, true}},  {{{-1, 1, 0}, {}}},
                                      {{{-1, 4, 0}, {}}}, {{{5, 0, 0}, {}}, {1, false}}, {{{-1, 4, 4}, {}}}};
  EXPECT_NEAR(string_length(parts), 2 + pi / 2 + 3 + 4, 1e-12);
}

}  // namespace
}  // namespace murosimf
