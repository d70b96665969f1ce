// The format new_name: what is read of it, and its errors.
#include "murosimf/robot_formats/new_name/new_name_reader.h"

#include <gtest/gtest.h>

#include <fstream>

#include "murosimf/robot/robot_reader.h"
#include "tests/fixtures.h"
#include "tests/temp_folder.h"

namespace murosimf::robot_formats::new_name {
namespace {

std::filesystem::path written(const std::string& text) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const std::filesystem::path file = fixtures::temp_folder() / (std::string(test->name()) + ".new_name");
  std::ofstream(file) << text;
  return file;
}

std::string error(const std::string& text) {
  return fixtures::error_of([&] { (void)read(written(text)); });
}

TEST(NewNameReader, ReadsARobotAsAnyOther) {
  const robot::RobotFile robot = robot::read_robot(written("0.2 2.5\n"));
  EXPECT_EQ(robot.model->tree().mass, 2.5);
  EXPECT_EQ(robot.description.bodies.at(0).shapes.size(), 1U);
}

TEST(NewNameReader, MistakesAreOneLineThatSaysWhere) {
  EXPECT_TRUE(fixtures::says(error(""), {".new_name", "the file is empty"}));
  EXPECT_TRUE(fixtures::says(error("0.2\n"), {".new_name:1", "mass"}));
  EXPECT_TRUE(fixtures::says(error("0.2 -1\n"), {".new_name:1", "above 0"}));
}

}  // namespace
}  // namespace murosimf::robot_formats::new_name
