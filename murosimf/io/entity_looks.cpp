#include "murosimf/io/entity_looks.h"

#include "murosimf/io/visual_meshes.h"

namespace murosimf::io {
namespace {

render::EntityLooks drawn(const Looks& looks) {
  render::EntityLooks result;
  for (const SeenMesh& seen : looks.meshes) {
    result.solids.push_back({seen.object, render::solid_of(seen.mesh.vertices, seen.mesh.triangles), seen.color});
  }
  for (const SeenShape& seen : looks.shapes) result.shapes.push_back({seen.object, seen.placed});
  return result;
}

}  // namespace

render::EntityLooks LooksLibrary::looks(const Entity& entity) {
  const auto [found, is_new] = models_.try_emplace(&entity.model());
  if (is_new) {
    const Looks looks = looks_of(entity.model());
    found->second = drawn(looks);
    warnings_.insert(warnings_.end(), looks.warnings.begin(), looks.warnings.end());
  }
  return found->second;
}

}  // namespace murosimf::io
