/// timeline_layout.h - layout of branches and marks of a run on a strip of the window, and lookup of a place of it.
///
/// Time goes to the right. The displayed branch and its ancestors are the lowest row; every other branch has a row above, from where
/// it departs from its parent on.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "murosimf/session/timeline.h"

namespace murosimf::viewer {

/// An event that one can jump to.
struct TimeMark {
  double time = 0;  ///< [s]
  int branch = 0;
  enum class Kind { event, fall, goal, warning, touch } kind = Kind::event;
  std::string text;
};

struct BranchBar {
  int branch = 0, row = 0;    ///< row 0: the present one
  double begin = 0, end = 0;  ///< [s]
};

class TimelineLayout {
 public:
  /// `width` [px] for the times 0 to `end` [s] at least; all branches fit. The present branch has reached `end`, if that is
  /// later than known for it.
  TimelineLayout(std::span<const session::BranchView> branches, int present, double end, double width);

  [[nodiscard]] double x_of(double time) const { return time / end_ * width_; }
  /// [s] at a place [px], limited to the branch of that row; for other rows, the nearest existing one.
  struct Place {
    double time = 0;
    int branch = 0;
  };
  [[nodiscard]] Place place_at(double x, int row) const;
  [[nodiscard]] const std::vector<BranchBar>& bars() const { return bars_; }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] double end() const { return end_; }
  /// The row in which a branch is seen at a time; 0 if it is no longer known.
  [[nodiscard]] int row_at(int branch, double time) const;

 private:
  double end_, width_;
  int rows_ = 1;
  std::vector<BranchBar> bars_;
};

}  // namespace murosimf::viewer
