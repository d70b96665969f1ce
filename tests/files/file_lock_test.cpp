// A file that is being written names its writer.
#include "murosimf/files/file_lock.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <string>

#include <gtest/gtest.h>

#include "tests/temp_folder.h"

namespace murosimf::files {
namespace {

int opened(const std::filesystem::path& file) { return ::open(file.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666); }

TEST(FileLock, NamesItsProcessAndEndsWithIt) {
  const auto file = fixtures::temp_folder() / "locked";
  std::array<int, 2> told{}, end{};
  ASSERT_EQ(::pipe(told.data()) + ::pipe(end.data()), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    char c = lock_file(opened(file)) ? 'y' : 'n';
    (void)!::write(told[1], &c, 1);
    (void)!::read(end[0], &c, 1);  // until it is killed
    ::_exit(0);
  }
  char c = 0;
  ASSERT_EQ(::read(told[0], &c, 1), 1);
  EXPECT_EQ(c, 'y');
  EXPECT_EQ(who_writes(file), "process " + std::to_string(child));
  const int mine = opened(file);
  EXPECT_FALSE(lock_file(mine));
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_EQ(who_writes(file), "");
  EXPECT_TRUE(lock_file(mine));
  ::close(mine);
  for (const int descriptor : {told[0], told[1], end[0], end[1]}) ::close(descriptor);
}

TEST(FileLock, HoldsWithinAProcessToo) {
  const auto file = fixtures::temp_folder() / "mine";
  const int first = opened(file), second = opened(file);
  EXPECT_TRUE(lock_file(first));
  EXPECT_FALSE(lock_file(second));
  EXPECT_EQ(who_writes(file), "process " + std::to_string(::getpid()));
  ::close(second);
  ::close(first);
  EXPECT_EQ(who_writes(file), "");
  EXPECT_EQ(who_writes(fixtures::temp_folder() / "none"), "");
}

}  // namespace
}  // namespace murosimf::files
