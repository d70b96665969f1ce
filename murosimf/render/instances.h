/// instances.h - the pieces of a scene as a view sees them: which can be in the picture, how round they must be, and in
/// which order they are drawn: see-through ones last, the farthest first, so that each is laid over what is behind it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "murosimf/render/projection.h"
#include "murosimf/render/render_scene.h"

namespace murosimf::render {

/// Solids that a drawing needs, and where the meshes begin among them.
struct MeshCatalog {
  std::vector<RenderMesh> meshes;
  std::size_t first_mesh = 0;
};

/// Round solids at all levels of roundness, the box, then the meshes.
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

/// All instances of a view, those of one solid one after the other. Kept from picture to picture: no allocations.
class InstanceList {
 public:
  /// Pieces that are in the picture. Round ones are off by less than a quarter of a pixel, and with `depths` by less than
  /// half a millimeter.
  void fill(const RenderScene& render_scene, const Projection& projection, bool depths, double ahead,
            const MeshCatalog& catalog);
  /// All pieces but see-through ones, for a lamp that looks along the third axis from `eye`; z counts from there.
  void fill_all(const RenderScene& render_scene, const Vec3d& eye, const Mat3d& axes, double ahead,
                const MeshCatalog& catalog);

  [[nodiscard]] std::span<const Instance> instances() const { return sorted_; }
  [[nodiscard]] std::span<const InstanceGroup> groups() const { return groups_; }
  /// Those that nothing shines through, and the others.
  [[nodiscard]] std::span<const InstanceGroup> solid_groups() const { return groups().first(solid_groups_); }
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
  std::size_t solid_groups_ = 0;
  std::vector<std::pair<std::size_t, Instance>> clear_;  // see-through pieces with their solids
};

}  // namespace murosimf::render
