/// entity_looks.h - what entities look like to the renderer: meshes for the eye, shapes, numbers on shirts.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "murosimf/render/scenery.h"

namespace murosimf::io {

/// Reads meshes once per model: equal robots share them. Meshes of a robot have at most `usual_triangles` together
/// (visual_meshes.h).
class LooksLibrary {
 public:
  /// Robots whose names end in a number wear it on chest and back.
  [[nodiscard]] render::EntityLooks looks(const Entity& entity);
  /// One line for each mesh that could not be read and is left out.
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  std::map<const Model*, render::EntityLooks> models_;
  std::vector<std::string> warnings_;
};

}  // namespace murosimf::io
