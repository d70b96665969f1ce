#include "murosimf/robot_formats/mesh/dae_material.h"

#include <algorithm>
#include <array>
#include <initializer_list>
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

/// The text of the first element at the end of a path of tags in the parameter `sid` of an effect; empty: there is none.
std::string parameter(const files::XmlElement& profile, const std::string& sid,
                      std::initializer_list<const char*> path) {
  for (const files::XmlElement& one : profile.children("newparam")) {
    if (one.attribute("sid").value_or("") != sid) continue;
    const auto found = at(one, path);
    return found ? found->text() : "";
  }
  return "";
}

/// The file of a texture: it names a sampler, that a surface, that an image; exporters leave steps out.
std::string picture_of(const files::XmlElement& texture, const files::XmlElement& profile, const DaeIds& ids) {
  std::string name = texture.attribute("texture").value_or("");
  if (const std::string surface = parameter(profile, name, {"sampler2D", "source"}); !surface.empty()) name = surface;
  if (const std::string image = parameter(profile, name, {"surface", "init_from"}); !image.empty()) name = image;
  const auto image = ids.find(name);
  if (!image) return name;  // a name that has no file is a warning when the file is looked for
  const auto file = at(*image, {"init_from"});
  return file ? file->text() : name;
}

/// [1] Opacity. Old exporters write 0 where they mean 1.
double opacity_of(const files::XmlElement& shading) {
  const auto transparent = at(shading, {"transparent"}), number = at(shading, {"transparency", "float"});
  if (!transparent && !number) return 1;
  const auto factor = number ? files::parse_numbers(number->text()) : std::vector{1.0};
  const auto element = transparent ? at(*transparent, {"color"}) : std::nullopt;
  if (transparent && !element) return 1;  // a picture
  const auto color = element ? files::parse_numbers(element->text()) : std::vector{0.0, 0.0, 0.0, 1.0};
  if (!factor || factor->size() != 1 || !color || color->size() != 4) return 1;
  const std::string kind = transparent ? transparent->attribute("opaque").value_or("A_ONE") : "A_ONE";
  const bool by_color = kind.starts_with("RGB");
  const double luminance = 0.212671 * (*color)[0] + 0.715160 * (*color)[1] + 0.072169 * (*color)[2];
  const double part = (by_color ? luminance : (*color)[3]) * (*factor)[0];
  const double opacity = std::clamp(kind.ends_with("ZERO") ? 1 - part : part, 0.0, 1.0);
  return opacity > 0 ? opacity : 1;
}

void read_diffuse(const files::XmlElement& effect, const DaeIds& ids, MeshMaterial& material) {
  const auto profile = at(effect, {"profile_COMMON"});
  const auto technique = at(effect, {"profile_COMMON", "technique"});
  if (!profile || !technique) return;
  for (const char* shading : {"phong", "lambert", "blinn"}) {
    const auto diffuse = at(*technique, {shading, "diffuse"});
    if (!diffuse) continue;
    if (const auto texture = at(*diffuse, {"texture"})) material.picture = picture_of(*texture, *profile, ids);
    const double opacity = opacity_of(*at(*technique, {shading}));
    if (!material.picture.empty() && opacity < 1) material.color = Color{1, 1, 1, opacity};
    const auto color = at(*diffuse, {"color"});
    const auto numbers = color ? files::parse_numbers(color->text()) : std::nullopt;
    if (!numbers || numbers->size() < 3) continue;
    const auto share = [&](std::size_t i) { return std::clamp((*numbers)[i], 0.0, 1.0); };
    material.color = Color{share(0), share(1), share(2), opacity};
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
      if (const auto effect = at(target, {"instance_effect"})) read_diffuse(ids.find(*effect, "url"), ids, material);
    } catch (const SetupError&) {
      // a mesh is its surface: a material that is not in the file takes nothing from that
      material.color.reset();
    }
    materials.emplace(instance.attribute("symbol").value_or(""), material);
  }
  return materials;
}

}  // namespace murosimf::robot_formats::mesh
