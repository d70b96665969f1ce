// Control tables that come with the program, by the vendors' manuals, and those of users.
#include "murosimf/serial/dynamixel/control_table_file.h"

#include <gtest/gtest.h>

#include <fstream>

#include "murosimf/files/data_path.h"
#include "tests/fixtures.h"
#include "tests/temp_folder.h"

namespace murosimf::serial::dynamixel {
namespace {

namespace fs = std::filesystem;

struct TableValue {
  std::string table;
  int address, size, initial, lowest, highest;
};

// ROBOTIS e-Manual and Feetech's memory table, pages of the models.
TEST(ControlTableFile, HasTheValuesOfTheManual) {
  const std::vector<TableValue> values{{"xl330_m288", 0, 2, 1200, 0, 0},      {"xl330_m288", 38, 2, 1750, 0, 1750},
                                       {"xl330_m288", 44, 4, 445, 0, 2047},   {"xl330_m288", 32, 2, 70, 31, 70},
                                       {"xl330_m288", 63, 1, 53, 0, 255},     {"xl330_m288", 84, 2, 400, 0, 16383},
                                       {"xl330_m288", 8, 1, 1, 0, 6},         {"xl430_w250", 0, 2, 1060, 0, 0},
                                       {"xl430_w250", 31, 1, 72, 0, 100},     {"xl430_w250", 44, 4, 265, 0, 1023},
                                       {"xl430_w250", 80, 2, 4000, 0, 16383}, {"xl430_w250", 84, 2, 640, 0, 16383},
                                       {"xl430_w250", 34, 2, 60, 60, 140},    {"xc330_t288", 0, 2, 1220, 0, 0},
                                       {"xc330_t288", 38, 2, 910, 0, 910},    {"xc330_t288", 84, 2, 900, 0, 16383},
                                       {"xc330_t288", 62, 1, 255, 1, 255},    {"xc430_w150", 0, 2, 1070, 0, 0},
                                       {"xc430_w150", 24, 4, 20, 0, 1023},    {"xc430_w150", 44, 4, 460, 0, 1023},
                                       {"xc430_w150", 84, 2, 460, 0, 16383},  {"xm430_w350", 38, 2, 1193, 0, 1193},
                                       {"xm430_w350", 84, 2, 800, 0, 16383},  {"xm540_w270", 38, 2, 2047, 0, 2047},
                                       {"xm540_w270", 152, 2, 0, 0, 4095},    {"mx64_2", 38, 2, 1941, 0, 1941},
                                       {"mx28_2", 84, 2, 850, 0, 16383},      {"mx106", 10, 1, 0, 0, 1},
                                       {"mx64", 68, 2, 2048, 0, 4095},        {"ax12", 8, 2, 1023, 0, 1023},
                                       {"ax12", 28, 1, 32, 0, 255},           {"ax12", 4, 1, 1, 0, 254},
                                       {"sts3215", 5, 1, 1, 0, 253},          {"sts3215", 42, 2, 2048, -32767, 32767},
                                       {"sts3215", 36, 1, 80, 0, 100}};
  for (const TableValue& value : values) {
    const ControlTable* table = find_servo_table(value.table);
    ASSERT_TRUE(table) << value.table;
    const Field* field = table->at(static_cast<std::size_t>(value.address));
    ASSERT_TRUE(field) << value.table << ' ' << value.address;
    EXPECT_EQ(field->address, value.address) << value.table;
    EXPECT_EQ(field->size, value.size) << value.table << ' ' << value.address;
    EXPECT_EQ(field->initial, value.initial) << value.table << ' ' << value.address;
    EXPECT_EQ(field->lowest, value.lowest) << value.table << ' ' << value.address;
    EXPECT_EQ(field->highest, value.highest) << value.table << ' ' << value.address;
  }
  EXPECT_EQ(find_servo_table("xl430_w250")->at(38), nullptr) << "it measures no current";
  EXPECT_EQ(find_servo_table("xl430_w250")->find(Item::present_load)->address, 126);
  EXPECT_EQ(find_servo_table("xl430_w250")->find(Item::present_current), nullptr);
  EXPECT_EQ(find_servo_table("xm430_w350")->find(Item::present_load), nullptr);
}

TEST(ControlTableFile, EveryOneNamesItsSource) {
  std::size_t found = 0;
  for (const std::string& name : servo_table_names()) {
    std::ifstream file(*files::look_for_data_file("servos/tables/" + name + ".toml", "", ""));
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const bool derived = text.find("base = \"xl330_m288\"") != std::string::npos;
    EXPECT_TRUE(derived || text.find("# Source: ") != std::string::npos) << name;
    ++found;
  }
  EXPECT_GE(found, 18U);
}

fs::path write_table(const std::string& name, const std::string& text) {
  const fs::path path = fixtures::temp_folder() / name;
  std::ofstream(path) << text;
  return path;
}

TEST(ControlTableFile, UsersHaveTheirOwn) {
  const fs::path path =
      write_table("mine.toml",
                  "base = \"xm430_w350\"\nwithout = [88, 90]\n[units]\nstall_torque = 3.3\n"
                  "[table]\nfields = [[0, 2, \"read\", 4711, 0, 0, \"model_number\"],\n"
                  "[84, 2, \"ram\", 500, 0, 999, \"position_p_gain\"], [86, 1, \"ram\", 7, 0, 9, \"(mine)\"]]\n");
  const ControlTable* table = find_servo_table("mine.toml", path.parent_path());
  ASSERT_TRUE(table);
  EXPECT_EQ(table->name, "mine");
  EXPECT_EQ(table->find(Item::model_number)->initial, 4711);
  EXPECT_EQ(table->at(84)->highest, 999);
  EXPECT_EQ(table->at(86)->initial, 7);
  EXPECT_EQ(table->at(88), nullptr);
  EXPECT_EQ(table->units.stall_torque, 3.3);
  EXPECT_EQ(table->units.current, 0.00269);
  EXPECT_EQ(table->indirect.size(), 2U);
  EXPECT_EQ(find_servo_table("mine"), nullptr) << "without an end it is one of those that come with the program";
  EXPECT_EQ(find_servo_table("nosuch.toml", path.parent_path()), nullptr);
  EXPECT_EQ(find_servo_table("mine.toml", path.parent_path()), table) << "read once";
}

TEST(ControlTableFile, SaysWhatIsWrong) {
  const auto refusal = [](const std::string& text) {
    const fs::path path = write_table("wrong.toml", text);
    return fixtures::error_of([&] { (void)read_control_table(path); });
  };
  const auto of_field = [&](const std::string& field) {
    return refusal("base = \"xm430_w350\"\n[table]\nfields = [" + field + "]\n");
  };
  EXPECT_TRUE(fixtures::says(of_field("[86, 1, \"ram\", 0, 0, 1, \"goal_positon\"]"),
                             {"wrong.toml:3:11: ", "did you mean 'goal_position'?", "in brackets it is kept"}));
  EXPECT_TRUE(fixtures::says(of_field("[86, 3, \"ram\", 0, 0, 1, \"(a)\"]"), {"1, 2 or 4 bytes"}));
  EXPECT_TRUE(fixtures::says(of_field("[86, 1, \"rom\", 0, 0, 1, \"(a)\"]"), {"unknown access 'rom'"}));
  EXPECT_TRUE(fixtures::says(of_field("[86, 1, \"ram\", 2, 0, 1, \"(a)\"]"), {"out of its range"}));
  EXPECT_TRUE(fixtures::says(of_field("[86, 1, \"ram\", 0, 2, 1, \"(a)\"]"), {"the lowest number is above"}));
  EXPECT_TRUE(fixtures::says(of_field("[86, 1, \"ram\", 0, 0, 256, \"(a)\"]"), {"needs more bytes"}));
  EXPECT_TRUE(fixtures::says(of_field("[86, 1, \"ram\", 0]"), {"a field is [address, bytes"}));
  EXPECT_TRUE(fixtures::says(of_field("[86, 1.5, \"ram\", 0, 0, 1, \"(a)\"]"), {"number 2 of a field"}));
  EXPECT_TRUE(fixtures::says(of_field("[85, 2, \"ram\", 0, 0, 1, \"(a)\"]"), {"begins within the one before"}));
  EXPECT_TRUE(fixtures::says(of_field("[86, 1, \"ram\", 0, 0, 1, \"(a)\"], [86, 1, \"ram\", 0, 0, 1, \"(b)\"]"),
                             {"two fields stand at 86"}));
  EXPECT_TRUE(fixtures::says(refusal("protocol = 2\n"), {"there is no field 'model_number'"}));
  EXPECT_TRUE(fixtures::says(refusal("base = \"nosuch\"\n"), {"unknown table 'nosuch'"}));
  EXPECT_TRUE(fixtures::says(refusal("base = \"wrong\"\n"), {"too many bases"}));
  EXPECT_TRUE(fixtures::says(refusal("protocl = 2\n"), {"did you mean 'protocol'?"}));
  EXPECT_TRUE(fixtures::says(refusal("base = \"xm430_w350\"\nprotocol = 3\n"), {"the protocol is 1 or 2"}));
  EXPECT_TRUE(fixtures::says(refusal("base = \"xm430_w350\"\nbaud_rates = [\"fast\"]\n"), {"a list of numbers"}));
  EXPECT_TRUE(fixtures::says(refusal("base = \"xm430_w350\"\n[units]\nvelocity = -1\n"), {"velocity is negative"}));
  EXPECT_TRUE(fixtures::says(refusal("base = \"xm430_w350\"\n[[indirect]]\naddresses = 168\ndata = 170\ncount = 4\n"),
                             {"side by side"}));
}

}  // namespace
}  // namespace murosimf::serial::dynamixel
