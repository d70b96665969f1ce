/// seen_solids.h - the triangles of instances of solids.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "murosimf/render/instances.h"
#include "murosimf/render/software/surface_buffer.h"

namespace murosimf::render::software {

/// A color, counted linearly.
[[nodiscard]] Float3 linear_color(const std::array<std::uint8_t, 4>& srgb);

/// The corners of the instances of solids, in the optical frame.
class SeenSolids {
 public:
  /// Calls visit(corners, surface) for each triangle of these groups. `paneled`: balls show their panels.
  template <class Visit>
  void for_triangles(const PixelRays& rays, const MeshCatalog& catalog, const InstanceList& list,
                     std::span<const InstanceGroup> groups, bool paneled, const Visit& visit);

 private:
  std::vector<SeenCorner> corners_;
};

// ---- definitions ----

template <class Visit>
void SeenSolids::for_triangles(const PixelRays& rays, const MeshCatalog& catalog, const InstanceList& list,
                               std::span<const InstanceGroup> groups, bool paneled, const Visit& visit) {
  for (const InstanceGroup& group : groups) {
    const RenderMesh& mesh = catalog.meshes[group.solid];
    const bool ball = paneled && group.solid >= catalog.first_ball;
    const KeptPlaces places = ball           ? KeptPlaces::on_solid
                              : mesh.picture ? KeptPlaces::in_own_picture
                                             : KeptPlaces::none;
    for (std::size_t i = group.first; i < group.first + group.count; ++i) {
      const Instance& instance = list.instances()[i];
      see(mesh, instance, places, corners_);
      for (SeenCorner& corner : corners_) corner.project(rays);
      Surface surface;
      surface.base = linear_color(instance.color);
      surface.alpha = static_cast<float>(instance.color[3]) / 255;
      surface.label = static_cast<std::uint16_t>(instance.label);
      surface.piece = static_cast<std::int32_t>(i);
      surface.kind = ball ? Surface::Kind::ball : mesh.picture ? Surface::Kind::pictured : Surface::Kind::solid;
      surface.picture = mesh.picture.get();
      for (std::size_t k = 0; k < mesh.triangles.size(); k += 3) {
        visit(std::array<const SeenCorner*, 3>{&corners_[mesh.triangles[k]], &corners_[mesh.triangles[k + 1]],
                                               &corners_[mesh.triangles[k + 2]]},
              surface);
      }
    }
  }
}

}  // namespace murosimf::render::software
