// What is taken away when a signal ends the program: noted files and children, nothing else.
#include "murosimf/files/leftovers.h"

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

fs::path leftover_file(const std::string& name) {
  fs::path file = fixtures::temp_folder() / ("leftovers_test." + std::to_string(::getpid()) + "." + name);
  std::ofstream(file) << "half";
  return file;
}

TEST(Leftovers, FilesAreThereUntilTheyAreRemoved) {
  const fs::path half = leftover_file("half"), whole = leftover_file("whole");
  std::optional<Leftover> noted(half), done(whole);
  done.reset();
  remove_leftovers();
  EXPECT_FALSE(fs::exists(half));
  EXPECT_TRUE(fs::exists(whole)) << "it is nobody's leftover any more";
  fs::remove(whole);
}

TEST(Leftovers, ChildrenEnd) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::pause();
    ::_exit(0);
  }
  const Leftover noted(child);
  remove_leftovers();
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
}

TEST(Leftovers, TooManyAreNoTrouble) {
  std::vector<std::unique_ptr<Leftover>> many;
  for (int i = 0; i < 100; ++i) many.push_back(std::make_unique<Leftover>(fs::path("/no/such/file")));
  EXPECT_NO_THROW(remove_leftovers());
}

}  // namespace
}  // namespace murosimf::files
