// A result never replaces an input of its command, whatever the names are.
#include "murosimf/files/file_roles.h"

#include <fstream>

#include <gtest/gtest.h>

#include "murosimf/files/input_file.h"
#include "murosimf/files/output_file.h"
#include "tests/fixtures.h"
#include "tests/temp_folder.h"

namespace murosimf::files {
namespace {

namespace fs = std::filesystem;
using fixtures::error_of;

constexpr const char* is_read = "this file is read by the same command";

class FileRolesTest : public testing::Test {
 protected:
  [[nodiscard]] fs::path at(const std::string& name) const { return folder_.path() / name; }
  [[nodiscard]] fs::path made(const std::string& name) const {
    std::ofstream(at(name)) << "text";
    return at(name);
  }
  fixtures::TempFolder folder_;
};

TEST_F(FileRolesTest, InputsUnderAnyNameAreNoOutputs) {
  const FileRoles roles;
  const fs::path file = made("a.csv");
  (void)read_input_file(file, 100);
  fs::create_symlink(file, at("soft.csv"));
  fs::create_symlink("soft.csv", at("softer.csv"));
  fs::create_hard_link(file, at("hard.csv"));
  fs::create_directory(at("in"));
  for (const fs::path& name :
       {file, at("soft.csv"), at("softer.csv"), at("hard.csv"), at("in") / ".." / "a.csv", fs::relative(file)}) {
    const std::string error = error_of([&] { claim_output("--csv", name); });
    EXPECT_EQ(error, "--csv '" + name.string() + "': " + is_read + "; name another one");
  }
  claim_output("--csv", at("b.csv"));
  EXPECT_EQ(error_of([&] { write_file(at("hard.csv"), "new"); }),
            "cannot write '" + at("hard.csv").string() + "': " + is_read + "; name another one");
  EXPECT_EQ(read_input_file(file, 100), "text");
}

TEST_F(FileRolesTest, OutputsAreNotReadLater) {
  const FileRoles roles;
  const fs::path file = made("a.csv");
  fs::create_symlink(file, at("soft.csv"));
  claim_output("--csv", at("soft.csv"));
  EXPECT_TRUE(fixtures::says(error_of([&] { (void)read_input_file(file, 100); }), {"--csv", "soft.csv", is_read}));
  EXPECT_TRUE(fixtures::says(error_of([&] { write_file(at("soft.csv"), "new"); }), {"cannot write", is_read}))
      << "also if the first error was not heeded";
}

TEST_F(FileRolesTest, TwoResultsNeedTwoFiles) {
  const FileRoles roles;
  fs::create_symlink("b.csv", at("to_b.csv"));  // which is not there yet
  claim_output("--csv", at("b.csv"));
  claim_output("--csv", at("b.csv"));  // as a second run of the command does
  for (const std::string name : {"b.csv", "to_b.csv"}) {
    EXPECT_TRUE(fixtures::says(error_of([&] { claim_output("--json", at(name)); }),
                               {"--json", name, "the same file as --csv", "b.csv"}));
  }
  for (const char* option : {"--csv", "--json", "--out"}) claim_output(option, "/dev/null");
}

TEST_F(FileRolesTest, WhatIsGoneOnWithIsRead) {
  const FileRoles roles;
  claim_continued("--runs", made("runs"));
  EXPECT_EQ(read_input_file(at("runs"), 100), "text");
  EXPECT_NE(error_of([&] { claim_output("--csv", at("runs")); }), "");
}

TEST_F(FileRolesTest, AFileThatIsReplacedMeanwhileIsAnother) {
  const FileRoles roles;
  (void)read_input_file(made("old"), 100);
  fs::remove(at("old"));
  write_file(made("new"), "x");  // perhaps of the inode of the old one
  claim_output("--out", at("new"));
}

TEST_F(FileRolesTest, LibrariesNoteNothing) {
  (void)read_input_file(made("a"), 100);
  write_file(at("a"), "new");
  claim_output("--out", at("a"));
  EXPECT_EQ(read_input_file(at("a"), 100), "new");
}

}  // namespace
}  // namespace murosimf::files
