// Tables of steps as files: written and read again, and errors with their places.
#include "murosimf/robot/step_table_file.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/fixtures.h"
#include "tests/temp_folder.h"

namespace murosimf::robot {
namespace {

using locomotion::StepTable;

StepTable some_table() {
  StepTable table;
  for (std::size_t bin = 0; bin < locomotion::step_bins; ++bin) {
    for (std::size_t k = 0; k < locomotion::step_signals; ++k) {
      table.rigid[bin][k] = {0.25 * static_cast<double>(bin), -1.5, static_cast<double>(k), 0};
      table.compliant[bin][k] = {0, 2, 0.125, static_cast<double>(k * bin)};
    }
  }
  return table;
}

std::filesystem::path written(const fixtures::TempFolder& folder, const std::string& text) {
  const std::filesystem::path file = folder.path() / "steps.csv";
  std::ofstream(file) << text;
  return file;
}

TEST(StepTableFile, IsReadAsItWasWritten) {
  const fixtures::TempFolder folder;
  const locomotion::StepTablePtr read = read_step_table(written(folder, to_csv(some_table())));
  EXPECT_EQ(read->rigid, some_table().rigid);
  EXPECT_EQ(read->compliant, some_table().compliant);
}

std::string refused(const std::string& from, const std::string& to) {
  const fixtures::TempFolder folder;
  std::string text = to_csv(some_table());
  const std::size_t place = text.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  text.replace(place, from.size(), to);
  return fixtures::error_of([&] { (void)read_step_table(written(folder, text)); });
}

TEST(StepTableFile, SaysWhatIsWrongAndWhere) {
  const auto has = [](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text << "\n" << part;
  };
  has(refused("joints,bin", "joint,bin"), ":1:1: a table of steps has the columns joints,bin,signal,constant");
  has(refused("rigid,0,outward", "stiff,0,outward"), "unknown word 'stiff'");
  has(refused("rigid,0,outward", "rigid,24,outward"), "a bin is a whole number below 24");
  has(refused("rigid,0,outward", "rigid,0,forward"), "this line was there before");
  has(refused("rigid,1,forward,0.25", "rigid,1,forward,nan"), "the number is not finite");
  has(refused("rigid,1,forward,0.25", "rigid,1,forward,fast"), "fast");
  has(refused("rigid,1,forward,0.25,-1.5,0,0\n", ""), "287 of 288 lines of a table of steps");
}

}  // namespace
}  // namespace murosimf::robot
