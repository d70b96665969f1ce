/// stroke_pieces.h - the straight pieces of strokes that are painted on the ground, and how they meet.
#pragma once

#include <vector>

#include "murosimf/model/shape.h"

namespace murosimf::render {

/// One straight piece.
struct StrokePiece {
  /// An end, where another piece may begin.
  struct End {
    double x = 0, y = 0;  ///< [m] world
    double beyond = 0;    ///< [m] by which the piece is longer here, so that the outer corner of a bend is filled
    bool soft = false;    ///< the next one continues in about the same direction: no edge between them
  };
  End begin, end;
  double half_width = 0;  ///< [m]
};

/// All pieces; those without length are left out.
[[nodiscard]] std::vector<StrokePiece> stroke_pieces(const Markings& markings);

}  // namespace murosimf::render
