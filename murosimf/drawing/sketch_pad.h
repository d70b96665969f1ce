/// sketch_pad.h - where control software draws for people who watch (model/drawing.h): so much, and no more.
#pragma once

#include <string>
#include <string_view>

#include "murosimf/model/drawing.h"

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

  /// In the place of the group of that name; without shapes that group is gone. False, and refusal() says why: too much, a shape
  /// without points, numbers that are not finite. Then the old one stays.
  bool draw(DrawnGroup group);
  /// Nothing is drawn.
  void clear();
  [[nodiscard]] const std::string& refusal() const { return refusal_; }

 private:
  [[nodiscard]] std::string why_not(const DrawnGroup& group) const;

  Drawings* drawings_;
  std::string refusal_;
};

}  // namespace murosimf::drawing
