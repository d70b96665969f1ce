/// sketch_pad.h - drawings of control software for observers (world/drawing.h), within limits.
#pragma once

#include <string>
#include <string_view>

#include "murosimf/world/drawing.h"

namespace murosimf {
class Setup;
}

namespace murosimf::drawing {

class SketchPad {
 public:
  explicit SketchPad(Setup& setup);

  static constexpr std::size_t most_groups = 100, most_shapes = 1000,
                               most_points = 10'000;  // of a robot; of a group each
  static constexpr std::size_t longest_text = 1000;

  /// Replaces the group of that name; without shapes it is removed. False, with the reason in refusal(): too much, a shape
  /// without points, numbers that are not finite. Then the last group remains.
  bool draw(DrawnGroup group);
  /// Removes all drawings.
  void clear();
  [[nodiscard]] const std::string& refusal() const { return refusal_; }

 private:
  [[nodiscard]] std::string why_not(const DrawnGroup& group) const;

  Drawings* drawings_;
  std::string refusal_;
};

}  // namespace murosimf::drawing
