/// seen_corner.h - corners of triangles in the optical frame of a view and in its picture.
#pragma once

#include <array>
#include <vector>

#include "murosimf/render/instances.h"
#include "murosimf/render/look.h"
#include "murosimf/render/software/coverage.h"
#include "murosimf/render/software/pixel_rays.h"

namespace murosimf::render::software {

inline constexpr auto nearest_z = static_cast<float>(nearest_drawn);  ///< [m]

/// A corner in the optical frame.
struct SeenCorner {
  float x = 0, y = 0, z = 0;  ///< [m]
  std::array<float, 3> normal{}, place{};
  Corner in_picture{};  ///< set by project(), where z is not 0
  [[nodiscard]] Vec3d optical() const { return {double{x}, double{y}, double{z}}; }
  void project(const PixelRays& rays) {
    const float per_z = 1 / z;
    in_picture = {rays.u_of(x * per_z), rays.v_of(y * per_z), per_z};
  }
};

/// Which places of corners are kept: those on the solid, or those in the picture that it shows.
enum class KeptPlaces { none, on_solid, in_own_picture };
/// The corners of an instance of a solid, without their places in the picture that is drawn.
void see(const RenderMesh& mesh, const Instance& instance, KeptPlaces places, std::vector<SeenCorner>& corners);
/// The corners of a surface that is only looked at.
void see(const LookSurface& surface, const PixelRays& rays, std::vector<SeenCorner>& corners);

/// The parts of a triangle that are not closer than nearest_z: none, one or two triangles.
struct NearCut {
  NearCut(const PixelRays& rays, const std::array<const SeenCorner*, 3>& corners);
  NearCut(const NearCut&) = delete;  // the parts refer to corners that it has
  NearCut& operator=(const NearCut&) = delete;
  std::array<SeenCorner, 4> made{};
  std::array<std::array<const SeenCorner*, 3>, 2> parts{};
  int count = 0;
};

/// Calls visit(corners) for the triangle, or for its parts that are not too close.
template <class Visit>
void for_near_parts(const PixelRays& rays, const std::array<const SeenCorner*, 3>& corners, const Visit& visit) {
  if (corners[0]->z >= nearest_z && corners[1]->z >= nearest_z && corners[2]->z >= nearest_z) {
    visit(corners);
    return;
  }
  const NearCut cut(rays, corners);
  for (int i = 0; i < cut.count; ++i) visit(cut.parts[static_cast<std::size_t>(i)]);
}

}  // namespace murosimf::render::software
