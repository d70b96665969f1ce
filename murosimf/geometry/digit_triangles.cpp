#include "murosimf/geometry/digit_triangles.h"

#include <string>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::geometry {
namespace {

constexpr double half_stroke = 0.1, digit_width = 0.6, gap = 0.12;
constexpr double w = 0.2, h = 0.4;                          // middle of the outer strokes, from the digit's middle
constexpr double e = w + half_stroke, f = h + half_stroke;  // outer border
constexpr double c = 0.1;                                   // of a corner that is cut

using Line = std::vector<Vec3d>;

/// A ring with cut corners between two heights; begins and ends in the middle of its left side.
Line ring(double low, double high) {
  const double middle = 0.5 * (low + high);
  return {{-w, middle, 0},  {-w, low + c, 0}, {-w + c, low, 0},  {w - c, low, 0},   {w, low + c, 0},
          {w, high - c, 0}, {w - c, high, 0}, {-w + c, high, 0}, {-w, high - c, 0}, {-w, middle, 0}};
}

Line turned_half(Line line) {
  for (Vec3d& p : line) p = -p;
  return line;
}

/// Middle lines of the strokes.
std::vector<Line> strokes_of(int digit) {
  MUROSIMF_ASSERT(digit >= 0 && digit <= 9);
  const Line six{{w, 0.22, 0},    {w, h - c, 0},  {w - c, h, 0},  {-w + c, h, 0},   {-w, h - c, 0},   {-w, -h + c, 0},
                 {-w + c, -h, 0}, {w - c, -h, 0}, {w, -h + c, 0}, {w, 0.04 - c, 0}, {w - c, 0.04, 0}, {-w, 0.04, 0}};
  const Line half_three{{-w, 0.24, 0}, {-w, h - c, 0}, {-w + c, h, 0}, {w - c, h, 0},
                        {w, h - c, 0}, {w, c, 0},      {w - c, 0, 0},  {-0.08, 0, 0}};
  Line lower_half = half_three;
  for (Vec3d& p : lower_half) p.y = -p.y;
  switch (digit) {
    case 0: return {ring(-h, h)};
    case 1: return {{{0.04, -f, 0}, {0.04, f, 0}}, {{0.04, 0.36, 0}, {-0.18, 0.2, 0}}};
    case 2:
      return {
          {{-w, 0.2, 0}, {-w, h - c, 0}, {-w + c, h, 0}, {w - c, h, 0}, {w, h - c, 0}, {w, 0.1, 0}, {-0.17, -0.36, 0}},
          {{-e, -h, 0}, {e, -h, 0}}};
    case 3: return {half_three, lower_half};
    case 4: return {{{-w, f, 0}, {-w, -0.1, 0}, {e, -0.1, 0}}, {{0.1, 0.2, 0}, {0.1, -f, 0}}};
    case 5:
      return {{{e, h, 0},
               {-w, h, 0},
               {-w, 0.06, 0},
               {w - c, 0.06, 0},
               {w, 0.06 - c, 0},
               {w, -h + c, 0},
               {w - c, -h, 0},
               {-w + c, -h, 0},
               {-w, -h + c, 0},
               {-w, -0.24, 0}}};
    case 6: return {six};
    case 7: return {{{-e, h, 0}, {0.165, h, 0}, {-0.09, -0.4715, 0}}};
    case 8: return {ring(-h, 0), ring(0, h)};
    default: return {turned_half(six)};
  }
}

/// To the left of a stroke from `a` to `b`.
Vec3d left_of(const Vec3d& a, const Vec3d& b) {
  const Vec3d along = (1 / norm(b - a)) * (b - a);
  return {-along.y, along.x, 0};
}

/// From the middle line to the border, where two parts of a stroke meet.
Vec3d miter(const Vec3d& before, const Vec3d& after) {
  return (half_stroke / (1 + dot(before, after))) * (before + after);
}

void add_stroke(const Line& line, const Vec3d& middle, TriangleMesh& mesh) {
  MUROSIMF_ASSERT(line.size() >= 2);
  const std::size_t last = line.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    const Vec3d before = i > 0 ? left_of(line[i - 1], line[i]) : left_of(line[0], line[1]);
    const Vec3d after = i < last ? left_of(line[i], line[i + 1]) : before;
    const Vec3d out = miter(before, after);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back(middle + line[i] + out);
    mesh.vertices.push_back(middle + line[i] - out);
    if (i == last) continue;
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first + 2, first + 1, first + 3});
  }
}

std::string digits_of(int number) {
  if (number < 0) throw SetupError(fmt::format("the number {} cannot be painted; it must be at least 0", number));
  return std::to_string(number);
}

}  // namespace

double number_width(int number) { return static_cast<double>(digits_of(number).size()) * (digit_width + gap) - gap; }

TriangleMesh digit_triangles(int number) {
  TriangleMesh mesh;
  Vec3d middle{0.5 * (digit_width - number_width(number)), 0, 0};
  for (const char digit : digits_of(number)) {
    for (const Line& line : strokes_of(digit - '0')) add_stroke(line, middle, mesh);
    middle.x += digit_width + gap;
  }
  return mesh;
}

}  // namespace murosimf::geometry
