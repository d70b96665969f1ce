// Tables of comma-separated numbers: valid ones, errors, and columns that are drawn in one panel.
#include "murosimf/files/csv_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <fstream>

#include "murosimf/logging/log_csv.h"
#include "murosimf/logging/log_plot.h"
#include "murosimf/model/error.h"
#include "tests/fixtures.h"
#include "tests/temp_folder.h"

namespace murosimf::files {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

class CsvFile : public testing::Test {
 protected:
  void TearDown() override { fs::remove(file_); }
  CsvTable read(const std::string& text) {
    std::ofstream(file_, std::ios::binary) << text;
    return read_csv(file_);
  }
  std::string refusal(const std::string& text) {
    try {
      read(text);
    } catch (const SetupError& error) {
      return error.what();
    }
    return {};
  }
  void expect(const std::string& text, const std::string& part) {
    const std::string message = refusal(text);
    EXPECT_NE(message.find(file_.string() + part), std::string::npos) << text << " said: " << message;
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
  fs::path file_ = fixtures::temp_folder() / ("csv_file_test." + std::to_string(::getpid()) + ".csv");
};

TEST_F(CsvFile, ReadsSemicolonsTabsAndDecimalCommas) {
  for (const char* text :
       {"time [s];a [m, world];b\n0;0,5;-1,25e1\n1;;3\n", "time [s]\ta [m, world]\tb\n0\t0,5\t-12.5\n1\t\t3\n",
        "sep=;\r\ntime [s];a [m, world];b\r\n0;0.5;-12,5\r\n1;;3\r\n",
        "\"time [s]\";\"a [m, world]\";\"b\"\n\"0\";\"0,5\";\"-12,5\"\n1;;3\n"}) {
    const CsvTable table = read(text);
    ASSERT_EQ(table.columns.size(), 2U) << text;
    EXPECT_EQ(table.columns[0].unit, "m, world");
    EXPECT_EQ(table.columns[0].values, std::vector<double>{0.5}) << text;
    EXPECT_EQ(table.columns[1].values, (std::vector<double>{-12.5, 3})) << text;
  }
}

TEST_F(CsvFile, TakesACommaWhereInDoubt) {
  EXPECT_EQ(read("time [s],a;b\n0,1\n").columns.at(0).name, "a;b");
  EXPECT_EQ(read("\"t;u;v\",a\n0,1\n").columns.at(0).name, "a");
  expect("t;a\n0;1.234,5\n", ":2:3: '1.234,5' is no number");
  expect("t,a\n\"0\";1\n", ":2:4: a comma is missing behind the quotes");
  expect("t;a\n\"0\",1\n", ":2:4: a semicolon is missing behind the quotes");
  expect("sep=;\nt;a\n0;x\n", ":3:3: 'x' is no number");
  expect("\n\nt;a\n0;x\n", ":4:3: 'x' is no number");
}

TEST_F(CsvFile, GivesBackWhatALogWrote) {
  logging::LogSeries slow{{"a.imu.x [m/s^2]", "plain"}, {}, {}}, fast{{"odd, \"name\"\nof two lines"}, {}, {}};
  RandomStream random(1, "csv");
  for (int i = 0; i < 100; ++i) {
    if (i % 3 == 0) {
      slow.times.push_back(i * 7ms);
      for (int k = 0; k < 2; ++k) slow.values.push_back(random.normal(2 * i + k) * std::pow(10, i % 30 - 15));
    }
    fast.times.push_back(i * 7ms);
    fast.values.push_back(random.normal(1000 + i));
  }
  const CsvTable table = read(logging::to_csv({&slow, &fast}));
  EXPECT_EQ(table.time, "time [s]");
  ASSERT_EQ(table.columns.size(), 3U);
  EXPECT_EQ(table.columns[0].name, "a.imu.x");
  EXPECT_EQ(table.columns[0].unit, "m/s^2");
  EXPECT_EQ(table.columns[1].unit, "");
  EXPECT_EQ(table.columns[2].name, fast.names[0]);
  EXPECT_EQ(table.columns[2].values, fast.values);
  ASSERT_EQ(table.columns[1].values.size(), slow.times.size());
  for (std::size_t i = 0; i < slow.times.size(); ++i) {
    EXPECT_EQ(table.columns[0].values[i], slow.values[2 * i]);
    EXPECT_EQ(table.columns[1].values[i], slow.values[2 * i + 1]);
    EXPECT_EQ(table.columns[1].times[i], static_cast<double>(slow.times[i].count()) / 1e9);
  }
}

TEST_F(CsvFile, ReadsWhatOtherProgramsWrite) {
  const CsvTable table = read("\xef\xbb\xbft, a ,\"b\"\r\n 0 ,+1,\"2\"\r\n\r\n1,NaN,-Infinity\r\n2,,1e3");
  EXPECT_EQ(table.time, "t");
  EXPECT_EQ(table.columns[0].name, "a");
  EXPECT_EQ(table.columns[0].times, (std::vector<double>{0, 1}));
  EXPECT_TRUE(std::isnan(table.columns[0].values[1]));
  EXPECT_EQ(table.columns[1].values, (std::vector<double>{2, -INFINITY, 1000}));
}

TEST_F(CsvFile, SaysWhereItIsWrong) {
  expect("", ":1:1: the file is empty");
  expect("\n\n", ":2:1: the file is empty");
  expect("time\n1\n", ":1:1: there must be a column of time");
  expect("0,1\n2,3\n", ":1:1: a number where");
  expect("t,3\n2,3\n", ":1:3: a number where");
  expect("t,a,b\n1,2,3\n2,3,four\n", ":3:5: 'four' is no number");
  expect("t,a\n1,2 3\n", ":2:3: '2 3' is no number");
  expect("t,a\n1,2\n3\n", ":3:1: 1 cells, where the first line has 2");
  expect("t,a\n1,2,3\n", ":2:1: 3 cells");
  expect("t,a\n,2\n", ":2:1: '' is no number");
  expect("t,a\nnan,2\n", ":2:1: the time must be");
  expect("t,\"a\n1,2\n", ":1:3: this quotation has no end");
  expect("t,\"a\"b\n1,2\n", ":1:6: a comma is missing");
  expect("t,\"a\nb\"\n1,x\n", ":3:3: 'x' is no number");
  EXPECT_THROW((void)read_csv("/no/such/file.csv"), SetupError);
  EXPECT_THROW((void)read_csv("/"), SetupError);
}

CsvColumn column(const std::string& name, const std::string& unit) { return {name, unit, {0, 1}, {1, 2}}; }

TEST(LogPlot, HasAPanelForEachUnitOfASensor) {
  const CsvTable table{"time [s]",
                       {column("a.imu.gyroscope.x", "rad/s"), column("a.imu.accelerometer.x", "m/s^2"),
                        column("a.imu.gyroscope.y", "rad/s"), column("b.imu.gyroscope.x", "rad/s"),
                        column("a.imu.rates.z", "rad/s"), column("height", "m"), column("width", "m")}};
  const logging::Plot plot = logging::plot_of(table, "Run");
  EXPECT_EQ(plot.x_label, "time [s]");
  ASSERT_EQ(plot.panels.size(), 4U);
  EXPECT_EQ(plot.panels[0].y_label, "a.imu [rad/s]");
  ASSERT_EQ(plot.panels[0].curves.size(), 3U);
  EXPECT_EQ(plot.panels[0].curves[0].name, "gyroscope.x");
  EXPECT_EQ(plot.panels[0].curves[2].name, "rates.z");
  EXPECT_EQ(plot.panels[1].y_label, "a.imu.accelerometer.x [m/s^2]") << "one curve needs no legend";
  EXPECT_EQ(plot.panels[1].curves[0].name, "");
  EXPECT_EQ(plot.panels[2].y_label, "b.imu.gyroscope.x [rad/s]");
  EXPECT_EQ(plot.panels[3].y_label, "m");
  EXPECT_EQ(plot.panels[3].curves[1].name, "width");
}

TEST(LogPlot, HasAPanelForTheSameNumberOfManyObjects) {
  CsvTable table{"t", {}};
  for (int i = 0; i < 21; ++i) table.columns.push_back(column("a.j" + std::to_string(i) + ".joint_position", "rad"));
  table.columns.push_back(column("b.j0.joint_position", "rad"));
  const logging::Plot plot = logging::plot_of(table, "");
  ASSERT_EQ(plot.panels.size(), 2U);
  EXPECT_EQ(plot.panels[0].y_label, "a.*.joint_position [rad]");
  ASSERT_EQ(plot.panels[0].curves.size(), 21U);
  EXPECT_EQ(plot.panels[0].curves[20].name, "j20");
  EXPECT_EQ(plot.panels[1].y_label, "b.j0.joint_position [rad]");
}

TEST(LogPlot, DrawsWhatPatternsName) {
  const CsvTable table{"t",
                       {column("a.imu.gyroscope.x", "rad/s"), column("a.imu.accelerometer.x", "m/s^2"),
                        column("a.imu.gyroscope.y", "rad/s"), column("odd*name", "")}};
  EXPECT_EQ(logging::plot_of(table, "", {"a.imu.gyro*"}).panels.at(0).curves.size(), 2U);
  EXPECT_EQ(logging::plot_of(table, "", {"*.*.*.x"}).panels.size(), 2U);
  EXPECT_EQ(logging::plot_of(table, "", {"odd*name"}).panels.at(0).y_label, "odd*name");
  try {
    (void)logging::plot_of(table, "", {"a.imu.gyroscope.z"});
    FAIL();
  } catch (const SetupError& error) {
    EXPECT_NE(std::string(error.what()).find("unknown column 'a.imu.gyroscope.z'; did you mean 'a.imu.gyroscope."),
              std::string::npos)
        << error.what();
  }
}

TEST(LogPlot, RefusesMoreThanCanBeToldApart) {
  CsvTable rays{"t", {}}, panels{"t", {}};
  for (int i = 0; i < 100; ++i) {
    rays.columns.push_back(column("a.laser.distance." + std::to_string(i), "m"));
    panels.columns.push_back(column("a.part" + std::to_string(i) + ".place.x", "m"));
  }
  for (const auto& [table, what] : {std::pair{rays, "100 curves"}, std::pair{panels, "100 panels"}}) {
    try {
      (void)logging::plot_of(table, "");
      FAIL();
    } catch (const SetupError& error) {
      EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace murosimf::files
