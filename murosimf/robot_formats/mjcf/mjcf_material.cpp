#include "murosimf/robot_formats/mjcf/mjcf_material.h"

#include <vector>

#include <fmt/format.h>

#include "murosimf/model/error.h"
#include "murosimf/robot_formats/mjcf/mjcf_texture.h"

namespace murosimf::robot_formats::mjcf {
namespace {

Color read_color(const MjcfAttributes& attributes, const Color& otherwise) {
  const auto rgba = attributes.numbers("rgba", 4, 4);
  for (const double part : rgba) {
    if (part < 0 || part > 1) {
      attributes.source("rgba").fail(fmt::format("rgba '{}' of {}: each number must be from 0 to 1",
                                                 attributes.text("rgba"), attributes.element().tag()));
    }
  }
  return rgba.empty() ? otherwise : Color{rgba[0], rgba[1], rgba[2], rgba[3]};
}

}  // namespace

MjcfMaterials::MjcfMaterials(const files::XmlElement& root, const MjcfDefaults& defaults) {
  const MjcfTextures textures(root);
  for (const files::XmlElement& asset : root.children("asset")) {
    for (const files::XmlElement& element : asset.children("material")) {
      const auto name = element.attribute("name");
      if (!name || name->empty()) element.fail("material without a name; add name=\"...\"");
      const MjcfAttributes attributes = defaults.resolve(element);
      Color color = read_color(attributes, {1, 1, 1, 1});
      // A picture on a texture is not drawn, but a grid of two colors looks like their mean from afar.
      if (attributes.has("texture")) {
        const auto mean = textures.mean_color(attributes.text("texture"), attributes.source("texture"));
        if (mean) color = {color.red * mean->x, color.green * mean->y, color.blue * mean->z, color.alpha};
      }
      if (!colors_.emplace(*name, color).second) {
        element.fail(fmt::format("material '{}' is already there; choose another name", *name));
      }
    }
  }
}

Color MjcfMaterials::color_of(const MjcfAttributes& geom, const std::string& of_mesh) const {
  const Color own = read_color(geom, {});
  const std::string material = geom.text("material", of_mesh);
  if (material.empty()) return own;
  const auto found = colors_.find(material);
  if (found == colors_.end()) {
    std::vector<std::string_view> known;
    for (const auto& [name, color] : colors_) known.push_back(name);
    geom.source("material").fail(unknown_name("material", material, known));
  }
  // The format's gray stands for "no color of its own", as in MuJoCo.
  return own == Color{} ? found->second : own;
}

}  // namespace murosimf::robot_formats::mjcf
