#include "murosimf/model/error.h"

#include <array>

#include <gtest/gtest.h>

namespace murosimf {
namespace {

constexpr std::array<std::string_view, 4> levels{"kinematic_walking", "simplified_dynamics", "full_dynamics",
                                                 "articulated_dynamics"};

// Rule: the nearest name by edits (insert, remove, replace), and a beginning counts as near.
TEST(Error, NearestName) {
  EXPECT_EQ(nearest_name("full", levels), "full_dynamics");
  EXPECT_EQ(nearest_name("full_dynamic", levels), "full_dynamics");
  EXPECT_EQ(nearest_name("fulll_dynamics", levels), "full_dynamics");
  EXPECT_EQ(nearest_name("kinematik_walking", levels), "kinematic_walking");
  EXPECT_EQ(nearest_name("articulated", levels), "articulated_dynamics");
  EXPECT_EQ(nearest_name("full_dynamics", levels), "full_dynamics");
}

// Rule: nothing is suggested where nothing is near, and from nothing.
TEST(Error, NothingNear) {
  EXPECT_EQ(nearest_name("xyz", levels), "");
  EXPECT_EQ(nearest_name("", levels), "");
  EXPECT_EQ(nearest_name("full", {}), "");
}

// Rule: of several near names the nearest wins, whatever the order.
TEST(Error, NearestOfSeveral) {
  const std::array<std::string_view, 3> names{"left_hip", "left_knee", "right_knee"};
  EXPECT_EQ(nearest_name("left_kne", names), "left_knee");
  EXPECT_EQ(nearest_name("right_kne", names), "right_knee");
  const std::array<std::string_view, 2> turned{"blue11", "blue1"};
  EXPECT_EQ(nearest_name("blue2", turned), "blue1");
}

// Rule: the message says what is unknown and then one of three things: the suggestion, the list, or that there is none.
TEST(Error, UnknownName) {
  EXPECT_EQ(unknown_name("level", "full", {"kinematic_walking", "full_dynamics"}),
            "unknown level 'full'; did you mean 'full_dynamics'?");
  EXPECT_EQ(unknown_name("color", "xyz", {"red", "blue"}), "unknown color 'xyz'; known: red, blue");
  EXPECT_EQ(unknown_name("robot", "x", {}), "unknown robot 'x'; there is none");
}

// Rule: a long list is cut after twelve names and says so.
TEST(Error, LongLists) {
  std::vector<std::string> storage;
  for (int i = 0; i < 20; ++i) storage.push_back("candidate" + std::to_string(100 + i));
  std::vector<std::string_view> names(storage.begin(), storage.end());
  const std::string message = unknown_name("thing", "zzzzzz", names);
  EXPECT_NE(message.find("candidate111"), std::string::npos);
  EXPECT_EQ(message.find("candidate112"), std::string::npos);
  EXPECT_EQ(message.substr(message.size() - 5), ", ...");
  names.resize(12);
  const std::string shorter = unknown_name("thing", "zzzzzz", names);
  EXPECT_NE(shorter.find("candidate111"), std::string::npos);
  EXPECT_EQ(shorter.find("..."), std::string::npos);
}

}  // namespace
}  // namespace murosimf
