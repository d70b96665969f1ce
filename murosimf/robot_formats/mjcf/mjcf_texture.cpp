#include "murosimf/robot_formats/mjcf/mjcf_texture.h"

#include <filesystem>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "murosimf/model/error.h"
#include "murosimf/robot_formats/mjcf/mjcf_defaults.h"

namespace murosimf::robot_formats::mjcf {
namespace {

Vec3d read_color(const MjcfAttributes& texture, const char* name, const Vec3d& otherwise) {
  const Vec3d color = texture.vector(name, otherwise);
  for (const double part : {color.x, color.y, color.z}) {
    if (part >= 0 && part <= 1) continue;
    texture.source(name).fail(
        fmt::format("{} '{}' of texture: each number must be from 0 to 1", name, texture.text(name)));
  }
  return color;
}

std::optional<Vec3d> read_mean(const MjcfAttributes& texture) {
  const auto kind = texture.choice("builtin", {"none", "flat", "checker", "gradient"});
  const Vec3d first = read_color(texture, "rgb1", {0.8, 0.8, 0.8}),
              second = read_color(texture, "rgb2", {0.5, 0.5, 0.5});
  if (kind == "none") return std::nullopt;
  // In equal parts: squares of a checker, and the mean of a gradient.
  return kind == "flat" ? first : 0.5 * (first + second);
}

}  // namespace

MjcfTextures::MjcfTextures(const files::XmlElement& root) {
  for (const files::XmlElement& asset : root.children("asset")) {
    for (const files::XmlElement& element : asset.children("texture")) {
      MjcfAttributes texture(element);
      texture.overlay(element);
      const std::string stem = std::filesystem::path(texture.text("file")).stem().string();
      colors_.emplace(texture.text("name", stem), read_mean(texture));
    }
  }
}

std::optional<Vec3d> MjcfTextures::mean_color(const std::string& name, const files::XmlElement& user) const {
  const auto found = colors_.find(name);
  if (found != colors_.end()) return found->second;
  std::vector<std::string_view> known;
  for (const auto& [other, color] : colors_) known.push_back(other);
  user.fail(unknown_name("texture", name, known));
}

}  // namespace murosimf::robot_formats::mjcf
