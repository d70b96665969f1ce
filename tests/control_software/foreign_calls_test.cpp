// Control software that would end the program, goes beyond its rows, or changes what belongs to the process: it is named, the rest goes on
// or ends in order, and what was changed is put back.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cfenv>
#include <clocale>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <locale>
#include <sstream>
#include <thread>

#include "murosimf/control_software/controller_task.h"
#include "murosimf/control_software/guard/guarded_call.h"
#include "murosimf/scene/scene.h"
#include "murosimf/scene/scene_report.h"
#include "tests/fixtures.h"
#include "tests/temp_folder.h"

namespace murosimf::control_software {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

const std::string controllers = MUROSIMF_CONTROLLERS "/";

scene::SceneOptions mischievous(const std::string& mischief, const std::string& where, double at = 0.5,
                                const std::string& library = "controller_mischief.so") {
  return {.overrides = {"walker.controller=library", "walker.library=" + controllers + library,
                        "walker.options.mischief=" + mischief, "walker.options.where=" + where,
                        "walker.options.at=" + std::to_string(at)},
          .cameras = false};
}

const SoftwareReport& software(const scene::Scene& scene) {
  return *software_report(scene.simulation().world().entity("walker"));
}

/// In a process of its own, which ends with 17 if the crash is told with its text.
[[noreturn]] void crash_and_leave(const scene::SceneOptions& options, const std::string& text) {
  try {
    scene::Scene scene("walk", options);
    scene.simulation().run(700ms);
    const auto state = scene.save();
    scene.load(state);
    scene.simulation().run(100ms);
  } catch (const SoftwareCrash& crash) {
    std::_Exit(fixtures::says(crash.what(), {text}) ? 17 : 18);
  } catch (const std::exception&) {
    std::_Exit(19);
  }
  std::_Exit(software_has_crashed() ? 17 : 20);  // its last words were those of its destroy
}

struct Mischief {
  const char *what, *where, *text;
};

std::string name_of(const testing::TestParamInfo<Mischief>& info) {
  std::string name = std::string(info.param.what) + "_in_" + info.param.where;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

// Heaps are often found to be damaged long after.
TEST(ForeignCalls, AreSuspectedOfCrashesElsewhere) {
  testing::GTEST_FLAG(death_test_style) = "threadsafe";
  const auto run = [] {
    scene::Scene scene("walk", mischievous("-", "-"));
    scene.simulation().run(100ms);
    (void)std::raise(SIGSEGV);
  };
  EXPECT_DEATH(run(),
               "murosimf: the program crashed .SIGSEGV. outside of all calls .*: library '.*controller_mischief.so'");
}

class EndsTheRun : public testing::TestWithParam<Mischief> {};

TEST_P(EndsTheRun, AndIsNamed) {
  testing::GTEST_FLAG(death_test_style) = "threadsafe";
  const auto [what, where, text] = GetParam();
  const std::string line = std::string("murosimf: library '.*controller_mischief.so' of walker: .*") + text;
  EXPECT_EXIT(crash_and_leave(mischievous(what, where), text), testing::ExitedWithCode(17), line);
}

INSTANTIATE_TEST_SUITE_P(
    Ends, EndsTheRun,
    testing::Values(
        Mischief{"exit", "step", "its step called exit"}, Mischief{"_exit", "step", "its step called _exit"},
        Mischief{"_Exit", "step", "its step called _Exit"},
        Mischief{"quick_exit", "step", "its step called quick_exit"}, Mischief{"err", "step", "its step called exit"},
        Mischief{"abort", "step", "its step crashed"}, Mischief{"terminate", "step", "its step called std::terminate"},
        Mischief{"noexcept", "step", "called std::terminate: left a function"},
        Mischief{"pthread_exit", "step", "its step called pthread_exit"},
        Mischief{"exit", "create", "its create called exit"}, Mischief{"segv", "create", "its create crashed"},
        Mischief{"exit", "start", "its start called exit"}, Mischief{"segv", "start", "its start crashed"},
        Mischief{"exit", "save", "its save called exit"}, Mischief{"segv", "load", "its load crashed"},
        Mischief{"segv", "destroy", "its destroy crashed"}, Mischief{"exit", "destroy", "its destroy called exit"}),
    name_of);
INSTANTIATE_TEST_SUITE_P(Threads, EndsTheRun,
                         testing::Values(Mischief{"thread_segv", "step", "a thread of its own crashed"},
                                         Mischief{"lost_thread_segv", "step", "a thread of its own crashed"},
                                         Mischief{"thread_exit", "step", "a thread of its own called exit"},
                                         Mischief{"thread_throws", "step",
                                                  "a thread of its own called std::terminate"}),
                         name_of);
INSTANTIATE_TEST_SUITE_P(
    Rows, EndsTheRun,
    testing::Values(Mischief{"one_beyond", "step", "went beyond the end of 'joint.target', which has 21 numbers"},
                    Mischief{"led_beyond", "step", "went beyond the end of 'robot.led', which has 3 numbers"},
                    Mischief{"far_beyond", "step", "went beyond the end of 'robot.led', which has 3 numbers"},
                    Mischief{"one_before", "step", "went before the beginning of 'joint.target', which has 21 numbers"},
                    Mischief{"far_before", "step", "before the beginning of 'joint.target', which has 21 numbers"},
                    Mischief{"count", "step", "went before the beginning of 'joint.target'"},
                    Mischief{"input", "step", "wrote to 'joint.position', which is to be read only"},
                    Mischief{"samples", "step", "wrote to 'joint.position', which is to be read only"},
                    Mischief{"error", "create", "its create went beyond the end of 'error', which has 1000 bytes"},
                    Mischief{"save_beyond", "-", "its save went beyond the end of 'bytes of its state'"},
                    Mischief{"load_input", "-", "its load wrote to 'bytes of its state', which is to be read only"}),
    name_of);

// No robot is known yet, or none any more.
TEST(ForeignCalls, AreGuardedWhenALibraryIsLoadedAndUnloaded) {
  testing::GTEST_FLAG(death_test_style) = "threadsafe";
  const auto run = [](const std::string& library, const std::string& text) {
    crash_and_leave(mischievous("-", "-", 0, library), text);
  };
  EXPECT_EXIT(run("controller_loading_exit.so", "its loading called exit(0)"), testing::ExitedWithCode(17),
              "library '.*controller_loading_exit.so': its loading called exit.0.; the run ends here");
  EXPECT_EXIT(run("controller_loading_segv.so", "its loading crashed (SIGSEGV)"), testing::ExitedWithCode(17),
              "controller_loading_segv.so': its loading crashed .SIGSEGV.; the run ends here");
  EXPECT_EXIT(run("controller_entry_segv.so", "its murosimf_controller_entry crashed"), testing::ExitedWithCode(17),
              "controller_entry_segv.so': its murosimf_controller_entry crashed .SIGSEGV.");
  EXPECT_EXIT(run("controller_unloading_segv.so", ""), testing::ExitedWithCode(17),
              "controller_unloading_segv.so': its unloading crashed .SIGSEGV.");
}

// Children of software are no business of the simulator's; one that comes back from the call is ended, or there would be two simulations.
TEST(ForeignCalls, MayBeginProcesses) {
  const fs::path file = fixtures::temp_folder() / ("children_" + std::to_string(::getpid()));
  for (const std::string mischief : {"child_exits", "child_comes_back", "system"}) {
    scene::Scene scene("walk", mischievous(mischief, "step"));
    scene.simulation().run(700ms);
    std::ofstream(file, std::ios::app) << mischief << "\n";
    EXPECT_EQ(software(scene).ended, "");
    EXPECT_EQ(scene.simulation().now(), Duration(700ms));
  }
  while (::waitpid(-1, nullptr, 0) > 0) continue;
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  EXPECT_EQ(text.str(), "child_exits\nchild_comes_back\nsystem\n");
  EXPECT_FALSE(software_has_crashed());
  fs::remove(file);
}

TEST(ForeignCalls, MayBeginAndEndThreads) {
  scene::Scene scene("walk", mischievous("good_thread", "-"));
  scene.simulation().run(100ms);
  EXPECT_EQ(software(scene).ended, "");
  EXPECT_FALSE(software_has_crashed());
}

struct Process {
  std::string folder = fs::current_path().string();
  mode_t mask = look_at_mask();
  void (*on_interrupt)(int) = handler(SIGINT);
  void (*on_crash)(int) = handler(SIGSEGV);
  std::string c_locale = std::setlocale(LC_ALL, nullptr);
  locale_t thread_locale = ::uselocale(nullptr);
  std::locale locale;
  std::string numeric = std::getenv("LC_NUMERIC") ? std::getenv("LC_NUMERIC") : "";
  bool blocked = is_blocked(), has_stack = has_signal_stack(), has_timer = timer_runs();
  int rounding = std::fegetround(), traps = fegetexcept();
  double tiny = 1e-200 * scale * 1e-110, third = 1 / (3 * scale);
  ino_t output = file(STDOUT_FILENO);
  std::terminate_handler terminate = std::get_terminate();

  friend bool operator==(const Process&, const Process&) = default;

 private:
  static inline volatile double scale = 1;
  static mode_t look_at_mask() {
    const mode_t mask = ::umask(0);
    ::umask(mask);
    return mask;
  }
  static void (*handler(int signal))(int) {
    struct sigaction action {};
    ::sigaction(signal, nullptr, &action);
    return action.sa_handler;
  }
  static bool is_blocked() {
    sigset_t set;
    ::pthread_sigmask(SIG_SETMASK, nullptr, &set);
    return sigismember(&set, SIGUSR1) == 1;
  }
  static bool has_signal_stack() {
    stack_t stack{};
    ::sigaltstack(nullptr, &stack);
    return (stack.ss_flags & SS_DISABLE) == 0;
  }
  static bool timer_runs() {
    itimerval timer{};
    ::getitimer(ITIMER_REAL, &timer);
    return timer.it_value.tv_sec != 0;
  }
  static ino_t file(int descriptor) {
    struct stat status {};
    return ::fstat(descriptor, &status) == 0 ? status.st_ino : 0;
  }
};

class IsPutBack : public testing::TestWithParam<Mischief> {};

TEST_P(IsPutBack, AndCountedInTheReport) {
  const auto [what, where, text] = GetParam();
  {
    const scene::Scene first("walk", mischievous("-", "-"));
  }  // handlers and stacks of the guard are there from now on
  const Process before;
  scene::SceneOptions options = mischievous(what, where, std::string(where) == "step" ? 0.5 : 0);
  if (std::string(where) == "step") options.overrides.emplace_back("walker.options.many=3");
  scene::Scene scene("walk", options);
  scene.simulation().run(700ms);
  const Process after;
  EXPECT_EQ(after, before);
  ASSERT_EQ(software(scene).changed.size(), 1U);
  const auto& changed = software(scene).changed[0];
  EXPECT_EQ(changed.what, text);
  EXPECT_EQ(changed.times, std::string(where) == "step" ? 3U : 1U);
  EXPECT_EQ(changed.first, std::string(where) == "step" ? Duration(500ms) : Duration{});
  EXPECT_EQ(software(scene).ended, "");
  const auto warnings = scene::make_report(scene, 1s, {}).warnings;
  const auto names = [&](const std::string& line) { return line.find(text) != std::string::npos; };
  EXPECT_EQ(std::count_if(warnings.begin(), warnings.end(), names), 1);
}

std::vector<Mischief> changes() {
  std::vector<Mischief> all;
  for (const char* where : {"step", "create", "start"}) {
    all.insert(all.end(), {
      {"rounding", where, "the rounding mode"}, {"traps", where, "floating-point traps"},
#if defined(__x86_64__)
          {"tiny", where, "what becomes of tiny numbers"}, {"x87", where, "the rounding mode"},
#endif
          {"sigmask", where, "the signal mask"}, {"sigaltstack", where, "the stack of signal handlers"},
          {"uselocale", where, "the locale"}, {"setlocale", where, "the locale"}, {"locale", where, "the locale"},
          {"chdir", where, "the working directory"}, {"umask", where, "the umask"},
          {"signal", where, "signal handlers"}, {"sigaction", where, "signal handlers"},
          {"timer", where, "a timer of the process"}, {"setenv", where, "the environment"},
          {"close", where, "standard input, output or errors"}, {"dup2", where, "standard input, output or errors"},
          {"fclose", where, "standard input, output or errors"}, {
        "set_terminate", where, "the terminate handler"
      }
    });
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Changes, IsPutBack, testing::ValuesIn(changes()), name_of);

std::uint64_t hash_with(const std::string& mischief, int threads) {
  scene::SceneOptions options;
  options.threads = threads;
  for (const std::string robot : {"blue1", "blue2", "blue3", "red1", "red2", "red3"}) {
    options.overrides.push_back(robot + ".level=articulated_dynamics");
    options.overrides.push_back(robot + ".controller=library");
    options.overrides.push_back(robot + ".library=" + controllers + "controller_mischief.so");
  }
  options.overrides.insert(options.overrides.end(), {"blue2.options.mischief=" + mischief, "blue2.options.where=step",
                                                     "blue2.options.at=0.1", "blue2.options.many=1000"});
  scene::Scene scene("three_on_three", options);
  scene.simulation().run(400ms);
  return scene.simulation().state_hash();
}

TEST(ForeignCalls, DoNotChangeHowOthersRound) {
  const std::uint64_t as_it_should_be = hash_with("-", 1);
  for (const std::string mischief : {"rounding", "tiny"}) {
    for (const int threads : {1, 2, 3}) EXPECT_EQ(hash_with(mischief, threads), as_it_should_be) << mischief << threads;
  }
}

// What the program that embeds the simulation has set, or a call that it has asked for, does not matter either, and stays for it.
TEST(ForeignCalls, RoundAsUsualInProgramsThatDoNot) {
  const auto hash = [](int threads, bool by_call) {
    scene::Scene scene("three_on_three", {.threads = threads, .overrides = {"red1.level=articulated_dynamics"}});
    if (by_call) scene.simulation().at(100ms, [] { std::fesetround(FE_UPWARD); });
    scene.simulation().run(300ms);
    return scene.simulation().state_hash();
  };
  const std::uint64_t as_it_should_be = hash(1, false);
  EXPECT_EQ(hash(2, true), as_it_should_be);
  EXPECT_EQ(std::fegetround(), FE_TONEAREST);
  scene::Scene scene("three_on_three", {.threads = 2, .overrides = {"red1.level=articulated_dynamics"}});
  std::fesetround(FE_DOWNWARD);
  scene.simulation().run(300ms);
  EXPECT_EQ(std::fegetround(), FE_DOWNWARD);
  std::fesetround(FE_TONEAREST);
  EXPECT_EQ(scene.simulation().state_hash(), as_it_should_be);
}

/// As cp, scp and rsync --inplace do: into the file that is there.
void overwrite(const std::string& bytes, const fs::path& to, std::ios::openmode mode = std::ios::trunc) {
  std::ofstream(to, std::ios::binary | mode) << bytes;
}

std::string bytes_of(const std::string& library) {
  std::ifstream file(controllers + library, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

double head_target(const scene::Scene& scene) {
  return scene.simulation().world().entity("walker").object("j_head").get(properties::joint_target);
}

class OverwrittenLibrary : public testing::Test {
 protected:
  OverwrittenLibrary() {
    overwrite(first, file);
    scene.emplace("walk", scene::SceneOptions{.overrides = {"walker.controller=library",
                                                            "walker.library=" + file.string(), "walker.reload=true"},
                                              .cameras = false});
    scene->simulation().run(200ms);
  }
  ~OverwrittenLibrary() override { fs::remove(file); }

  /// Until it has said so much, or the wall time has passed.
  void wait(std::chrono::milliseconds time, std::size_t said) {
    const auto end = std::chrono::steady_clock::now() + time;
    while (std::chrono::steady_clock::now() < end && software(*scene).said.size() < said) {
      scene->simulation().run(20ms);
      std::this_thread::sleep_for(10ms);
    }
  }

  const std::string first = bytes_of("controller_1.so"), second = bytes_of("controller_2.so");
  const fs::path file = fixtures::temp_folder() / ("overwritten_" + std::to_string(::getpid()) + ".so");
  std::optional<scene::Scene> scene;
};

TEST_F(OverwrittenLibrary, IsExchanged) {
  overwrite(second, file);
  wait(20s, 1);
  ASSERT_EQ(software(*scene).said.size(), 1U);
  EXPECT_EQ(software(*scene).said[0].text, "the library was loaded anew and goes on");
  scene->simulation().run(100ms);
  EXPECT_NEAR(head_target(*scene), 0.2, 0.0501);
}

TEST_F(OverwrittenLibrary, MayBeEmptyHalfOrOpenForAWhile) {
  overwrite("", file);
  wait(1s, 1);
  overwrite(second.substr(0, second.size() / 2), file);
  wait(1s, 1);
  EXPECT_TRUE(software(*scene).said.empty());
  EXPECT_NEAR(head_target(*scene), 0.1, 0.0501);
  std::ofstream slow(file, std::ios::binary | std::ios::app);
  slow << second.substr(second.size() / 2) << std::flush;
  wait(1s, 1);
  EXPECT_TRUE(software(*scene).said.empty()) << "whole, but open for writing";
  slow.close();
  wait(20s, 1);
  ASSERT_EQ(software(*scene).said.size(), 1U);
  EXPECT_EQ(software(*scene).said[0].text, "the library was loaded anew and goes on");
}

TEST_F(OverwrittenLibrary, ThatIsNoneLeavesTheOldOne) {
  overwrite("no library", file);
  wait(20s, 1);
  ASSERT_EQ(software(*scene).said.size(), 1U);
  EXPECT_TRUE(fixtures::says(software(*scene).said[0].text, {"was not loaded anew", "cannot be loaded"}));
  scene->simulation().run(100ms);
  EXPECT_NEAR(head_target(*scene), 0.1, 0.0501);
}

TEST_F(OverwrittenLibrary, LeavesNoCopyBesideIt) {
  for (const auto& entry : fs::directory_iterator(file.parent_path())) {
    EXPECT_EQ(entry.path().string().find(".murosimf-"), std::string::npos) << entry.path();
  }
}

TEST(ForeignCalls, OfAHalfLibraryAreRefused) {
  const fs::path file = fixtures::temp_folder() / ("half_" + std::to_string(::getpid()) + ".so");
  for (const std::string& bytes : {std::string(), bytes_of("controller_1.so").substr(0, 5000)}) {
    overwrite(bytes, file);
    const std::string message = fixtures::error_of([&] {
      scene::Scene scene("walk", {.overrides = {"walker.controller=library", "walker.library=" + file.string()}});
    });
    EXPECT_TRUE(fixtures::says(message, {file.string(), "is not whole"})) << message;
  }
  fs::remove(file);
}

}  // namespace
}  // namespace murosimf::control_software
