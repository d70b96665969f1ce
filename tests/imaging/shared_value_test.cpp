// Shared data of equal cameras: one object for equal keys, as long as it is in use.
#include "murosimf/imaging/shared_value.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace murosimf::imaging {
namespace {

struct Made {
  int number = 0;
};

TEST(SharedValue, IsOneForEqualKeysWhileSomebodyHasIt) {
  int made = 0;
  const auto make = [&] { return Made{++made}; };
  auto first = shared_value<Made>(std::string("a"), make);
  EXPECT_EQ(shared_value<Made>(std::string("a"), make), first);
  EXPECT_EQ(shared_value<Made>(std::string("b"), make)->number, 2);
  EXPECT_EQ(shared_value<Made>(std::string("a"), make)->number, 1) << "b is gone, a is not";
  first.reset();
  EXPECT_EQ(shared_value<Made>(std::string("a"), make)->number, 3);
}

TEST(SharedValue, OfOtherKeysIsAnother) {
  const auto by_name = shared_value<Made>(std::string("1"), [] { return Made{1}; });
  const auto by_number = shared_value<Made>(1, [] { return Made{2}; });
  EXPECT_EQ(by_name->number, 1);
  EXPECT_EQ(by_number->number, 2);
}

TEST(SharedValue, WhatCannotBeMadeIsNotKept) {
  const auto fail = []() -> Made { throw std::runtime_error("no"); };
  EXPECT_THROW((void)shared_value<Made>(std::string("x"), fail), std::runtime_error);
  EXPECT_EQ(shared_value<Made>(std::string("x"), [] { return Made{4}; })->number, 4);
}

}  // namespace
}  // namespace murosimf::imaging
