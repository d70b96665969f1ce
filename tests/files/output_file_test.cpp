// Results are whole or not there, and whoever cannot have them is told why.
#include "murosimf/files/output_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <functional>
#include <sstream>

#include "murosimf/model/error.h"
#include "tests/temp_folder.h"

namespace murosimf::files {
namespace {

namespace fs = std::filesystem;

class OutputFile : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fixtures::temp_folder() / ("output_file_test." + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  [[nodiscard]] fs::path file() const { return folder_ / "report.json"; }
  [[nodiscard]] std::string content() const {
    std::stringstream text;
    text << std::ifstream(file()).rdbuf();
    return text.str();
  }
  [[nodiscard]] std::ptrdiff_t files() const {
    return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
  }
  static std::string refusal(const std::function<void()>& call) {
    try {
      call();
    } catch (const SetupError& error) {
      return error.what();
    }
    return {};
  }

  fs::path folder_;
};

TEST_F(OutputFile, ReplacesWhatWasThereAndLeavesNothingElse) {
  std::ofstream(file()) << "an older and longer report";
  write_file(file(), "new");
  EXPECT_EQ(content(), "new");
  EXPECT_EQ(files(), 1);
}

TEST_F(OutputFile, CheckingChangesNothing) {
  std::ofstream(file()) << "old";
  check_writable(file());
  EXPECT_EQ(content(), "old");
  EXPECT_EQ(files(), 1);
}

TEST_F(OutputFile, SaysWhyItCannotBeWritten) {
  const fs::path missing = folder_ / "no" / "report.json";
  const std::string no_folder =
      "cannot write '" + missing.string() + "': there is no folder '" + missing.parent_path().string() + "'";
  EXPECT_EQ(refusal([&] { check_writable(missing); }), no_folder);
  EXPECT_EQ(refusal([&] { write_file(missing, "x"); }), no_folder);
  EXPECT_EQ(refusal([&] { check_writable(folder_); }), "cannot write '" + folder_.string() + "': it is a folder");
  if (fs::exists("/dev/full")) {
    EXPECT_EQ(refusal([] { write_file("/dev/full", "x"); }), "cannot write '/dev/full': No space left on device");
  }
  EXPECT_EQ(files(), 0);
}

TEST_F(OutputFile, SaysThatAFolderIsNotWritable) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  fs::permissions(folder_, fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_EQ(refusal([&] { check_writable(file()); }), "cannot write '" + file().string() + "': Permission denied");
  fs::permissions(folder_, fs::perms::owner_all);
}

}  // namespace
}  // namespace murosimf::files
