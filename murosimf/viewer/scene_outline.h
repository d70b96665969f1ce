/// scene_outline.h - what a shown scene is made of, and what people call its parts: does not change while it runs.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/math/assert.h"
#include "murosimf/viewer/inspection.h"

namespace murosimf::viewer {

class SceneOutline {
 public:
  SceneOutline() = default;
  /// In the thread that runs the scene, between two steps.
  explicit SceneOutline(const scene::Scene& scene);

  /// Entities by their numbers, in the order of the world.
  [[nodiscard]] const std::vector<EntityOutline>& entities() const noexcept { return entities_; }
  [[nodiscard]] std::size_t size() const noexcept { return entities_.size(); }
  [[nodiscard]] auto begin() const noexcept { return entities_.begin(); }
  [[nodiscard]] auto end() const noexcept { return entities_.end(); }
  [[nodiscard]] const EntityOutline& operator[](std::size_t entity) const noexcept {
    MUROSIMF_ASSERT(entity < entities_.size());
    return entities_[entity];
  }
  /// The same for a number that may say that there is none, -1, which must have been asked before.
  [[nodiscard]] const EntityOutline& of(int entity) const noexcept { return (*this)[static_cast<std::size_t>(entity)]; }

  /// Numbers of entities; -1: there is none.
  [[nodiscard]] int ball() const noexcept { return ball_; }
  [[nodiscard]] int robot(int number) const noexcept;
  [[nodiscard]] int entity_named(std::string_view name) const noexcept;
  /// "blue1.head"
  [[nodiscard]] std::string path_text(const ObjectPath& path) const;
  /// Reads "blue1" and "blue1.head". Throws SetupError with the nearest name.
  [[nodiscard]] ObjectPath path_of(const std::string& text) const;

  // [m] of the field and of its goals; these are 0 wide where there are none.
  [[nodiscard]] double half_length() const noexcept { return half_length_; }
  [[nodiscard]] double half_width() const noexcept { return half_width_; }
  [[nodiscard]] double goal_half_width() const noexcept { return goal_half_width_; }

 private:
  std::vector<EntityOutline> entities_;
  int ball_ = -1;
  double half_length_ = 3, half_width_ = 2, goal_half_width_ = 0.8;
};

}  // namespace murosimf::viewer
