/// entity_appearance.h - appearance of entities for the renderer: visual meshes, shapes, numbers on shirts.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "murosimf/appearance/jersey_numbers.h"
#include "murosimf/appearance/visual_meshes.h"
#include "murosimf/render/render_scene.h"

namespace murosimf::appearance {

/// 3 of "blue3"; -1 if the name does not end in a number of at most three digits.
[[nodiscard]] int jersey_number(const std::string& name);

/// Reads meshes once per model, pictures once: equal robots share them. Meshes of a robot have at most `usual_triangles` together
/// (visual_meshes.h).
class AppearanceLibrary {
 public:
  explicit AppearanceLibrary(PictureUse use = PictureUse::by_pixel) : use_(use) {}
  /// The appearance of an entity. Robots of a team with names that end in a number have it on chest and back.
  [[nodiscard]] render::EntityAppearance appearance(const Entity& entity);
  /// One line for each mesh that could not be read and is left out.
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  struct ModelAppearance {
    render::EntityAppearance drawn;
    std::vector<JerseyNumber> plates;
  };
  PictureUse use_;
  MeshPictures pictures_;
  std::map<const Model*, ModelAppearance> models_;
  std::vector<std::string> warnings_;
};

}  // namespace murosimf::appearance
