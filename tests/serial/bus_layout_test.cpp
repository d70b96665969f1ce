// Which servo moves which joint: by default, and from tables, with all that may be wrong in them.
#include "murosimf/serial/bus_layout.h"

#include <gtest/gtest.h>

#include <fstream>
#include <numbers>

#include "murosimf/model/properties.h"
#include "tests/fixtures.h"
#include "tests/temp_folder.h"

namespace murosimf::serial {
namespace {

using dynamixel::Protocol;

/// Three joints with servos of a known type, of an unknown one, and without.
const Model& arm() {
  static const Model model = [] {
    const auto servo = [](const std::string& type) {
      Servo made;
      made.type = type;
      return made;
    };
    return Model("arm", Chain{}
                            .base("base")
                            .with(properties::mass, 1.0)
                            .with(properties::inertia, {1, 1, 1, 0, 0, 0})
                            .revolute("shoulder", {0, 1, 0})
                            .with(properties::servo, servo("mx64"))
                            .revolute("elbow", {0, 1, 0})
                            .with(properties::servo, servo("xl330"))
                            .revolute("wrist", {0, 1, 0}));
  }();
  return model;
}

std::filesystem::path file_of(const std::string& text) {
  std::filesystem::path file = fixtures::temp_folder() / "bus.csv";
  std::ofstream(file) << text;
  return file;
}

std::vector<ServoPlace> layout(const std::string& text) { return read_layout(file_of(text), arm(), Protocol::v2); }

std::string error(const std::string& text) {
  return fixtures::error_of([&] { (void)layout(text); });
}

TEST(BusLayout, HasAllJointsInTheirOrder) {
  const std::vector<ServoPlace> old = usual_layout(arm(), Protocol::v1), modern = usual_layout(arm(), Protocol::v2);
  ASSERT_EQ(old.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(old[i].joint, i);
    EXPECT_EQ(old[i].id, i + 1);
    EXPECT_EQ(old[i].direction, 1);
    EXPECT_EQ(old[i].zero, 0);
  }
  EXPECT_EQ(old[0].table->name, "mx64");
  EXPECT_TRUE(old[0].own_type);
  EXPECT_EQ(modern[0].table->name, "mx64_2");
  EXPECT_EQ(old[1].table->name, "xl330") << "it knows protocol 2.0 only";
  EXPECT_EQ(modern[1].table->name, "xl330");
  EXPECT_TRUE(modern[1].own_type);
  EXPECT_EQ(modern[2].table->name, "mx28_2");
  EXPECT_FALSE(modern[2].own_type);
}

TEST(BusLayout, IsReadFromATable) {
  const std::vector<ServoPlace> places =
      layout("zero [deg],joint,servo,id,direction\n90,wrist,xm430_w350,252,-1\n,shoulder,,0,\n");
  ASSERT_EQ(places.size(), 2U);
  EXPECT_EQ(places[0].joint, 2U);
  EXPECT_EQ(places[0].id, 252);
  EXPECT_EQ(places[0].table->name, "xm430_w350");
  EXPECT_EQ(places[0].direction, -1);
  EXPECT_NEAR(places[0].zero, std::numbers::pi / 2, 1e-12);
  EXPECT_EQ(places[1].joint, 0U);
  EXPECT_EQ(places[1].table->name, "mx64_2");
  EXPECT_EQ(layout("joint,id,zero [rad]\nelbow,7,0.5\n")[0].zero, 0.5);
}

TEST(BusLayout, SaysWhatIsWrongAndWhere) {
  const std::vector<std::pair<std::string, std::string>> errors{
      {"", "bus.csv:1:1: the file is empty"},
      {"joint,id\n", "there is no servo"},
      {"joint\nelbow\n", "the columns 'joint' and 'id' are needed"},
      {"joint,id,zeros\n", "bus.csv:1:10: unknown column 'zeros'; did you mean 'zero'?"},
      {"joint,id,id\n", "bus.csv:1:10: there are two columns 'id'"},
      {"joint,id,zero\n", "write 'zero [deg]' or 'zero [rad]'"},
      {"joint,id\nelbow\n", "bus.csv:2:1: 1 cells, where the first line has 2"},
      {"joint,id\nelbov,1\n", "bus.csv:2:1: unknown joint 'elbov'; did you mean 'elbow'?"},
      {"joint,id\nelbow,1\nelbow,2\n", "bus.csv:3:1: 'elbow' has a servo already"},
      {"joint,id\nelbow,1\nwrist,1\n", "bus.csv:3:7: two servos have the id 1"},
      {"joint,id\nelbow,253\n", "an id is a whole number from 0 to 252"},
      {"joint,id\nelbow,1.5\n", "an id is a whole number from 0 to 252"},
      {"joint,id\nelbow,one\n", "bus.csv:2:7: "},
      {"joint,id,servo\nelbow,1,mx29\n", "bus.csv:2:9: unknown servo 'mx29'; did you mean 'mx28'?"},
      {"joint,id,direction\nelbow,1,0\n", "the direction is 1 or -1"},
      {"joint,id,zero [rad]\nelbow,1,inf\n", "the zero must be an angle"},
  };
  for (const auto& [text, message] : errors) EXPECT_TRUE(fixtures::says(error(text), {message})) << error(text);
}

}  // namespace
}  // namespace murosimf::serial
