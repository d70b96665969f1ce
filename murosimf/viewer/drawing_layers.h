/// drawing_layers.h - what control software and other programs draw for people who watch, and which groups of it are shown.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "murosimf/drawing/debug_draw_source.h"
#include "murosimf/drawing/drawn.h"
#include "murosimf/render/seen_drawing.h"
#include "murosimf/viewer/scene_outline.h"
#include "murosimf/viewer/shown_poses.h"

namespace murosimf::viewer {

class DrawingLayers {
 public:
  /// `others`: of programs that are no software of a robot; outlives it; null: there is none.
  explicit DrawingLayers(const drawing::DebugDrawSource* others) : others_(others) {}

  std::set<std::string> hidden;  ///< of groups()

  /// What software of robots draws, if an inspection has it.
  void take(Inspection& seen);
  void forget();
  /// InspectionRequest::drawings_known
  [[nodiscard]] std::uint64_t known() const noexcept { return known_; }

  /// "blue1/ball": the author, and the name of a group; also hidden ones that are not there.
  [[nodiscard]] std::vector<std::string> groups(const SceneOutline& outline) const;
  /// All that is not hidden, as it is seen in a picture.
  [[nodiscard]] std::vector<render::SeenShape> shapes_in(const sensors::Perspective& view, const ShownPoses& poses,
                                                         const SceneOutline& outline) const;

 private:
  [[nodiscard]] std::vector<drawing::Drawn> all(const SceneOutline& outline) const;

  const drawing::DebugDrawSource* others_;
  std::vector<drawing::Drawn> drawn_;  // by robots
  std::uint64_t known_ = 0;
};

}  // namespace murosimf::viewer
