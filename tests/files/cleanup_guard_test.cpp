// Removal when a signal ends the program: registered files and children, nothing else.
#include "murosimf/files/cleanup_guard.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tests/temp_folder.h"

namespace murosimf::files {
namespace {

namespace fs = std::filesystem;

fs::path guarded_file(const std::string& name) {
  fs::path file = fixtures::temp_folder() / ("leftovers_test." + std::to_string(::getpid()) + "." + name);
  std::ofstream(file) << "half";
  return file;
}

TEST(CleanupGuards, FilesAreThereUntilTheyAreRemoved) {
  const fs::path half = guarded_file("half"), whole = guarded_file("whole");
  std::optional<CleanupGuard> noted(half), done(whole);
  done.reset();
  run_cleanup();
  EXPECT_FALSE(fs::exists(half));
  EXPECT_TRUE(fs::exists(whole)) << "the guard does not hold it any more";
  fs::remove(whole);
}

TEST(CleanupGuards, ChildrenEnd) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::pause();
    ::_exit(0);
  }
  const CleanupGuard noted(child);
  run_cleanup();
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
}

TEST(CleanupGuards, TooManyAreNoTrouble) {
  std::vector<std::unique_ptr<CleanupGuard>> many;
  for (int i = 0; i < 100; ++i) many.push_back(std::make_unique<CleanupGuard>(fs::path("/no/such/file")));
  EXPECT_NO_THROW(run_cleanup());
}

}  // namespace
}  // namespace murosimf::files
