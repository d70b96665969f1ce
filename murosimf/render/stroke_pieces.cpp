#include "murosimf/render/stroke_pieces.h"

#include <algorithm>
#include <cmath>

#include "murosimf/math/assert.h"
#include "murosimf/math/scalar.h"

namespace murosimf::render {
namespace {

/// The end `at` of a piece from or to `before`, where one to or from `after` follows.
StrokePiece::End joint(const Vec3d& before, const Vec3d& at, const Vec3d& after, double half_width) {
  const Vec3d a = at - before, b = after - at;
  const double turn = std::abs(std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y));
  // The miter of a bend; beyond a right angle the tangent grows without bound.
  return {at.x, at.y, half_width * std::tan(std::min(0.5 * turn, 0.25 * pi)), turn < 0.5};
}

void add_pieces(const Stroke& stroke, std::vector<StrokePiece>& pieces) {
  const auto& p = stroke.points;
  const double half = 0.5 * stroke.width;
  MUROSIMF_ASSERT(half >= 0);
  if (p.size() < 2) return;
  const std::size_t last = p.size() - 1;
  const bool closed = p.size() > 2 && norm(p.front() - p.back()) < 1e-9;
  for (std::size_t i = 0; i < last; ++i) {
    if (p[i].x == p[i + 1].x && p[i].y == p[i + 1].y) continue;
    StrokePiece piece{{p[i].x, p[i].y}, {p[i + 1].x, p[i + 1].y}, half};
    if (i > 0 || closed) piece.begin = joint(p[i > 0 ? i - 1 : last - 1], p[i], p[i + 1], half);
    if (i + 1 < last || closed) piece.end = joint(p[i], p[i + 1], p[i + 1 < last ? i + 2 : 1], half);
    pieces.push_back(piece);
  }
}

}  // namespace

std::vector<StrokePiece> stroke_pieces(const Markings& markings) {
  std::vector<StrokePiece> pieces;
  for (const Stroke& stroke : markings.strokes) add_pieces(stroke, pieces);
  return pieces;
}

}  // namespace murosimf::render
