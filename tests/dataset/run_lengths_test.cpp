#include "murosimf/dataset/run_lengths.h"

#include <gtest/gtest.h>

namespace murosimf::dataset {
namespace {

using Counts = std::vector<std::uint64_t>;

TEST(RunLengths, BeginWithZerosAndJoinNeighbors) {
  RunLengths runs;
  runs.add(3, 2);
  runs.add(5, 1);
  runs.add(9, 1);
  EXPECT_EQ(runs.finish(12), (Counts{3, 3, 3, 1, 2}));
  EXPECT_EQ(runs.finish(10), (Counts{3, 3, 3, 1}));
}

TEST(RunLengths, AMaskFromTheFirstPixelOnBeginsWithNoZeros) {
  RunLengths runs;
  runs.add(0, 4);
  EXPECT_EQ(runs.finish(4), (Counts{0, 4}));
  EXPECT_EQ(RunLengths{}.finish(6), (Counts{6}));
}

// By hand: 3 is one group; 40 = 8 + 32 * 1 are two, the first with the bit 32; the fourth is -39 = ...11001 in two's complement.
TEST(RunLengths, TextIsThatOfCoco) {
  EXPECT_EQ(run_length_text({3}), "3");
  EXPECT_EQ(run_length_text({40}), "X1");
  EXPECT_EQ(run_length_text({1, 40, 2, 1}), "1X12iN");
}

}  // namespace
}  // namespace murosimf::dataset
