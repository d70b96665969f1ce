#include "murosimf/model/material.h"

#include <limits>

#include <gtest/gtest.h>

#include "tests/fixtures.h"

namespace murosimf {
namespace {

using fixtures::error_of;
using fixtures::says;

Surface surface(const std::string& material, double friction = 0.8) { return {material, friction}; }

// Rule: a pair is found in either order, and the last word counts.
TEST(Material, OrderOfNamesDoesNotMatter) {
  MaterialTable table;
  table.set("wood", "felt", {.friction = 0.3, .rolling = 0.01, .restitution = 0.2, .stiffness = 5e3});
  for (const auto& [a, b] : {std::pair{"wood", "felt"}, std::pair{"felt", "wood"}}) {
    const PairSurface pair = table.find(surface(a), surface(b));
    EXPECT_EQ(pair.friction, 0.3);
    EXPECT_EQ(pair.rolling, 0.01);
    EXPECT_EQ(pair.restitution, 0.2);
    EXPECT_EQ(pair.stiffness, 5e3);
  }
  table.set("felt", "wood", {.friction = 0.4});
  EXPECT_EQ(table.find(surface("wood"), surface("felt")).friction, 0.4);
}

// Rule: where the table is silent, the larger friction of the two surfaces counts, and defaults for the rest.
TEST(Material, UnknownPairs) {
  MaterialTable table;
  table.set("wood", "felt", {.friction = 0.3});
  for (const auto& [a, b] : {std::pair{"wood", "steel"}, std::pair{"", ""}, std::pair{"wood", "wood"}}) {
    const PairSurface pair = table.find(surface(a, 0.2), surface(b, 0.9));
    EXPECT_EQ(pair.friction, 0.9) << a << ' ' << b;
    EXPECT_EQ(table.find(surface(a, 0.9), surface(b, 0.2)).friction, 0.9);
    EXPECT_EQ(pair.rolling, PairSurface{}.rolling);
    EXPECT_EQ(pair.stiffness, 0);
  }
  // where the table speaks, the surfaces' own friction does not count
  EXPECT_EQ(table.find(surface("wood", 0.9), surface("felt", 0.9)).friction, 0.3);
}

// Rule: a material may be paired with itself.
TEST(Material, PairWithItself) {
  MaterialTable table;
  table.set("steel", "steel", {.friction = 0.15});
  EXPECT_EQ(table.find(surface("steel"), surface("steel")).friction, 0.15);
}

// Rule: impossible numbers are refused; the message names the pair.
TEST(Material, ImpossibleNumbers) {
  const double nan_value = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const auto refused = [](const PairSurface& pair) {
    MaterialTable table;
    return error_of([&] { table.set("wood", "felt", pair); });
  };
  EXPECT_TRUE(says(refused({.friction = -0.1}), {"'wood'", "'felt'", "at least 0"}));
  EXPECT_NE(refused({.rolling = -0.1}), "no error");
  EXPECT_NE(refused({.restitution = -0.1}), "no error");
  EXPECT_NE(refused({.restitution = 1.1}), "no error");
  EXPECT_NE(refused({.stiffness = -1}), "no error");
  EXPECT_TRUE(says(refused({.friction_anisotropy = 1}), {"'wood'", "'felt'", "friction_anisotropy", "below 1"}));
  EXPECT_NE(refused({.friction_anisotropy = -0.1}), "no error");
  EXPECT_TRUE(says(refused({.rolling_anisotropy = 1}), {"'wood'", "'felt'", "rolling_anisotropy", "below 1"}));
  EXPECT_TRUE(says(refused({.rebound = 1.1}), {"'wood'", "'felt'", "rebound", "0 to 1"}));
  EXPECT_NE(refused({.rebound = -0.1}), "no error");
  EXPECT_TRUE(says(refused({.viscous_friction = -0.1}), {"'wood'", "'felt'", "viscous_friction", "at least 0"}));
  EXPECT_NE(refused({.spin_friction = -0.1}), "no error");
  for (const double bad : {nan_value, infinity}) {
    EXPECT_NE(refused({.rebound = bad}), "no error");
    EXPECT_NE(refused({.viscous_friction = bad}), "no error");
    EXPECT_NE(refused({.spin_friction = bad}), "no error");
    EXPECT_NE(refused({.friction = bad}), "no error");
    EXPECT_NE(refused({.rolling = bad}), "no error");
    EXPECT_NE(refused({.restitution = bad}), "no error");
    EXPECT_NE(refused({.stiffness = bad}), "no error");
    EXPECT_NE(refused({.friction_anisotropy = bad}), "no error");
    EXPECT_NE(refused({.rolling_anisotropy = bad}), "no error");
  }
  EXPECT_EQ(refused({.friction = 0, .rolling = 0, .restitution = 0, .stiffness = 0}), "no error");
  EXPECT_EQ(refused({.restitution = 1}), "no error");
}

// Rule: the table that comes with the program knows feet and balls on carpet and grass; the ball bounces better than
// feet and grass brakes it more than carpet.
TEST(Material, StandardTable) {
  const MaterialTable table = MaterialTable::standard();
  EXPECT_EQ(table.find(surface("rubber"), surface("carpet")).friction, 0.8);
  const PairSurface carpet = table.find(surface("carpet"), surface("ball"));
  const PairSurface grass = table.find(surface("grass"), surface("ball"));
  EXPECT_GT(carpet.restitution, table.find(surface("rubber"), surface("carpet")).restitution);
  EXPECT_GT(grass.rolling, carpet.rolling);
  EXPECT_GT(carpet.rolling, 0);
}

// Rule: the table knows every pair of things that can meet: bodies with bodies, bodies with grounds. Only the pile of
// grass leans, for all bodies alike.
TEST(Material, StandardTableIsComplete) {
  const MaterialTable table = MaterialTable::standard();
  const double stranger = 99;  // friction that a pair has only if it is not in the table
  for (const char* body : {"rubber", "plastic", "ball"}) {
    for (const char* other : {"rubber", "plastic", "ball", "carpet", "grass", "wood"}) {
      const PairSurface pair = table.find(surface(body, stranger), surface(other, stranger));
      EXPECT_LT(pair.friction, stranger) << body << ' ' << other;
      EXPECT_EQ(pair.friction_anisotropy > 0, std::string(other) == "grass") << body << ' ' << other;
      EXPECT_EQ(pair.rolling_anisotropy, 0) << body << ' ' << other << ": no measured figure for short pile";
    }
  }
}

}  // namespace
}  // namespace murosimf
