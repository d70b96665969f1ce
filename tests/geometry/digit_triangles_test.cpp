// Digits for shirts: their size, and that they can be told apart.
#include "murosimf/geometry/digit_triangles.h"

#include <algorithm>
#include <bitset>

#include "tests/fixtures.h"

namespace murosimf::geometry {
namespace {

constexpr int columns = 30, rows = 50;
using Picture = std::bitset<columns * rows>;

bool covers(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& corners, const Vec3d& p) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3d &a = mesh.vertices[corners[i]], &b = mesh.vertices[corners[(i + 1) % 3]];
    if (cross(b - a, p - a).z < 0) return false;
  }
  return true;
}

/// The number about the origin, 0.6 wide, as pixels.
Picture picture_of(const TriangleMesh& mesh) {
  Picture picture;
  for (int i = 0; i < columns * rows; ++i) {
    const Vec3d p{0.6 * ((i % columns + 0.5) / columns - 0.5), 0.5 - (i / columns + 0.5) / rows, 0};
    picture[i] = std::ranges::any_of(mesh.triangles, [&](const auto& corners) { return covers(mesh, corners, p); });
  }
  return picture;
}

Picture turned(const Picture& picture) {
  Picture result;
  for (int i = 0; i < columns * rows; ++i) result[i] = picture[columns * rows - 1 - i];
  return result;
}

TEST(NumberTriangles, FillTheirCells) {
  for (const int number : {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 207}) {
    double left = 1, right = -1, low = 1, high = -1;
    const TriangleMesh mesh = digit_triangles(number);
    for (const Vec3d& v : mesh.vertices) {
      left = std::min(left, v.x), right = std::max(right, v.x);
      low = std::min(low, v.y), high = std::max(high, v.y);
      EXPECT_EQ(v.z, 0);
    }
    EXPECT_NEAR(high, 0.5, 1e-3) << number;
    EXPECT_NEAR(low, -0.5, 1e-3) << number;
    const double width = number < 10 ? 0.6 : number < 100 ? 1.32 : 2.04;
    EXPECT_DOUBLE_EQ(number_width(number), width);
    EXPECT_LE(std::max(right, -left), 0.5 * width + 1e-12) << number;
    for (const auto& [a, b, c] : mesh.triangles) {
      EXPECT_GT(cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]).z, 0) << number;
    }
  }
}

TEST(NumberTriangles, CanBeToldApart) {
  std::vector<Picture> pictures;
  for (int digit = 0; digit < 10; ++digit) {
    const Picture picture = picture_of(digit_triangles(digit));
    EXPECT_GT(picture.count(), columns * rows / 4U) << digit << " is bold";
    for (std::size_t other = 0; other < pictures.size(); ++other) {
      EXPECT_GT((picture ^ pictures[other]).count(), columns * rows / 20U) << digit << " and " << other;
    }
    pictures.push_back(picture);
  }
  EXPECT_LT((pictures[6] ^ turned(pictures[9])).count(), 5U) << "9 is 6 upside down";
  for (const int digit : {0, 8}) EXPECT_LT((pictures[digit] ^ turned(pictures[digit])).count(), 5U) << digit;
}

TEST(NumberTriangles, OfTwoDigitsAreTwoDigits) {
  TriangleMesh mesh = digit_triangles(42);
  for (Vec3d& v : mesh.vertices) v.x += 0.36;
  EXPECT_EQ(picture_of(mesh), picture_of(digit_triangles(4)));
  for (Vec3d& v : mesh.vertices) v.x -= 0.72;
  EXPECT_EQ(picture_of(mesh), picture_of(digit_triangles(2)));
}

TEST(NumberTriangles, OfNegativeNumbersThereAreNone) {
  EXPECT_TRUE(fixtures::says(fixtures::error_of([] { (void)digit_triangles(-1); }), {"number -1", "at least 0"}));
}

}  // namespace
}  // namespace murosimf::geometry
