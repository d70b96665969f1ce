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

std::array<double, 2> read_repeat(const MjcfAttributes& attributes) {
  const auto repeat = attributes.numbers("texrepeat", 2, 2);
  return repeat.empty() ? std::array{1.0, 1.0} : std::array{repeat[0], repeat[1]};
}

}  // namespace

MjcfMaterials::MjcfMaterials(const std::filesystem::path& file, const files::XmlElement& root,
                             const MjcfDefaults& defaults, const MjcfCompiler& compiler) {
  const MjcfTextures textures(file, root, compiler);
  for (const files::XmlElement& asset : root.children("asset")) {
    for (const files::XmlElement& element : asset.children("material")) {
      const auto name = element.attribute("name");
      if (!name || name->empty()) element.fail("material without a name; add name=\"...\"");
      const MjcfAttributes attributes = defaults.resolve(element);
      Color color = read_color(attributes, {1, 1, 1, 1});
      Picture picture{{}, read_repeat(attributes)};
      // A grid of two colors looks like their mean from afar.
      if (attributes.has("texture")) {
        const std::string texture = attributes.text("texture");
        picture.file = textures.picture(texture, attributes.source("texture"));
        const auto mean = textures.mean_color(texture, attributes.source("texture"));
        if (mean) color = {color.red * mean->x, color.green * mean->y, color.blue * mean->z, color.alpha};
      }
      if (!materials_.emplace(*name, Material{color, picture}).second) {
        element.fail(fmt::format("material '{}' is already there; choose another name", *name));
      }
    }
  }
}

Color MjcfMaterials::color_of(const MjcfAttributes& geom, const std::string& of_mesh) const {
  const Color own = read_color(geom, {});
  const Material* material = find(geom, of_mesh);
  // The format's gray stands for "no color of its own", as in MuJoCo.
  return material && own == Color{} ? material->color : own;
}

MjcfMaterials::Picture MjcfMaterials::picture_of(const MjcfAttributes& geom, const std::string& of_mesh) const {
  const Material* material = find(geom, of_mesh);
  return material ? material->picture : Picture{};
}

/// Null: the geom has none.
const MjcfMaterials::Material* MjcfMaterials::find(const MjcfAttributes& geom, const std::string& of_mesh) const {
  const std::string name = geom.text("material", of_mesh);
  if (name.empty()) return nullptr;
  const auto found = materials_.find(name);
  if (found != materials_.end()) return &found->second;
  std::vector<std::string_view> known;
  for (const auto& [other, material] : materials_) known.push_back(other);
  geom.source("material").fail(unknown_name("material", name, known));
}

}  // namespace murosimf::robot_formats::mjcf
