// Bytes of a state: sections by name, and all that makes bytes no state.
#include <algorithm>

#include "murosimf/runtime/state_sections.h"

#include <gtest/gtest.h>

#include "murosimf/model/error.h"
#include "tests/fixtures.h"

namespace murosimf {
namespace {

using fixtures::error_of;
using fixtures::says;

std::vector<std::byte> content(int number) { return std::vector<std::byte>(3, static_cast<std::byte>(number)); }

std::vector<std::byte> three_sections() {
  StateWriter writer;
  writer.add({"ball"}, content(1));
  writer.add({"robot"}, content(2));
  writer.add({"camera", true}, {});
  writer.add({"robot"}, content(4));
  return writer.finish();
}

TEST(StateSections, OfOneNameComeInTheirOrder) {
  const std::vector<std::byte> bytes = three_sections();
  StateReader reader(bytes);
  const auto is = [&](std::string_view name, const std::vector<std::byte>& expected) {
    const auto found = reader.next(name);
    return found && std::equal(found->begin(), found->end(), expected.begin(), expected.end());
  };
  EXPECT_TRUE(is("robot", content(2)));
  EXPECT_FALSE(reader.next("ball")) << "it is behind";
  EXPECT_TRUE(is("robot", content(4)));
  EXPECT_FALSE(reader.next("robot"));
}

TEST(StateSections, ThatAreOptionalMayBeMissing) {
  const std::vector<std::byte> bytes = three_sections();
  const StateReader reader(bytes);
  EXPECT_NO_THROW(reader.check_names({{"ball"}, {"robot"}, {"robot"}}));
  EXPECT_NO_THROW(reader.check_names({{"ball"}, {"robot"}, {"recorder", true}}));
  EXPECT_TRUE(says(error_of([&] { reader.check_names({{"ball"}}); }), {"the state has robot"}));
  EXPECT_TRUE(says(error_of([&] {
                     reader.check_names({{"ball"}, {"robot"}, {"goal"}});
                   }),
                   {"this simulation has goal, the state has not"}));
}

TEST(StateSections, BytesThatAreNoState) {
  const std::vector<std::byte> bytes = three_sections();
  EXPECT_THROW(StateReader({}), SetupError);
  EXPECT_THROW(StateReader(std::span(bytes).first(20)), SetupError);
  EXPECT_TRUE(says(error_of([&] { StateReader(std::span(bytes).first(bytes.size() - 1)); }), {"not all there"}));
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    std::vector<std::byte> damaged = bytes;
    damaged[i] ^= std::byte{4};
    EXPECT_THROW((StateReader(damaged)), SetupError) << "byte " << i;
  }
}

TEST(StateSections, NoneAreAStateToo) {
  const std::vector<std::byte> bytes = StateWriter().finish();
  StateReader reader(bytes);
  EXPECT_NO_THROW(reader.check_names({}));
  EXPECT_FALSE(reader.next("ball"));
}

}  // namespace
}  // namespace murosimf
