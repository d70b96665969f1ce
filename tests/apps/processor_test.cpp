// A program that was built for another processor says so.
#include "apps/processor.h"

#include <array>

#include <gtest/gtest.h>

namespace murosimf::app {
namespace {

TEST(Processor, HasWhatThisProgramWasBuiltFor) { EXPECT_EQ(missing_instructions(instruction_sets()), nullptr); }

TEST(Processor, LacksWhatIsUsedAndNotThere) {
  const std::array sets{InstructionSet{"one", true, true}, InstructionSet{"two", false, false},
                        InstructionSet{"three", true, false}, InstructionSet{"four", true, false}};
  EXPECT_STREQ(missing_instructions(sets), "three");
  EXPECT_EQ(missing_instructions(std::span(sets).first(2)), nullptr);
}

}  // namespace
}  // namespace murosimf::app
