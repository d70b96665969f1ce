// Columns as numbers in memory: where each number stands, and how long it stays there.
#include "murosimf/world/column_view.h"

#include <string>

#include <gtest/gtest.h>

#include "murosimf/model/chain.h"
#include "murosimf/model/properties.h"
#include "murosimf/world/world.h"
#include "tests/fixtures.h"

namespace murosimf {
namespace {

using fixtures::error_of;
using fixtures::says;

constexpr Property<double> numbers{{"test_number", "m", "-", "a number"}};
constexpr Property<Vec3d> vectors{{"test_vector", "m", "world", "a vector"}};
constexpr Property<Mat3d> matrices{{"test_matrix", "1", "world", "a matrix"}};
constexpr Property<Quaterniond> turns{{"test_turn", "1", "world", "a turn", Scope::base}};
constexpr Property<Wrenchd> wrenches{{"test_wrench", "N, N m", "world", "a wrench"}};
constexpr Property<SymMat3d> inertias{{"test_inertia", "kg m^2", "world", "an inertia"}};
/// No row of numbers.
struct Text {
  std::string text;
};
void append_hash(Hasher& hasher, const Text& text) { hasher.add(std::string_view(text.text)); }
void state(StateArchive& archive, Text& text) { archive(text.text); }

constexpr Property<Text> texts{{"test_text", "-", "-", "no row of numbers", Scope::wiring}};

class ColumnViews : public testing::Test {
 protected:
  ColumnViews()
      : robot_(world_.add("robot",
                          std::make_shared<const Model>(
                              "robot", Chain{}.base("base").revolute("one", {1, 0, 0}).revolute("two", {0, 1, 0})))) {}

  World world_;
  Entity& robot_;
};

/// Every number of a row stands where ObjectAccess says, and writing it there is seen by name.
template <class T>
void expect_order_of_names(Entity& robot, const Property<T>& property) {
  robot.column(property);
  const ColumnView view = robot.view(property.name);
  const auto [height, width] = view.shape();
  ASSERT_EQ(height * width, ValueTraits<T>::numbers) << property.name;
  for (std::size_t row = 0; row < view.rows(); ++row) {
    ObjectAccess object(robot, static_cast<int>(row));
    std::vector<double> expected;
    for (std::size_t i = 0; i < height; ++i) {
      for (std::size_t j = 0; j < width; ++j) {
        expected.push_back(100.0 * static_cast<double>(row) + 10.0 * static_cast<double>(i) + static_cast<double>(j));
        view(row, i, j) = expected.back();
      }
    }
    EXPECT_EQ(object.get(property.name).numbers, expected) << property.name;
  }
}

TEST_F(ColumnViews, StandInTheOrderOfNames) {
  expect_order_of_names(robot_, numbers);
  expect_order_of_names(robot_, vectors);
  expect_order_of_names(robot_, matrices);
  expect_order_of_names(robot_, turns);
  expect_order_of_names(robot_, wrenches);
  expect_order_of_names(robot_, inertias);
}

TEST_F(ColumnViews, MatricesAreShownRowByRow) {
  robot_.column(matrices).values[1] = rotation_z(0.3);
  const ConstColumnView view = std::as_const(robot_).view("test_matrix");
  EXPECT_EQ(view(1, 0, 1), -std::sin(0.3));
  EXPECT_EQ(view(1, 1, 0), std::sin(0.3));
  EXPECT_EQ(view.data()[view.strides()[0] + view.strides()[2]], -std::sin(0.3));
}

TEST_F(ColumnViews, HaveARowPerObjectOrOne) {
  robot_.column(vectors);
  robot_.column(turns);
  EXPECT_EQ(robot_.view("test_vector").rows(), 3u);
  EXPECT_EQ(robot_.view("test_turn").rows(), 1u);
  EXPECT_EQ(robot_.view("test_vector").info().unit, "m");
}

TEST_F(ColumnViews, MistakesAreOneLine) {
  robot_.column(vectors);
  robot_.column(texts);
  EXPECT_TRUE(says(error_of([&] { (void)robot_.view("test_vektor"); }), {"robot", "test_vektor", "test_vector"}));
  EXPECT_TRUE(says(error_of([&] { (void)robot_.view("test_text"); }), {"robot", "test_text"}));
}

TEST_F(ColumnViews, KeepAColumnThatNobodyElseUses) {
  std::string name = "test_number";  // a column's name is its own
  Property<double> property = numbers;
  property.name = name;
  robot_.column(property).values[1] = 7;
  const ConstColumnView view = std::as_const(robot_).view(name);
  robot_.columns().drop(robot_.find(name));
  name = "overwritten";
  EXPECT_EQ(robot_.find("test_number"), nullptr);
  EXPECT_EQ(view(1, 0), 7);
  EXPECT_EQ(view.info().name, "test_number");
}

TEST_F(ColumnViews, ShowTheColumnThatComesBack) {
  robot_.column(numbers).start = 3;
  robot_.column(numbers).values[1] = 7;
  const ConstColumnView view = std::as_const(robot_).view("test_number");
  robot_.columns().drop(robot_.find("test_number"));
  Column<double>& again = robot_.column(numbers);
  EXPECT_FALSE(again.start) << "as new";
  EXPECT_NE(view(1, 0), 7);
  again.values[1] = 8;
  EXPECT_EQ(view(1, 0), 8);
}

TEST_F(ColumnViews, GoWithTheirColumnIfNobodyLooks) {
  robot_.column(numbers).values[1] = 7;
  { const ConstColumnView view = std::as_const(robot_).view("test_number"); }
  robot_.columns().drop(robot_.find("test_number"));
  EXPECT_NE(robot_.column(numbers).values[1], 7);
}

TEST_F(ColumnViews, AColumnOfAnotherTypeTakesNobodysPlace) {
  robot_.column(numbers).values[1] = 7;
  const ConstColumnView view = std::as_const(robot_).view("test_number");
  robot_.columns().drop(robot_.find("test_number"));
  const Property<Vec3d> other{{"test_number", "m", "-", "another one"}};
  robot_.column(other).values[1] = {1, 2, 3};
  EXPECT_EQ(view(1, 0), 7);
}

// ---- columns at a start ----

TEST_F(ColumnViews, ColumnsGoBackToWhatWasKept) {
  Column<double>& column = robot_.column(numbers);
  column.values = {1, 2, 3};
  column.keep();
  column.values = {4, 5, 6};
  column.go_back();
  EXPECT_EQ(column.values, (std::vector<double>{1, 2, 3}));
}

TEST_F(ColumnViews, ColumnsOfWhichNothingWasKeptGoBackToTheirStart) {
  Column<double>& column = robot_.column(numbers);
  column.start = 9;
  column.values = {4, 5, 6};
  column.go_back();
  EXPECT_EQ(column.values, (std::vector<double>{9, 9, 9}));
}

}  // namespace
}  // namespace murosimf
