// The statements that tests make: they must fail when they should. (Here, for the rows of this folder are in no table.)
#include "tests/law.h"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

namespace murosimf::law {
namespace {

const double nan = std::numeric_limits<double>::quiet_NaN();
const Statement statement{.law = "fall", .level = "example", .source = "nobody"};

TEST(Law, FailsOutsideOfItsLimits) {
  EXPECT_NONFATAL_FAILURE(expect_below(statement, 2, 2, "m"), "fall (example): 2 m, demanded is < 2 m");
  EXPECT_NONFATAL_FAILURE(expect_above(statement, 2, 2, "m"), "demanded is > 2 m");
  EXPECT_NONFATAL_FAILURE(expect_between(statement, 3.1, 2, 3, "m"), "demanded is 2 to 3 m");
  EXPECT_NONFATAL_FAILURE(expect_between(statement, 1.9, 2, 3, "m"), "demanded is 2 to 3 m");
  EXPECT_NONFATAL_FAILURE(expect_near(statement, 2.75, 3, 0.2, "m"), "2.75 m, demanded is 3 +- 0.2 m");
  EXPECT_NONFATAL_FAILURE(expect_near(statement, 3.25, 3, 0.2, "m"), "3.25 m, demanded is 3 +- 0.2 m");
  EXPECT_NONFATAL_FAILURE(expect_equal(statement, std::nextafter(3, 4), 3, "m"), "demanded is = 3 m");
}

TEST(Law, NamesTheLineOfTheStatement) {
  testing::TestPartResultArray results;
  {
    const testing::ScopedFakeTestPartResultReporter reporter(&results);
    expect_below(statement, 2, 1, "m");
  }
  ASSERT_EQ(results.size(), 1);
  EXPECT_EQ(results.GetTestPartResult(0).line_number(), __LINE__ - 3);
  EXPECT_NE(std::string(results.GetTestPartResult(0).file_name()).find("law_test.cpp"), std::string::npos);
}

TEST(Law, HoldsWithinItsLimits) {
  expect_below(statement, 1.9, 2, "m");
  expect_above(statement, 2.1, 2, "m");
  expect_between(statement, 2, 2, 3, "m");
  expect_between(statement, 3, 2, 3, "m");
  expect_near(statement, 3.25, 3, 0.25, "m");
  expect_equal(statement, 3, 3, "m");
}

TEST(Law, NoNumberIsWithinNoLimits) {
  EXPECT_NONFATAL_FAILURE(expect_below(statement, nan, 2, "m"), "nan");
  EXPECT_NONFATAL_FAILURE(expect_above(statement, nan, 2, "m"), "nan");
  EXPECT_NONFATAL_FAILURE(expect_between(statement, nan, 2, 3, "m"), "nan");
  EXPECT_NONFATAL_FAILURE(expect_near(statement, nan, 2, 3, "m"), "nan");
  EXPECT_NONFATAL_FAILURE(expect_equal(statement, nan, nan, "m"), "nan");
}

TEST(Law, WorstKeepsTheLargestAndItsPlace) {
  Worst worst;
  worst.see(-2, "step", 1);
  worst.see(5, "step", 2);
  worst.see(3, "step", 3);
  EXPECT_EQ(Measured(worst).value, 5);
  EXPECT_NONFATAL_FAILURE(expect_below(statement, worst, 4, "m"), "worst at: step 2");
}

TEST(Law, WorstOfNothingOrNoNumberFails) {
  Worst nothing;
  EXPECT_NONFATAL_FAILURE(expect_below(statement, nothing, 4, "m"), "nan");
  Worst bad;
  for (const double x : {1.0, nan, 2.0}) bad.see(x, x);
  EXPECT_NONFATAL_FAILURE(expect_below(statement, bad, 4, "m"), "worst at: nan");
}

TEST(Law, EveryStatementIsRecorded) {
  expect_near(statement, 3.25, 3, 0.5, "m");
  expect_below(statement, 1, 2, "");
  const testing::TestResult& result = *testing::UnitTest::GetInstance()->current_test_info()->result();
  ASSERT_EQ(result.test_property_count(), 2);
  EXPECT_STREQ(result.GetTestProperty(0).key(), "law_0");
  EXPECT_STREQ(result.GetTestProperty(0).value(), "fall\texample\tnobody\t3 +- 0.5\tm\t-0.5\t0.5\t0.25");
  EXPECT_STREQ(result.GetTestProperty(1).value(), "fall\texample\tnobody\t< 2\t\t-inf\t2\t1");
}

}  // namespace
}  // namespace murosimf::law
