#include "murosimf/robot_formats/mesh/dae_material.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "murosimf/model/error.h"

namespace murosimf::robot_formats::mesh {
namespace {

/// The first element at the end of a path of tags; nothing: there is none.
std::optional<files::XmlElement> at(files::XmlElement element, std::initializer_list<const char*> path) {
  for (const char* tag : path) {
    const auto found = element.children(tag);
    if (found.empty()) return std::nullopt;
    element = found[0];
  }
  return element;
}

void read_diffuse(const files::XmlElement& effect, MeshMaterial& material) {
  const auto technique = at(effect, {"profile_COMMON", "technique"});
  if (!technique) return;
  for (const char* shading : {"phong", "lambert", "blinn"}) {
    const auto diffuse = at(*technique, {shading, "diffuse"});
    if (!diffuse) continue;
    material.textured = at(*diffuse, {"texture"}).has_value();
    const auto color = at(*diffuse, {"color"});
    const auto numbers = color ? files::parse_numbers(color->text()) : std::nullopt;
    if (!numbers || numbers->size() < 3) continue;
    const auto share = [&](std::size_t i) { return std::clamp((*numbers)[i], 0.0, 1.0); };
    material.color = Color{share(0), share(1), share(2)};
  }
}

}  // namespace

std::map<std::string, MeshMaterial> bound_materials(const files::XmlElement& use, const DaeIds& ids) {
  std::map<std::string, MeshMaterial> materials;
  const auto bound = at(use, {"bind_material", "technique_common"});
  if (!bound) return materials;
  for (const files::XmlElement& instance : bound->children("instance_material")) {
    MeshMaterial material{.name = instance.attribute("target").value_or("")};
    try {
      const files::XmlElement& target = ids.find(instance, "target");
      if (const auto effect = at(target, {"instance_effect"})) read_diffuse(ids.find(*effect, "url"), material);
    } catch (const SetupError&) {
      // a mesh is its surface: a material that is not in the file takes nothing from that
      material.color.reset();
    }
    materials.emplace(instance.attribute("symbol").value_or(""), material);
  }
  return materials;
}

}  // namespace murosimf::robot_formats::mesh
