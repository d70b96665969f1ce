/// timeline_layout.h - where branches and marks of a run stand on a strip of the window, and what is at a place of it.
///
/// Time goes to the right. The branch that is shown and what led to it are the lowest row; every other branch has a row above, from where
/// it left its parent on.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "murosimf/session/timeline.h"

namespace murosimf::viewer {

/// Something that happened, to which one may go.
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
  /// `width` [px] for the times 0 to `end` [s] at least; everything that there is fits. The present branch has come to `end`, if that is
  /// later than what is known of it.
  TimelineLayout(std::span<const session::BranchView> branches, int present, double end, double width);

  [[nodiscard]] double x_of(double time) const { return time / end_ * width_; }
  /// [s] at a place [px], within what there is of that row's branch; the nearest row that there is.
  struct Place {
    double time = 0;
    int branch = 0;
  };
  [[nodiscard]] Place place_at(double x, int row) const;
  [[nodiscard]] const std::vector<BranchBar>& bars() const { return bars_; }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] double end() const { return end_; }
  /// The row in which a branch is seen at a time; 0 if it is not known any more.
  [[nodiscard]] int row_at(int branch, double time) const;

 private:
  double end_, width_;
  int rows_ = 1;
  std::vector<BranchBar> bars_;
};

}  // namespace murosimf::viewer
