/// instances.h - the pieces of a scene for one view: which may be visible, how round they must be, and in
/// which order they are drawn: transparent ones last, the farthest first, so that each is blended over what is behind it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "murosimf/render/projection.h"
#include "murosimf/render/render_scene.h"

namespace murosimf::render {

/// Solids for drawing; meshes begin at `first_mesh`, balls at `first_ball`.
struct MeshCatalog {
  std::vector<RenderMesh> meshes;
  std::size_t first_mesh = 0, first_ball = 0;
};

/// Round solids at all levels of roundness, the box, the meshes, then spheres once more, for balls with panels.
[[nodiscard]] MeshCatalog solid_catalog(std::span<const RenderMesh> meshes);

/// One piece for the graphics device: rows of the matrix that takes the solid to optical axes.
struct Instance {
  std::array<float, 4> row_x, row_y, row_z;
  std::array<float, 3> normal_scale;  ///< 1 / scale^2
  std::array<std::uint8_t, 4> color;  ///< sRGB, alpha
  std::uint32_t label;
};

/// Instances of one solid.
struct InstanceGroup {
  std::size_t solid = 0, first = 0, count = 0;
};

/// All instances of a view, grouped by solid. Kept from picture to picture: no allocations.
class InstanceList {
 public:
  /// Collects pieces that may be visible. The outline of round ones is exact to a quarter of a pixel, and with `depths` to
  /// half a millimeter.
  void fill(const RenderScene& render_scene, const Projection& projection, bool depths, double ahead,
            const MeshCatalog& catalog);
  /// Collects all pieces, for a lamp that looks along the third axis from `eye`; z counts from there. Transparent ones are last.
  void fill_all(const RenderScene& render_scene, const Vec3d& eye, const Mat3d& axes, double ahead,
                const MeshCatalog& catalog);

  [[nodiscard]] std::span<const Instance> instances() const { return sorted_; }
  [[nodiscard]] std::span<const InstanceGroup> groups() const { return groups_; }
  /// Groups of opaque pieces, and the others; the last `ball_groups()` of the opaque ones are balls.
  [[nodiscard]] std::span<const InstanceGroup> solid_groups() const { return groups().first(solid_groups_); }
  [[nodiscard]] std::size_t ball_groups() const { return ball_groups_; }
  [[nodiscard]] std::span<const InstanceGroup> clear_groups() const { return groups().subspan(solid_groups_); }

 private:
  void begin(const MeshCatalog& catalog);
  void add(std::size_t solid, const Drawable& drawable, const Transformd& optical);
  void sort();
  void append_clear();

  std::vector<Instance> unsorted_, sorted_;
  std::vector<std::size_t> render_mesh_of_;  // by unsorted instance
  std::vector<std::size_t> first_of_;        // by solid
  std::vector<InstanceGroup> groups_;
  std::size_t solid_groups_ = 0, ball_groups_ = 0, first_ball_ = 0;
  std::vector<std::pair<std::size_t, Instance>> clear_;  // see-through pieces with their solids
};

}  // namespace murosimf::render
