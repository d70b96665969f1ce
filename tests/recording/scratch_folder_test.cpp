// Folders of processes that were killed go with the next one that is made; those of living ones stay.
#include "murosimf/recording/scratch_folder.h"

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "tests/temp_folder.h"

namespace murosimf {
namespace {

namespace fs = std::filesystem;
using recording::ScratchFolder;
using namespace std::chrono_literals;

/// Until the end of the test temporary files go there.
class TemporaryFiles {
 public:
  explicit TemporaryFiles(const fs::path& folder) {
    if (const char* before = std::getenv("TMPDIR")) before_ = before;
    fs::create_directories(folder);
    setenv("TMPDIR", folder.c_str(), 1);
  }
  ~TemporaryFiles() { before_.empty() ? unsetenv("TMPDIR") : setenv("TMPDIR", before_.c_str(), 1); }
  TemporaryFiles(const TemporaryFiles&) = delete;
  TemporaryFiles& operator=(const TemporaryFiles&) = delete;

 private:
  std::string before_;
};

/// As two minutes ago.
void make_older(const fs::path& folder) { fs::last_write_time(folder, fs::file_time_type::clock::now() - 2min); }

TEST(ScratchFolder, OfAKilledProcessGoesWithTheNext) {
  const fs::path where = fixtures::temp_folder() / "scratch";
  const TemporaryFiles there(where);
  const pid_t child = ::fork();
  if (child == 0) {
    const ScratchFolder folder;
    std::ofstream(folder.path() / "half.mcap") << "half";
    ::kill(::getpid(), SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_FALSE(fs::is_empty(where)) << "what is left";
  const fs::path left = fs::directory_iterator(where)->path();
  fs::path mine;
  {
    const ScratchFolder young;
    EXPECT_TRUE(fs::exists(left)) << "its process may only just have begun";
    make_older(left);
    make_older(young.path());
    const ScratchFolder folder;
    mine = folder.path();
    EXPECT_FALSE(fs::exists(left));
    EXPECT_TRUE(fs::exists(young.path())) << "it is in use";
    EXPECT_TRUE(fs::exists(mine));
  }
  EXPECT_FALSE(fs::exists(mine));
  EXPECT_TRUE(fs::is_empty(where));
}

TEST(ScratchFolder, LeavesAloneWhatIsNotOne) {
  const fs::path where = fixtures::temp_folder() / "others";
  const TemporaryFiles there(where);
  const fs::path file = where / "murosimf_scratch.abcdef", other = where / "murosimf_scratch.notes",
                 link = where / "murosimf_scratch.ghijkl", outside = fixtures::temp_folder() / "outside";
  std::ofstream(file) << "a file";
  fs::create_directories(other);
  fs::create_directories(outside / "inside");
  fs::create_directory_symlink(outside, link);
  for (const fs::path& one : {file, other, outside}) make_older(one);
  {
    const ScratchFolder folder;
    EXPECT_NE(folder.path(), other);
  }
  for (const fs::path& one : {file, other, outside / "inside"}) EXPECT_TRUE(fs::exists(one)) << one;
  EXPECT_TRUE(fs::is_symlink(link));
}

}  // namespace
}  // namespace murosimf
