#include "murosimf/robot_formats/mjcf/mjcf_texture.h"

#include <filesystem>
#include <set>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "murosimf/files/file_spelling.h"
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

/// A missing file is a warning when it is drawn.
std::filesystem::path picture_of(const MjcfAttributes& texture, const std::filesystem::path& folder, bool strip_path) {
  const std::filesystem::path name = texture.text("file");
  const auto type = texture.choice("type", {"cube", "2d", "skybox"});
  if (name.empty() || type != "2d" || texture.text("builtin", "none") != "none") return {};
  const std::filesystem::path wanted = strip_path ? name.filename() : name;
  return files::find_spelled(folder, wanted.string()).value_or(folder / wanted);
}

}  // namespace

MjcfTextures::MjcfTextures(const std::filesystem::path& file, const files::XmlElement& root,
                           const MjcfCompiler& compiler) {
  const auto folder = file.parent_path() / compiler.picture_folder;
  for (const files::XmlElement& asset : root.children("asset")) {
    for (const files::XmlElement& element : asset.children("texture")) {
      MjcfAttributes texture(element);
      texture.overlay(element);
      const std::string stem = std::filesystem::path(texture.text("file")).stem().string();
      textures_.emplace(texture.text("name", stem),
                        Texture{read_mean(texture), picture_of(texture, folder, compiler.strip_path)});
    }
  }
}

std::optional<Vec3d> MjcfTextures::mean_color(const std::string& name, const files::XmlElement& user) const {
  return find(name, user).mean;
}

std::filesystem::path MjcfTextures::picture(const std::string& name, const files::XmlElement& user) const {
  return find(name, user).picture;
}

void name_undrawn_textures(const files::XmlElement& root, std::vector<robot_formats::Unused>& unused) {
  std::set<std::string> named;
  for (const files::XmlElement& asset : root.children("asset")) {
    for (const files::XmlElement& texture : asset.children("texture")) {
      const std::string type = files::one_line(texture.attribute("type").value_or("cube"));
      if (type == "2d" || !texture.attribute("file") || !named.insert(type).second) continue;
      const std::string what = fmt::format("texture of type '{}'", type);
      unused.push_back({what, fmt::format("{}: {} ignored: only meshes are drawn with textures, of type '2d'",
                                          texture.where(), what)});
    }
  }
}

const MjcfTextures::Texture& MjcfTextures::find(const std::string& name, const files::XmlElement& user) const {
  const auto found = textures_.find(name);
  if (found != textures_.end()) return found->second;
  std::vector<std::string_view> known;
  for (const auto& [other, texture] : textures_) known.push_back(other);
  user.fail(unknown_name("texture", name, known));
}

}  // namespace murosimf::robot_formats::mjcf
