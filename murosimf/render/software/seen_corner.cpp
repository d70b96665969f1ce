#include "murosimf/render/software/seen_corner.h"

namespace murosimf::render::software {

void see(const RenderMesh& mesh, const Instance& instance, KeptPlaces places, std::vector<SeenCorner>& corners) {
  corners.resize(mesh.corners.size());
  const auto &x = instance.row_x, &y = instance.row_y, &z = instance.row_z;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto& p = mesh.corners[i].place;
    const std::array<float, 3> n{mesh.corners[i].normal[0] * instance.normal_scale[0],
                                 mesh.corners[i].normal[1] * instance.normal_scale[1],
                                 mesh.corners[i].normal[2] * instance.normal_scale[2]};
    SeenCorner& corner = corners[i];
    corner.x = x[0] * p[0] + x[1] * p[1] + x[2] * p[2] + x[3];
    corner.y = y[0] * p[0] + y[1] * p[1] + y[2] * p[2] + y[3];
    corner.z = z[0] * p[0] + z[1] * p[1] + z[2] * p[2] + z[3];
    corner.normal = {x[0] * n[0] + x[1] * n[1] + x[2] * n[2], y[0] * n[0] + y[1] * n[1] + y[2] * n[2],
                     z[0] * n[0] + z[1] * n[1] + z[2] * n[2]};
    if (places == KeptPlaces::on_solid) corner.place = p;
    if (places == KeptPlaces::in_own_picture) corner.place = {mesh.places[i][0], mesh.places[i][1], 0};
  }
}

void see(const LookSurface& surface, const PixelRays& rays, std::vector<SeenCorner>& corners) {
  corners.clear();
  for (const LookCorner& corner : surface.corners) {
    const Float3 seen = rays.seen({corner.place[0], corner.place[1], corner.place[2]});
    corners.push_back({seen.x, seen.y, seen.z, {}, {corner.at[0], corner.at[1], 0}});
    corners.back().project(rays);
  }
}

NearCut::NearCut(const PixelRays& rays, const std::array<const SeenCorner*, 3>& corners) {
  std::array<const SeenCorner*, 4> kept{};
  std::size_t size = 0, made_count = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const SeenCorner &a = *corners[i], &b = *corners[(i + 1) % 3];
    if (a.z >= nearest_z) kept[size++] = &a;
    if ((a.z >= nearest_z) == (b.z >= nearest_z)) continue;
    const float t = (nearest_z - a.z) / (b.z - a.z);
    SeenCorner& cut = made[made_count++];
    cut = {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), nearest_z, {}, {}};
    for (std::size_t k = 0; k < 3; ++k) {
      cut.normal[k] = a.normal[k] + t * (b.normal[k] - a.normal[k]);
      cut.place[k] = a.place[k] + t * (b.place[k] - a.place[k]);
    }
    cut.project(rays);
    kept[size++] = &cut;
  }
  for (std::size_t i = 2; i < size; ++i) parts[static_cast<std::size_t>(count++)] = {kept[0], kept[i - 1], kept[i]};
}

}  // namespace murosimf::render::software
