/// roboviz_drawings.h - packets of programs that draw by the protocol of RoboViz, as groups of shapes (world/drawing.h).
///
/// A packet has one command after another:
///
///     0 0 SET0                            show what was drawn for all sets with names that begin so, and begin anew
///     1 0 x y r thickness RGB SET0        circle on the ground
///     1 1 x y z x y z thickness RGB SET0  line
///     1 2 x y z size RGB SET0             point
///     1 3 x y z r RGB SET0                sphere
///     1 4 n RGBA (x y z) n times SET0     polygon
///     2 0 x y z RGB TEXT0 SET0            text
///     2 1 AGENT RGB TEXT0, 2 2 AGENT      text at a robot, and its removal
///     3 AGENT                             select a robot: ignored
///
/// where numbers are 6 ASCII characters, colors bytes, texts end with a zero, and AGENT is the robot's number in its team less 1, plus 128
/// in the team on the right. Source: RoboViz' page of its drawing protocol, and what agents of the league send.
/// Differs: sizes of lines and points are pixels there; here a pixel is 4 mm.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/drawing/debug_draw_source.h"
#include "murosimf/world/drawing.h"

namespace murosimf::drawing {

class RobovizDrawings {
 public:
  static constexpr std::size_t most_sets = 200, most_shapes = 2000, most_points = 10'000;  // of a set between two swaps
  static constexpr std::size_t most_in_all = 50'000;                                       // points, waiting and shown

  /// Processes a packet. False: it exceeds a limit, or is invalid from some byte on, and the rest is ignored.
  bool take(std::string_view packet);
  /// The present drawings.
  [[nodiscard]] ExternalDrawings shown() const;
  [[nodiscard]] std::uint64_t changes() const { return changes_; }

 private:
  class Reader;
  void read_command(Reader& in);
  void read_shape(Reader& in);
  void read_text(Reader& in);
  void add(const std::string& set, DrawnShape shape);
  [[nodiscard]] bool has_place(const std::string& set, const DrawnShape& shape) const;
  void swap(const std::string& begin);

  struct Set {
    std::vector<DrawnShape> drawn, shown;
    std::size_t points = 0, shown_points = 0;  // of waiting and of shown shapes
  };
  std::map<std::string, Set> sets_;
  std::map<int, ExternalDrawings::Note> notes_;  // by agent
  std::size_t points_ = 0;                       // of all sets
  bool all_had_place_ = true;
  std::uint64_t changes_ = 0;
};

}  // namespace murosimf::drawing
