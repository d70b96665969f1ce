// What grows harms nothing that was there, and belongs to one run.
#include "murosimf/recording/mcap/growing_file.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "tests/fixtures.h"
#include "tests/temp_folder.h"

namespace murosimf::recording {
namespace {

namespace fs = std::filesystem;
using fixtures::error_of;

class GrowingFiles : public testing::Test {
 protected:
  [[nodiscard]] fs::path at(const std::string& name) const { return folder_.path() / name; }
  [[nodiscard]] fs::path file() const { return at("game.mcap"); }
  [[nodiscard]] std::string text(const std::string& name) const {
    std::stringstream all;
    all << std::ifstream(at(name)).rdbuf();
    return all.str();
  }
  [[nodiscard]] std::ptrdiff_t files() const {
    return std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator());
  }
  /// In a process of its own, which is killed after that.
  template <class Call>
  void killed_after(const Call& call) const {
    const pid_t child = ::fork();
    if (child == 0) {
      call();
      ::kill(::getpid(), SIGKILL);
    }
    ::waitpid(child, nullptr, 0);
  }
  fixtures::TempFolder folder_;
};

TEST_F(GrowingFiles, LeaveNothingBeforeTheyBegin) {
  {
    GrowingFile growing(file());
    growing.append("piece");
    EXPECT_FALSE(fs::exists(file()));
  }
  EXPECT_EQ(files(), 0);
  std::ofstream(file()) << "old";
  GrowingFile(file()).append("piece");
  EXPECT_EQ(text("game.mcap"), "old");
  EXPECT_EQ(files(), 1);
}

TEST_F(GrowingFiles, HaveTheirNameWhereItIsFree) {
  GrowingFile growing(file());
  growing.append("one,");
  growing.begin();
  growing.append("two");
  EXPECT_EQ(text("game.mcap"), "one,two");
  EXPECT_EQ(growing.grows_at(), fs::canonical(file()));
  EXPECT_EQ(growing.size(), 7U);
  growing.finish();
  EXPECT_EQ(text("game.mcap"), "one,two");
  EXPECT_EQ(files(), 1);
}

TEST_F(GrowingFiles, GrowBesideAnOlderOne) {
  std::ofstream(file()) << "old";
  GrowingFile growing(file());
  growing.begin();
  growing.append("new");
  EXPECT_EQ(text("game.mcap"), "old");
  EXPECT_EQ(text("game.mcap.part"), "new");
  growing.finish();
  EXPECT_EQ(text("game.mcap"), "new");
  EXPECT_EQ(files(), 1);
}

TEST_F(GrowingFiles, AreReleasedWhenTheyAreComplete) {
  GrowingFile growing(file());
  growing.append("first");
  growing.finish();
  growing.finish();  // once more changes nothing
  GrowingFile another(file());
  another.append("second");
  another.finish();
  EXPECT_EQ(text("game.mcap"), "second");
  EXPECT_EQ(files(), 1);
}

TEST_F(GrowingFiles, WithoutEndStayWhereTheyAre) {
  std::ofstream(file()) << "old";
  {
    GrowingFile growing(file());
    growing.begin();
    growing.append("cut off");
  }
  EXPECT_EQ(text("game.mcap"), "old");
  EXPECT_EQ(text("game.mcap.part"), "cut off");
  EXPECT_TRUE(fixtures::says(part_diagnostic(file()), {"game.mcap.part", "did not come to its end"}));
}

TEST_F(GrowingFiles, BelongToOneRun) {
  for (const bool old : {false, true}) {
    if (old) std::ofstream(file()) << "old";
    std::array<int, 2> told{};
    ASSERT_EQ(::pipe(told.data()), 0);
    const pid_t child = ::fork();
    if (child == 0) {
      GrowingFile growing(file());
      growing.begin();
      growing.append("first");
      (void)!::write(told[1], "!", 1);
      for (;;) ::pause();
    }
    char c = 0;
    ASSERT_EQ(::read(told[0], &c, 1), 1);
    const std::string holder = "process " + std::to_string(child);
    EXPECT_EQ(error_of([&] { GrowingFile{file()}; }),
              "cannot write '" + file().string() + "': it is being written by " + holder);
    EXPECT_TRUE(fixtures::says(part_diagnostic(file()), {holder}));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    EXPECT_EQ(text("game.mcap"), old ? "old" : "first");
    EXPECT_EQ(text("game.mcap.part"), old ? "first" : "");
    for (const auto& entry : fs::directory_iterator(folder_.path())) fs::remove(entry);
    for (const int descriptor : told) ::close(descriptor);
  }
  const GrowingFile one(file());
  EXPECT_TRUE(fixtures::says(error_of([&] { GrowingFile{file()}; }), {"being written by process"})) << "in one process";
}

TEST_F(GrowingFiles, KeepWhatAKilledRunHasLeft) {
  std::ofstream(file()) << "old";
  for (const std::string piece : {"first", "second"}) {
    killed_after([&] {
      GrowingFile growing(file());
      growing.begin();
      growing.append(piece);
    });
  }
  EXPECT_EQ(text("game.cut_off_1.mcap"), "first");
  EXPECT_EQ(text("game.mcap.part"), "second");
  { GrowingFile(file()).append("never begun"); }
  EXPECT_EQ(text("game.mcap.part"), "second");
  GrowingFile growing(file());
  growing.begin();
  growing.append("third");
  growing.finish();
  EXPECT_EQ(growing.set_aside().filename(), "game.cut_off_2.mcap");
  EXPECT_EQ(text("game.cut_off_2.mcap"), "second");
  EXPECT_EQ(text("game.mcap"), "third");
  EXPECT_EQ(files(), 3);
}

// One that was killed before it began has left an empty part.
TEST_F(GrowingFiles, EmptyPartsAreNothing) {
  killed_after([&] { GrowingFile(file()).append("memory"), ::kill(::getpid(), SIGKILL); });
  killed_after([&] {
    const GrowingFile growing(file());
    ::kill(::getpid(), SIGKILL);
  });
  EXPECT_EQ(part_diagnostic(file()), "");
  GrowingFile growing(file());
  growing.append("all");
  growing.finish();
  EXPECT_EQ(growing.set_aside(), "");
  EXPECT_EQ(text("game.mcap"), "all");
  EXPECT_EQ(files(), 1);
}

// As on a full disk: whole pieces stay, and more of them are refused.
TEST_F(GrowingFiles, KeepWholePiecesWithoutSpace) {
  const pid_t child = ::fork();
  if (child == 0) {
    (void)std::signal(SIGXFSZ, SIG_IGN);
    const rlimit few{10, 10};
    ::setrlimit(RLIMIT_FSIZE, &few);
    GrowingFile growing(file());
    growing.begin();
    growing.append("1234567");
    const bool refused = fixtures::says(error_of([&] { growing.append("89abcdef"); }), {"cannot write", "too large"});
    ::_exit(refused ? 0 : 1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  EXPECT_EQ(text("game.mcap"), "1234567");
}

}  // namespace
}  // namespace murosimf::recording
