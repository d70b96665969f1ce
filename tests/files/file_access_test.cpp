// How names become files is said by a scope: for its thread, until its end, whoever ends it.
#include "murosimf/files/file_access.h"

#include <fstream>
#include <optional>
#include <thread>

#include <gtest/gtest.h>

#include "murosimf/files/data_path.h"
#include "murosimf/files/input_file.h"
#include "murosimf/model/error.h"
#include "tests/temp_folder.h"

namespace murosimf::files {
namespace {

namespace fs = std::filesystem;

struct FileAccessTest : testing::Test {
  FileAccessTest() : folder(fixtures::temp_folder() / "file_access") {
    fs::create_directories(folder / "moved" / folder.relative_path());
    for (const char* name : {"one.toml", "two.toml"}) std::ofstream(folder / name) << name;
    std::ofstream(folder / "moved" / folder.relative_path() / "one.toml") << "as it was";
  }
  ~FileAccessTest() override { fs::remove_all(folder); }
  void read(const std::string& name) const { (void)read_input_file(folder / name, 100); }

  fs::path folder;
  std::shared_ptr<FilesRead> outer = std::make_shared<FilesRead>(), inner = std::make_shared<FilesRead>();
};

TEST_F(FileAccessTest, TheInnermostListGetsWhatIsRead) {
  const FileScope first({.noted = outer});
  read("one.toml");
  {
    const FileScope second({.noted = inner});
    const FileScope nothing({});
    read("two.toml");
    read("two.toml");
  }
  EXPECT_EQ(outer->list(), std::vector{folder / "one.toml"});
  EXPECT_EQ(inner->list(), std::vector{folder / "two.toml"});
}

TEST_F(FileAccessTest, ConcernsItsThreadAlone) {
  const FileScope scope({.only_from = std::make_shared<const AllowedFiles>(std::vector<fs::path>{}), .noted = outer});
  EXPECT_THROW(read("one.toml"), SetupError);
  EXPECT_TRUE(reads_are_limited());
  std::thread([&] {
    const FileScope own({.noted = inner});
    EXPECT_FALSE(reads_are_limited());
    read("one.toml");
  }).join();
  EXPECT_EQ(inner->list().size(), 1U);
  EXPECT_TRUE(outer->list().empty());
}

TEST_F(FileAccessTest, EndsInAnyThreadAndInAnyOrder) {
  auto first = std::make_unique<FileScope>(FileAccess{.noted = outer});
  auto second = std::make_unique<FileScope>(FileAccess{.noted = inner});
  first.reset();
  read("one.toml");
  std::thread([&] { second.reset(); }).join();
  read("two.toml");
  EXPECT_TRUE(outer->list().empty());
  EXPECT_EQ(inner->list(), std::vector{folder / "one.toml"}) << "nobody listens any more";
}

TEST_F(FileAccessTest, NamesOfAnEarlierRunMeanItsFiles) {
  {
    const FileScope noting({.noted = outer});
    EXPECT_EQ(find_data_file("one", "scenes", ".toml", folder), folder / "one.toml");
    EXPECT_FALSE(look_for_data_file("three", "scenes", ".toml", folder));
  }
  std::ofstream(folder / "three.toml") << "of today";
  const FileScope then({.moved = std::make_shared<const MovedFiles>(folder / "moved", outer->names())});
  EXPECT_EQ(find_data_file("one", "scenes", ".toml", folder), folder / "moved" / folder.relative_path() / "one.toml");
  EXPECT_FALSE(look_for_data_file("three", "scenes", ".toml", folder)) << "there was none";
  EXPECT_EQ(find_data_file("two", "scenes", ".toml", folder), folder / "two.toml") << "nobody looked for it";
}

}  // namespace
}  // namespace murosimf::files
