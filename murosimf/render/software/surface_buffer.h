/// surface_buffer.h - which triangle each pixel of a picture shows, and what shading needs to know of it.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "murosimf/imaging/mip_picture.h"
#include "murosimf/math/assert.h"
#include "murosimf/render/software/seen_corner.h"

namespace murosimf::render::software {

/// A triangle in the picture. Numbers of its surface are linear in the picture once they are multiplied with 1 / z.
struct Surface {
  enum class Kind : std::uint8_t { solid, ball, pictured, wall, ceiling, net };
  Anchor anchor;  ///< of all slopes
  Slope per_z;
  std::array<Slope, 3> normal;  ///< of solids, times 1 / z, optical frame
  std::array<Slope, 3>
      place;  ///< times 1 / z: of balls, in the frame of the ball; of others two: in the picture, or [m] on the surface
  const imaging::MipPicture* picture = nullptr;  ///< of pictured ones
  Float3 base;                                   ///< [1] color, linear
  float alpha = 1;
  std::int32_t piece = 0;  ///< of solids: number of the instance
  std::uint16_t label = 0;
  Kind kind = Kind::solid;
  /// It is there for depths and labels, too.
  [[nodiscard]] bool is_measured() const { return kind <= Kind::pictured; }
};

/// A triangle in the picture, clockwise.
struct PictureTriangle {
  PictureTriangle(const PixelRays& rays, const std::array<const SeenCorner*, 3>& of, bool back)
      : seen(of), corners{of[0]->in_picture, of[1]->in_picture, of[2]->in_picture} {
    turn = turn_of(corners);  // seen from outside they go counterclockwise
    if (turn > 0 && !back) {
      turn = 0;
    } else if (turn < 0) {
      std::swap(corners[1], corners[2]);
      std::swap(seen[1], seen[2]);
      turn = -turn;
    }
    if (turn == 0) return;
    anchor = Anchor(corners[0], rays.whole());  // some rows alone have the same bits
    const bool inside = anchor.u == corners[0].u && anchor.v == corners[0].v;
    per_z = inside ? Slopes(corners, turn, anchor).of(corners[0].per_z, corners[1].per_z, corners[2].per_z)
                   : rays.plane(seen[0]->optical(), seen[1]->optical(), seen[2]->optical(), anchor);
  }
  [[nodiscard]] bool is_seen() const { return turn > 0; }

  /// The slopes of what shading needs.
  void complete(Surface& surface) const {
    const Slopes slopes(corners, turn, anchor);
    surface.anchor = anchor;
    surface.per_z = per_z;
    const auto slope = [&](float first, float second, float third) {
      return slopes.of(first * corners[0].per_z, second * corners[1].per_z, third * corners[2].per_z);
    };
    if (surface.is_measured()) {
      for (std::size_t k = 0; k < 3; ++k)
        surface.normal[k] = slope(seen[0]->normal[k], seen[1]->normal[k], seen[2]->normal[k]);
    }
    if (surface.kind == Surface::Kind::solid) return;
    for (std::size_t k = 0; k < 3; ++k)
      surface.place[k] = slope(seen[0]->place[k], seen[1]->place[k], seen[2]->place[k]);
  }

  std::array<const SeenCorner*, 3> seen;
  std::array<Corner, 3> corners;
  float turn = 0;
  Anchor anchor;
  Slope per_z;
};

inline constexpr std::int32_t left_out =
    std::numeric_limits<std::int32_t>::min();  ///< a number: the pixel is not painted

/// For each pixel of a picture: 1 / z of the nearest surface, and its number.
class SurfaceBuffer {
 public:
  /// Forgets everything in these rows, where per_z is to be set next.
  void begin(int width, int height, int first_row, int rows);
  [[nodiscard]] const PixelBox& box() const { return box_; }
  [[nodiscard]] float* per_z(int v) { return &per_z_[row(v)]; }
  [[nodiscard]] const float* per_z(int v) const { return &per_z_[row(v)]; }
  [[nodiscard]] std::int32_t* numbers(int v) { return &numbers_[row(v)]; }  ///< 0: none; negative: only looked at
  [[nodiscard]] const std::int32_t* numbers(int v) const { return &numbers_[row(v)]; }
  [[nodiscard]] std::span<const Surface> surfaces() const { return surfaces_; }  ///< the first one stands for none

  /// Draws a triangle whose front is seen.
  void draw(const PixelRays& rays, const std::array<const SeenCorner*, 3>& corners, const Surface& as);
  /// Calls visit(surface, v, u, mask, per_z) for what of it is not hidden, and draws nothing. `back`: also if its back is seen.
  template <class Visit>
  void for_not_hidden(const PixelRays& rays, const std::array<const SeenCorner*, 3>& corners, const Surface& as,
                      bool back, const Visit& visit) const;

 private:
  [[nodiscard]] std::size_t row(int v) const {
    MUROSIMF_ASSERT(v >= box_.top && v <= box_.bottom);
    return static_cast<std::size_t>(v - box_.top) * stride_;
  }
  PixelBox box_;
  std::size_t stride_ = 0;
  std::vector<float> per_z_;
  std::vector<std::int32_t> numbers_;
  std::vector<Surface> surfaces_;
};

// ---- definitions ----

template <class Visit>
void SurfaceBuffer::for_not_hidden(const PixelRays& rays, const std::array<const SeenCorner*, 3>& corners,
                                   const Surface& as, bool back, const Visit& visit) const {
  for_near_parts(rays, corners, [&](const std::array<const SeenCorner*, 3>& part) {
    const PictureTriangle triangle(rays, part, back);
    if (!triangle.is_seen()) return;
    Surface surface = as;
    triangle.complete(surface);
    for_covered(triangle.corners, triangle.per_z, triangle.anchor, box_,
                [&](int v, int u, const Ints& inside, const Floats& at) {
                  const Ints seen = inside & (at > load_lanes<Floats>(per_z(v) + u));
                  if (any(seen)) visit(surface, v, u, seen, at);
                });
  });
}

}  // namespace murosimf::render::software
