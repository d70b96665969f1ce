#include "murosimf/viewer/timeline_layout.h"

#include <algorithm>
#include <set>

#include "murosimf/math/assert.h"

namespace murosimf::viewer {
namespace {

constexpr double least_end = 1;  // [s]

}  // namespace

TimelineLayout::TimelineLayout(std::span<const session::BranchView> branches, int present, double end, double width)
    : end_(std::max(least_end, end)), width_(width) {
  std::set<int> leading;  // to the present one
  const auto find = [&](int number) { return std::ranges::find(branches, number, &session::BranchView::number); };
  for (auto branch = find(present); branch != branches.end();) {
    leading.insert(branch->number);
    branch = branch->parent ? find(*branch->parent) : branches.end();
  }
  // branches beside the present one and its ancestors have rows of their own: the newest nearest
  std::vector<const session::BranchView*> others;
  for (const session::BranchView& branch : branches) {
    end_ = std::max(end_, seconds(branch.end));
    others.push_back(&branch);
  }
  std::ranges::reverse(others);
  const auto end_of = [&](const session::BranchView& branch) {
    return branch.number == present ? std::max(end, seconds(branch.end)) : seconds(branch.end);
  };
  for (const session::BranchView* branch : others) {
    const bool leads = leading.contains(branch->number);
    if (leads) {  // up to where the next one departs from it
      double until = end_of(*branch);
      for (const session::BranchView& next : branches) {
        if (leading.contains(next.number) && next.parent == branch->number) until = seconds(next.begin);
      }
      bars_.push_back({branch->number, 0, seconds(branch->begin), until});
      if (until >= end_of(*branch)) continue;
      bars_.push_back({branch->number, rows_++, until, seconds(branch->end)});
      continue;
    }
    bars_.push_back({branch->number, rows_++, seconds(branch->begin), seconds(branch->end)});
  }
}

int TimelineLayout::row_at(int branch, double time) const {
  for (const BranchBar& bar : bars_) {
    if (bar.branch == branch && time >= bar.begin && time <= bar.end) return bar.row;
  }
  return 0;
}

/// The bar that is nearest: branches are short, and hard to hit.
TimelineLayout::Place TimelineLayout::place_at(double x, int row) const {
  const double time = std::clamp(x / width_, 0.0, 1.0) * end_;
  MUROSIMF_ASSERT(rows_ >= 1);
  const int wanted = std::clamp(row, 0, rows_ - 1);
  const BranchBar* best = nullptr;
  const auto away = [&](const BranchBar& bar) { return std::max({0.0, bar.begin - time, time - bar.end}); };
  for (const BranchBar& bar : bars_) {
    if (bar.row == wanted && (!best || away(bar) < away(*best))) best = &bar;
  }
  return best ? Place{std::clamp(time, best->begin, best->end), best->branch} : Place{time, 0};
}

}  // namespace murosimf::viewer
