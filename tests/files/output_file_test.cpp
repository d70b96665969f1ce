// Results are complete or missing, and a missing result has an error message with the reason.
#include "murosimf/files/output_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
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

TEST_F(OutputFile, GoesWhereALinkLeadsAndKeepsPermissions) {
  fs::create_directory(folder_ / "far");
  fs::create_symlink(fs::path("far") / "result.json", file());
  write_file(file(), "first");
  EXPECT_TRUE(fs::is_symlink(file()));
  EXPECT_EQ(content(), "first");
  fs::permissions(folder_ / "far" / "result.json", fs::perms::owner_read | fs::perms::owner_write);
  write_file(file(), "second");
  EXPECT_EQ(content(), "second");
  EXPECT_EQ(fs::status(folder_ / "far" / "result.json").permissions(), fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(files(), 2);
}

// Standard output may be a file, which is appended to, not replaced.
TEST_F(OutputFile, WritesOnToDescriptors) {
  const int descriptor = ::open(file().c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  ASSERT_EQ(::write(descriptor, "before,", 7), 7);
  for (const std::string folder : {"/dev/fd/", "/proc/self/fd/"}) {
    fs::create_symlink(folder + std::to_string(descriptor), folder_ / "link");
    check_writable(folder + std::to_string(descriptor));
    write_file(folder + std::to_string(descriptor), "x");
    write_file(folder_ / "link", "y");
    fs::remove(folder_ / "link");
  }
  ::close(descriptor);
  EXPECT_EQ(content(), "before,xyxy");
  EXPECT_NE(refusal([&] { check_writable("/proc/self/fd/" + std::to_string(descriptor)); }), "");
}

TEST_F(OutputFile, WritesIntoPipes) {
  ASSERT_EQ(::mkfifo(file().c_str(), 0666), 0);
  const int reader = ::open(file().c_str(), O_RDONLY | O_NONBLOCK);
  check_writable(file());
  write_file(file(), "through");
  std::string text(7, ' ');
  EXPECT_EQ(::read(reader, text.data(), text.size()), 7);
  EXPECT_EQ(text, "through");
  ::close(reader);
  EXPECT_THROW(PartFile{file()}, SetupError);
}

TEST_F(OutputFile, APartThatIsNotCommittedLeavesNothing) {
  std::ofstream(file()) << "old";
  {
    const PartFile part(file(), PartFile::Extension::of_file);
    EXPECT_EQ(part.path().extension(), ".json");
    std::ofstream(part.path()) << "half";
  }
  EXPECT_EQ(content(), "old");
  EXPECT_EQ(files(), 1);
  PartFile part(file());
  EXPECT_EQ(refusal([&] { part.commit(); }), "cannot write '" + file().string() + "': No such file or directory");
  EXPECT_EQ(content(), "old");
}

TEST_F(OutputFile, WhatIsProtectedStays) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everything";
  std::ofstream(file()) << "old";
  fs::permissions(file(), fs::perms::owner_read);
  const std::string denied = "cannot write '" + file().string() + "': Permission denied";
  EXPECT_EQ(refusal([&] { check_writable(file()); }), denied);
  EXPECT_EQ(refusal([&] { write_file(file(), "new"); }), denied);
  EXPECT_EQ(content(), "old");
}

TEST_F(OutputFile, SaysThatAFolderIsNotWritable) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  fs::permissions(folder_, fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_EQ(refusal([&] { check_writable(file()); }), "cannot write '" + file().string() + "': Permission denied");
  fs::permissions(folder_, fs::perms::owner_all);
}

}  // namespace
}  // namespace murosimf::files
