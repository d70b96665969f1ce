// Assertions end the program where they are checked, and are not even evaluated where they are not.
#include "murosimf/math/assert.h"

#include <type_traits>

#include <gtest/gtest.h>

namespace murosimf {
namespace {

constexpr int half(int even) {
  MUROSIMF_ASSERT(even % 2 == 0 && "half of an odd number");
  return even / 2;
}
static_assert(half(6) == 3);

struct Evaluations {
  int count = 0;
  bool counted(bool value) {
    ++count;
    return value;
  }
};

TEST(Assert, EvaluatesOnceOrNotAtAll) {
  Evaluations evaluations;
  MUROSIMF_ASSERT(evaluations.counted(true));
  EXPECT_EQ(evaluations.count, assertions_checked ? 1 : 0);
  const int only_asserted = 4;  // compiles without a warning in every build
  MUROSIMF_ASSERT(only_asserted == 4);
}

TEST(AssertDeathTest, EndsTheProgramWhereItIsChecked) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  Evaluations evaluations;
  if constexpr (assertions_checked) {
    EXPECT_DEATH(MUROSIMF_ASSERT(evaluations.counted(false)),
                 "assert_test.cpp:[0-9]+: .*: assertion 'evaluations.counted\\(false\\)' failed");
  } else {
    MUROSIMF_ASSERT(evaluations.counted(false));
    EXPECT_EQ(evaluations.count, 0);
  }
}

TEST(AssertDeathTest, TakesCommas) {
  MUROSIMF_ASSERT(std::is_same_v<decltype(half(2)), int>);
  EXPECT_DEATH(assertion_failed("a < b", "kernel.cpp", 12, "step"), "kernel.cpp:12: step: assertion 'a < b' failed");
}

}  // namespace
}  // namespace murosimf
