/// entity_looks.h - what entities look like to the renderer: meshes for the eye, shapes, numbers on shirts.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "murosimf/appearance/number_plates.h"
#include "murosimf/render/scenery.h"

namespace murosimf::appearance {

/// 3 of "blue3"; -1 if the name ends in no number, or in one of more than three digits.
[[nodiscard]] int shirt_number(const std::string& name);

/// Reads meshes once per model: equal robots share them. Meshes of a robot have at most `usual_triangles` together
/// (visual_meshes.h).
class LooksLibrary {
 public:
  /// Robots of a team whose names end in a number wear it on chest and back.
  [[nodiscard]] render::EntityLooks looks(const Entity& entity);
  /// One line for each mesh that could not be read and is left out.
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  struct ModelLooks {
    render::EntityLooks drawn;
    std::vector<NumberPlate> plates;
  };
  std::map<const Model*, ModelLooks> models_;
  std::vector<std::string> warnings_;
};

}  // namespace murosimf::appearance
