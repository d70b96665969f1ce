// `murosimf new-name` as a user meets it.
#include "tests/apps/program.h"

namespace murosimf::test {
namespace {

TEST(NewName, IsACommandOfTheProgram) {
  const Result help = murosimf("--help");
  EXPECT_NE(help.output.find("  new-name "), std::string::npos) << help.output;
}

TEST(NewName, NamesWhatMoves) {
  const Result result = murosimf("new-name walk");
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(result.output.substr(0, 7), "walker ");
  EXPECT_NE(result.output.find(" 21 joints\n"), std::string::npos) << result.output;
}

TEST(NewName, RefusesAnUnknownScene) { expect_mistake("new-name nowhere", {"nowhere"}); }

}  // namespace
}  // namespace murosimf::test
