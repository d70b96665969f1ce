#include "murosimf/appearance/entity_looks.h"

#include <cctype>

#include "murosimf/appearance/visual_meshes.h"

namespace murosimf::appearance {
namespace {

render::EntityLooks drawn(const Looks& looks) {
  render::EntityLooks result;
  for (const SeenMesh& seen : looks.meshes) {
    result.solids.push_back({seen.object, render::solid_of(seen.mesh.vertices, seen.mesh.triangles), seen.color});
  }
  for (const SeenShape& seen : looks.shapes) result.shapes.push_back({seen.object, seen.placed});
  return result;
}

/// [1] White or black, whichever can be read on the color (Rec. 709 weights).
Color readable_on(const Color& color) {
  const double brightness = 0.2126 * color.red + 0.7152 * color.green + 0.0722 * color.blue;
  return brightness < 0.5 ? Color{0.97, 0.97, 0.97} : Color{0.03, 0.03, 0.03};
}

}  // namespace

int shirt_number(const std::string& name) {
  std::size_t begin = name.size();
  while (begin > 0 && std::isdigit(static_cast<unsigned char>(name[begin - 1])) != 0) --begin;
  return begin == name.size() || name.size() - begin > 3 ? -1 : std::stoi(name.substr(begin));
}

render::EntityLooks LooksLibrary::looks(const Entity& entity) {
  const auto [found, is_new] = models_.try_emplace(&entity.model());
  ModelLooks& model = found->second;
  if (is_new) {
    const Looks looks = looks_of(entity.model());
    model = {drawn(looks), number_plates(entity.model(), looks)};
    warnings_.insert(warnings_.end(), looks.warnings.begin(), looks.warnings.end());
  }
  render::EntityLooks own = model.drawn;
  const int number = shirt_number(entity.name());
  if (number < 0 || entity.options().team.empty()) return own;
  for (const NumberPlate& plate : model.plates) {
    const geometry::TriangleMesh digits = number_on(plate, number);
    own.solids.push_back(
        {plate.object, render::solid_of(digits.vertices, digits.triangles), readable_on(entity.options().color)});
  }
  return own;
}

}  // namespace murosimf::appearance
