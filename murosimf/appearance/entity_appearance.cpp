#include "murosimf/appearance/entity_appearance.h"

#include <cctype>

namespace murosimf::appearance {
namespace {

render::EntityAppearance drawn(const Appearance& appearance) {
  render::EntityAppearance result;
  for (const SeenMesh& seen : appearance.meshes) {
    result.meshes.push_back({seen.object, render::render_mesh_of(seen.mesh, seen.picture), seen.color, seen.as_it_is});
  }
  for (const SeenShape& seen : appearance.shapes) result.shapes.push_back({seen.object, seen.placed});
  return result;
}

/// [1] White or black, whichever is legible on the color (Rec. 709 weights).
Color readable_on(const Color& color) {
  const double brightness = 0.2126 * color.red + 0.7152 * color.green + 0.0722 * color.blue;
  return brightness < 0.5 ? Color{0.97, 0.97, 0.97} : Color{0.03, 0.03, 0.03};
}

}  // namespace

int jersey_number(const std::string& name) {
  std::size_t begin = name.size();
  while (begin > 0 && std::isdigit(static_cast<unsigned char>(name[begin - 1])) != 0) --begin;
  return begin == name.size() || name.size() - begin > 3 ? -1 : std::stoi(name.substr(begin));
}

render::EntityAppearance AppearanceLibrary::appearance(const Entity& entity) {
  const auto [found, is_new] = models_.try_emplace(&entity.model());
  ModelAppearance& model = found->second;
  if (is_new) {
    const Appearance appearance = appearance_of(entity.model(), usual_triangles, pictures_, use_);
    model = {drawn(appearance), jersey_numbers(entity.model(), appearance)};
    warnings_.insert(warnings_.end(), appearance.warnings.begin(), appearance.warnings.end());
  }
  render::EntityAppearance own = model.drawn;
  const int number = jersey_number(entity.name());
  if (number < 0 || entity.options().team.empty()) return own;
  for (const JerseyNumber& plate : model.plates) {
    const geometry::TriangleMesh digits = number_on(plate, number);
    own.meshes.push_back({plate.object, render::render_mesh_of(digits), readable_on(entity.options().color)});
  }
  return own;
}

}  // namespace murosimf::appearance
