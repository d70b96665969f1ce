// Trees with a margin: right as long as they say so, and no longer than the margin allows.
#include <gtest/gtest.h>

#include <limits>

#include "murosimf/geometry/any_tree.h"
#include "murosimf/geometry/volume_overlap.h"
#include "murosimf/math/random.h"
#include "tests/fixtures.h"

namespace murosimf::geometry {
namespace {

constexpr double margin = 0.01;  // [m]

/// All kinds of shapes side by side, each on an object of its own.
struct Row {
  explicit Row(const std::string& volume) : shapes(fixtures::shapes_of_all_kinds()) {
    std::vector<TreePart> parts;
    std::vector<BoundingSphere> spheres;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      parts.push_back({static_cast<int>(i), &shapes[i], {{0.02, -0.01, 0.03}, {}}});
      spheres.push_back(fit<BoundingSphere>(shapes[i], parts.back().at));
      r.push_back({0.4 * static_cast<double>(i), 0, 0});
      R.push_back({});
    }
    tree = make_tree(volume, parts, split_top_down(spheres), margin);
    std::visit([&](auto& t) { t.refit(r, R); }, tree);
  }
  [[nodiscard]] bool still_fits() const {
    return std::visit([&](const auto& t) { return t.still_fits(r, R); }, tree);
  }
  /// A point of a shape [m], where it is now, is inside the bounding volume that the shape had.
  [[nodiscard]] bool encloses(std::size_t shape, const Vec3d& point) const {
    const Vec3d world = r[shape] + R[shape] * (Vec3d{0.02, -0.01, 0.03} + point);
    const BoundingSphere dot{world, 1e-12};  // rounding
    return std::visit([&](const auto& t) { return overlap(t.leaf_volume(static_cast<int>(shape)), dot); }, tree);
  }
  /// One object moves by `way` [m] and turns by `angle` [rad].
  void move(std::size_t object, const Vec3d& way, const Vec3d& axis, double angle) {
    r[object] += way;
    R[object] = rotation(axis, angle) * R[object];
  }

  std::vector<Shape> shapes;
  std::vector<Vec3d> r;
  std::vector<Mat3d> R;
  AnyTree tree;
};

class Margin : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Volumes, Margin, testing::Values("sphere", "aabb", "obb", "capsule"),
                         [](const auto& test) { return test.param; });

TEST_P(Margin, HoldsEverythingAsLongAsItFits) {
  const RandomStream random(1, GetParam());
  int fitted = 0;
  for (std::uint64_t trial = 0; trial < 200; ++trial) {
    Row row(GetParam());
    const auto number = [&](std::uint64_t n, double size) { return random.uniform(16 * trial + n, -size, size); };
    const std::size_t object = trial % row.shapes.size();
    const Vec3d axis = Vec3d{number(0, 1), number(1, 1), number(2, 1)};
    row.move(object, {number(3, 0.008), number(4, 0.008), number(5, 0.008)}, (1 / norm(axis)) * axis, number(6, 0.05));
    if (!row.still_fits()) continue;
    ++fitted;
    for (const Vec3d& point : fixtures::surface_samples(row.shapes[object])) {
      ASSERT_TRUE(row.encloses(object, point)) << shape_name(row.shapes[object]) << ", trial " << trial;
    }
  }
  EXPECT_GT(fitted, 20);
  EXPECT_LT(fitted, 190);
}

TEST_P(Margin, EndsWithTheMargin) {
  Row row(GetParam());
  EXPECT_TRUE(row.still_fits());
  row.move(2, {0, 0.99 * margin, 0}, {0, 0, 1}, 0);
  EXPECT_TRUE(row.still_fits());
  row.move(2, {0, 0.02 * margin, 0}, {0, 0, 1}, 0);
  EXPECT_FALSE(row.still_fits());
}

TEST_P(Margin, DoesNotTrustBadNumbers) {
  Row row(GetParam());
  row.r[1].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(row.still_fits());
}

}  // namespace
}  // namespace murosimf::geometry
