// A number arrives as many steps later as it was told, no more and no less.
#include "murosimf/dynamics/servo/delay_line.h"

#include <gtest/gtest.h>

#include "murosimf/math/hash.h"

namespace murosimf::dynamics {
namespace {

TEST(DelayLine, EveryNumberArrivesItsStepsLater) {
  for (const int steps : {1, 2, 5}) {
    DelayLine line;
    line.reset(static_cast<std::size_t>(steps), -7);
    for (int i = 0; i < 17; ++i) EXPECT_EQ(line.pass(100 + i), i < steps ? -7 : 100 + i - steps) << steps << " " << i;
  }
}

TEST(DelayLine, WithoutStepsItPassesAtOnce) {
  DelayLine line;
  EXPECT_EQ(line.pass(3), 3);
  line.reset(2, 1);
  EXPECT_EQ(line.pass(4), 1);
  line.reset(0, 9);
  EXPECT_EQ(line.pass(5), 5);
}

TEST(DelayLine, ResetForgetsWhatIsOnItsWay) {
  DelayLine line;
  line.reset(3, 0);
  for (const double x : {1.0, 2.0}) EXPECT_EQ(line.pass(x), 0);
  line.reset(2, 8);
  EXPECT_EQ(line.pass(3), 8);
  EXPECT_EQ(line.pass(4), 8);
  EXPECT_EQ(line.pass(5), 3);
}

std::uint64_t hash_of(const DelayLine& line) {
  Hasher hasher;
  append_hash(hasher, line);
  return hasher.value();
}

// Two lines that will say the same from now on are in the same state, wherever their memory begins.
TEST(DelayLine, HashIsThatOfWhatWillArrive) {
  DelayLine turned, straight;
  turned.reset(3, 0);
  for (const double x : {9.0, 1.0, 2.0, 3.0}) (void)turned.pass(x);
  straight.reset(3, 0);
  for (const double x : {1.0, 2.0, 3.0}) (void)straight.pass(x);
  EXPECT_EQ(hash_of(turned), hash_of(straight));
  (void)straight.pass(4);
  EXPECT_NE(hash_of(turned), hash_of(straight));
}

}  // namespace
}  // namespace murosimf::dynamics
