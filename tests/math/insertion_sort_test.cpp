#include "murosimf/math/insertion_sort.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/fixtures.h"

namespace murosimf {
namespace {

// The oracle is the standard library's stable sort; every length from none on, with many ties.
TEST(InsertionSort, IsAStableSort) {
  fixtures::Dice dice("insertion sort");
  const auto less = [](const auto& a, const auto& b) { return a.first < b.first; };
  for (int count = 0; count <= 12; ++count) {
    for (int round = 0; round < 50; ++round) {
      std::vector<std::pair<int, int>> found;
      for (int i = 0; i < count; ++i) found.emplace_back(dice.pick(5), i);
      auto expected = found;
      std::stable_sort(expected.begin(), expected.end(), less);
      insertion_sort(found.begin(), found.end(), less);
      EXPECT_EQ(found, expected) << count << " things";
    }
  }
}

TEST(InsertionSort, LeavesWhatIsBehindTheEnd) {
  std::array<int, 4> numbers{3, 2, 1, 0};
  insertion_sort(numbers.begin(), numbers.begin() + 2);
  EXPECT_EQ(numbers, (std::array<int, 4>{2, 3, 1, 0}));
}

}  // namespace
}  // namespace murosimf
