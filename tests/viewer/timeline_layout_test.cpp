#include <algorithm>

#include "murosimf/viewer/timeline_layout.h"

#include <gtest/gtest.h>

namespace murosimf::viewer {
namespace {

using namespace std::chrono_literals;

/// 0: from 0 to 10 s; 1 left it at 4 s and came to 7 s; 2 left 1 at 6 s and came to 8 s.
std::vector<session::BranchView> branches() {
  return {{.number = 0, .begin = 0s, .end = 10s},
          {.number = 1, .parent = 0, .begin = 4s, .end = 7s},
          {.number = 2, .parent = 1, .begin = 6s, .end = 8s}};
}

TEST(TimelineLayout, ThePresentWayIsTheLowestRow) {
  const auto all = branches();
  const TimelineLayout layout(all, 2, 8, 1000);
  EXPECT_EQ(layout.end(), 10);
  EXPECT_EQ(layout.x_of(5), 500);
  EXPECT_EQ(layout.row_at(0, 3), 0);
  EXPECT_EQ(layout.row_at(1, 5), 0);
  EXPECT_EQ(layout.row_at(2, 7), 0);
  EXPECT_NE(layout.row_at(0, 9), 0);
  EXPECT_NE(layout.row_at(1, 6.5), layout.row_at(0, 6.5));
  EXPECT_EQ(layout.rows(), 3) << "what went on of 0 and of 1 has rows of its own";
  double end = 0;
  for (const BranchBar& bar : layout.bars()) {
    if (bar.row == 0) end = std::max(end, bar.end);
  }
  EXPECT_EQ(end, 8);
}

TEST(TimelineLayout, FindsTimesAndBranches) {
  const auto all = branches();
  const TimelineLayout layout(all, 2, 8, 1000);
  EXPECT_EQ(layout.place_at(200, 0).branch, 0);
  EXPECT_DOUBLE_EQ(layout.place_at(200, 0).time, 2);
  EXPECT_EQ(layout.place_at(500, 0).branch, 1);
  EXPECT_EQ(layout.place_at(700, 0).branch, 2);
  EXPECT_DOUBLE_EQ(layout.place_at(990, 0).time, 8) << "nothing is there yet: the end";
  bool found = false;
  for (int row = 1; row < layout.rows(); ++row) found = found || layout.place_at(990, row).branch == 0;
  EXPECT_TRUE(found) << "the rest of the first branch";
}

TEST(TimelineLayout, OneBranch) {
  const std::vector<session::BranchView> all{{.number = 0, .begin = 0s, .end = 0s}};
  const TimelineLayout layout(all, 0, 0, 500);
  EXPECT_EQ(layout.rows(), 1);
  EXPECT_EQ(layout.place_at(300, 5).time, 0);
}

}  // namespace
}  // namespace murosimf::viewer
