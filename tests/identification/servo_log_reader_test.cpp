// Recordings of servos: all data are read, and every error is one line with file and place.
#include "murosimf/identification/servo_log_reader.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "murosimf/model/error.h"
#include "tests/temp_folder.h"

namespace murosimf::identification {
namespace {

namespace fs = std::filesystem;

const std::string first =
    R"({"timestamp": 2.0, "position": 0.1, "speed": -0.2, "input_volts": 7.3, "goal_position": 0.5, "torque_enable": true})";
const std::string second =
    R"({"timestamp": 2.007, "position": 0.2, "speed": 0.3, "input_volts": 7.1, "goal_position": 0.6, "torque_enable": false})";

std::string log_with(const std::string& entries) {
  return R"({"mass": 0.49, "length": 0.1, "kp": 400, "motor": "xl330", "trajectory": "sin_sin",)"
         "\n\"entries\": [" +
         entries + "]}";
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const auto place = text.find(what);
  EXPECT_NE(place, std::string::npos) << what;
  return text.replace(place, what.size(), by);
}

class ServoLogFile : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fixtures::temp_folder() / ("servo_log_test." + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path write(const std::string& text, const std::string& name = "log.json") const {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }
  /// The reader's error: one line that begins with the file.
  [[nodiscard]] std::string error(const std::string& text) const {
    const fs::path file = write(text);
    try {
      (void)read_servo_log(file);
    } catch (const SetupError& error) {
      const std::string line = error.what();
      EXPECT_EQ(line.rfind(file.string() + ": ", 0), 0U) << line;
      EXPECT_EQ(std::count(line.begin(), line.end(), '\n'), 0) << line;
      return line.substr(std::min(line.size(), file.string().size() + 2));
    }
    return "nothing";
  }

  fs::path folder_;
};

TEST_F(ServoLogFile, SaysWhatWasRecorded) {
  const auto log = read_servo_log(write(log_with(first + "," + second)));
  EXPECT_EQ(log.name, "log");
  EXPECT_EQ(log.motor, "xl330");
  EXPECT_EQ(log.trajectory, "sin_sin");
  EXPECT_EQ(log.mass, 0.49);
  EXPECT_EQ(log.length, 0.1);
  EXPECT_EQ(log.arm_mass, 0) << "absent: none";
  EXPECT_EQ(log.firmware_gain, 400);
  ASSERT_EQ(log.samples.size(), 2U);
  EXPECT_EQ(log.samples[0].time, 0) << "from the first entry on";
  EXPECT_NEAR(log.samples[1].time, 0.007, 1e-12);
  EXPECT_EQ(log.samples[1].position, 0.2);
  EXPECT_EQ(log.samples[1].rate, 0.3);
  EXPECT_EQ(log.samples[1].voltage, 7.1);
  EXPECT_EQ(log.samples[1].goal, 0.6);
  EXPECT_TRUE(log.samples[0].enabled);
  EXPECT_FALSE(log.samples[1].enabled);
}

TEST_F(ServoLogFile, TheArmMayHaveAMass) {
  const std::string text = replaced(log_with(first + "," + second), "\"kp\"", "\"arm_mass\": 0.05, \"kp\"");
  EXPECT_EQ(read_servo_log(write(text)).arm_mass, 0.05);
}

TEST_F(ServoLogFile, AMissingFieldIsNamed) {
  const std::string good = log_with(first + "," + second);
  for (const std::string field : {"mass", "length", "kp", "entries"}) {
    EXPECT_EQ(error(replaced(good, "\"" + field, "\"no_" + field)), "field '" + field + "' is missing");
  }
  for (const std::string field : {"timestamp", "position", "speed", "input_volts", "goal_position", "torque_enable"}) {
    EXPECT_EQ(error(log_with(first + "," + replaced(second, "\"" + field, "\"no_" + field))),
              "entry 2: field '" + field + "' is missing");
  }
}

TEST_F(ServoLogFile, TimeMustGrow) {
  EXPECT_EQ(error(log_with(second + "," + first)), "entry 2: timestamp 2 is not after 2.007 of the entry before");
  EXPECT_EQ(error(log_with(first + "," + first)), "entry 2: timestamp 2 is not after 2 of the entry before");
  EXPECT_EQ(error(log_with(first + "," + replaced(second, "2.007", "9000"))),
            "it lasts 8998 s; 'timestamp' is in seconds");
}

TEST_F(ServoLogFile, NumbersMustBeNumbers) {
  for (const std::string value : {"null", "\"0.2\"", "true", "[]"}) {
    EXPECT_EQ(error(log_with(first + "," + replaced(second, "0.2", value))),
              "entry 2: 'position' must be a finite number")
        << value;
  }
  for (const std::string value : {"NaN", "Infinity", "-Infinity"}) {
    EXPECT_EQ(error(log_with(first + "," + replaced(second, "0.2", value))),
              "line 2: a value is NaN or infinite; leave that entry out")
        << value;
  }
  EXPECT_EQ(error(log_with(first + "," + replaced(second, "0.2", "1e999"))), "a number in it is too large");
  EXPECT_EQ(error(log_with(first + "," + replaced(second, "false", "1"))),
            "entry 2: 'torque_enable' must be true or false");
  EXPECT_EQ(error(log_with(first + "," + replaced(second, "7.1", "0"))), "entry 2: 'input_volts' must be above 0");
  EXPECT_EQ(error(replaced(log_with(first + "," + second), "0.49", "-1")), "'mass' must be above 0");
  EXPECT_EQ(error(replaced(log_with(first + "," + second), "400", "-1")), "'kp' must be at least 0");
}

TEST_F(ServoLogFile, ListsMustBeLists) {
  EXPECT_EQ(error(log_with("")), "'entries' has 0 entries; at least 2");
  EXPECT_EQ(error(log_with(first)), "'entries' has 1 entries; at least 2");
  EXPECT_EQ(error(log_with("1, 2")), "entry 1: this is no object with fields in braces");
  EXPECT_EQ(error("[]"), "this is no object with fields in braces");
  EXPECT_EQ(error(R"({"mass": 1, "length": 1, "kp": 1, "entries": 3})"), "'entries' must be a list");
}

TEST_F(ServoLogFile, OtherFilesAreNoJson) {
  EXPECT_EQ(error(""), "line 1: this is no JSON");
  EXPECT_EQ(error("{\n\"mass\": 0.49,\n"), "line 3: this is no JSON");
}

TEST_F(ServoLogFile, AFolderMeansAllLogsInIt) {
  write(log_with(first + "," + second), "b.json");
  write(log_with(first + "," + second), "a.json");
  write("something else", "LICENSE");
  const auto logs = read_servo_logs({folder_.string(), (folder_ / "b.json").string()});
  ASSERT_EQ(logs.size(), 3U);
  EXPECT_EQ(logs[0].name, "a");
  EXPECT_EQ(logs[1].name, "b");
  EXPECT_EQ(logs[2].name, "b");
}

TEST_F(ServoLogFile, NothingToReadIsAMistake) {
  EXPECT_THROW((void)read_servo_logs({}), SetupError);
  EXPECT_THROW((void)read_servo_logs({folder_.string()}), SetupError) << "an empty folder";
  EXPECT_THROW((void)read_servo_logs({(folder_ / "none.json").string()}), SetupError);
}

}  // namespace
}  // namespace murosimf::identification
