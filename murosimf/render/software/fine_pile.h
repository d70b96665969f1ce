/// fine_pile.h - the pile of look.h as short fibers, for pictures for people: a texture in all sizes (Williams, "Pyramidal parametrics",
/// SIGGRAPH 1983), each of them the mean of four heights of the one before.
#pragma once

#include <vector>

#include "murosimf/render/look.h"
#include "murosimf/render/software/patterns.h"

namespace murosimf::render::software {

class FinePile {
 public:
  /// The one of all pictures.
  static const FinePile& get();

  /// Heights, mean 0, at places [m] of the ground; `covered` [m]: the longer side of each pixel's footprint there.
  [[nodiscard]] Floats at(const Floats2& place, const Floats& covered) const;

 private:
  FinePile();
  /// Between the four nearest heights of a level; x and y: [texels of the finest level], not negative.
  [[nodiscard]] float at_level(int level, float x, float y) const;

  std::vector<std::vector<float>> levels_;
};

}  // namespace murosimf::render::software
