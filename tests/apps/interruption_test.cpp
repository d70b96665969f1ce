// Ctrl-C, SIGTERM and SIGHUP from outside: what a command still writes, how it ends, and what it leaves behind.
#include <fcntl.h>
#include <pty.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <functional>
#include <thread>

#include "tests/apps/folder.h"
#include "tests/apps/program.h"

namespace murosimf::test {
namespace {

using namespace std::chrono_literals;

constexpr const char* two_robots =
    "rate = 1000\n[[robots]]\nname = 'one'\nmodel = 'kid21'\ncommand = [0.2, 0, 0]\n"
    "[[robots]]\nname = 'two'\nmodel = 'kid21'\nposition = [0, 1]\n[robots.sensors.camera]\nwidth = 64\nheight = 48\n";

/// The program with a terminal of its own for its errors; standard output goes to a file.
class OnTerminal {
 public:
  explicit OnTerminal(const std::string& arguments, const std::string& environment = {}) : out_(scratch("out")) {
    const std::string command = environment + " exec " + MUROSIMF_PROGRAM + " " + arguments + " >" + out_.string();
    pid_ = forkpty(&terminal_, nullptr, nullptr, nullptr);
    if (pid_ == 0) {
      execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
      _exit(127);
    }
  }
  ~OnTerminal() {
    if (pid_ > 0) kill(pid_, SIGKILL);
    if (pid_ > 0) waitpid(pid_, nullptr, 0);
    close(terminal_);
  }
  OnTerminal(const OnTerminal&) = delete;
  OnTerminal& operator=(const OnTerminal&) = delete;

  [[nodiscard]] bool there() const { return pid_ > 0; }
  /// Reads what it shows until `text` is there. False if the program has ended before.
  bool wait_for(const std::string& text) {
    while (shown_.find(text) == std::string::npos) {
      if (!read_some()) return false;
    }
    return true;
  }
  void send(int signal) const { kill(pid_, signal); }
  /// As a user does it: the terminal sends a signal to all programs in its foreground.
  void type_control_c() const { (void)!::write(terminal_, "\x03", 1); }

  /// Takes the terminal away, as a window that is closed does. SIGHUP comes from the system.
  void hang_up() {
    close(terminal_);
    terminal_ = -1;
  }

  /// As waitpid has it.
  int wait() {
    while (read_some()) {
    }
    int status = 0;
    waitpid(pid_, &status, 0);
    pid_ = -1;
    return status;
  }
  int exit_code() {
    const int status = wait();
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  [[nodiscard]] std::string output() const { return read_file(out_); }
  [[nodiscard]] const std::string& shown() const { return shown_; }

 private:
  bool read_some() {
    std::array<char, 4096> buffer{};
    const auto count = ::read(terminal_, buffer.data(), buffer.size());
    if (count <= 0) return false;  // a terminal without programs is an error
    shown_.append(buffer.data(), static_cast<std::size_t>(count));
    return true;
  }

  fs::path out_;
  int terminal_ = -1;
  pid_t pid_ = -1;
  std::string shown_;
};

class Interruption : public InFolder {
 protected:
  void SetUp() override { scene_ = write("scene.toml", two_robots).string(); }
  std::string scene_;
};

/// False if it does not happen in a minute.
bool happens(const std::function<bool()>& what) {
  for (int i = 0; i < 12000 && !what(); ++i) std::this_thread::sleep_for(5ms);
  return what();
}

bool comes(const std::string& file) {
  return happens([&] { return fs::exists(file); });
}

void expect_in(const std::string& text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) EXPECT_NE(text.find(part), std::string::npos) << part << " in: " << text;
}

TEST_F(Interruption, ARunWritesAllItHas) {
  OnTerminal program("run " + scene_ + " --duration 1e6 --no-cameras --json " + file("r.json") + " --picture " +
                     file("p.png") + " --log 'one.imu.*' --out " + file("l.csv"));
  ASSERT_TRUE(program.wait_for("of 1000000.0 s")) << program.shown();
  program.type_control_c();
  EXPECT_EQ(program.exit_code(), 130) << program.shown();
  expect_in(program.output(), {"stopped by SIGINT at ", " s of 1000000.000 s"});
  expect_in(read_file(file("r.json")), {"\"by\": \"SIGINT\"", "\"asked_s\": 1000000.0", "\"time_s\": "});
  EXPECT_EQ(files(), (std::vector<std::string>{"l.csv", "p.png", "r.json"})) << "no .part";
  EXPECT_EQ(program.shown().find("stopped"), std::string::npos) << "the report says it";
}

TEST_F(Interruption, EverySignalHasItsExitCode) {
  for (const auto& [signal, code] : {std::pair{SIGTERM, 143}, std::pair{SIGHUP, 129}}) {
    OnTerminal program("run " + scene_ + " --duration 1e6 --no-cameras");
    ASSERT_TRUE(program.wait_for("of 1000000.0 s")) << program.shown();
    program.send(signal);
    EXPECT_EQ(program.exit_code(), code) << program.shown();
    expect_in(program.output(), {signal == SIGTERM ? "stopped by SIGTERM at " : "stopped by SIGHUP at "});
  }
}

TEST_F(Interruption, ATerminalThatGoesAwayTakesNothingWithIt) {
  OnTerminal program("run " + scene_ + " --duration 1e6 --no-cameras --json " + file("r.json") + " --picture " +
                     file("p.png"));
  ASSERT_TRUE(program.wait_for("of 1000000.0 s")) << program.shown();
  program.hang_up();
  EXPECT_EQ(program.exit_code(), 129);
  expect_in(read_file(file("r.json")), {"\"by\": \"SIGHUP\""});
  EXPECT_EQ(files(), (std::vector<std::string>{"p.png", "r.json"}));
}

// As `timeout` does it.
TEST_F(Interruption, TwoAtOnceAreOne) {
  OnTerminal program("run " + scene_ + " --duration 1e6 --no-cameras");
  ASSERT_TRUE(program.wait_for("of 1000000.0 s")) << program.shown();
  program.send(SIGTERM);
  program.send(SIGTERM);
  EXPECT_EQ(program.exit_code(), 143) << program.shown();
}

// A step of 1 ms lasts a thousand seconds; there is nothing on the terminal by which its beginning shows.
TEST_F(Interruption, AStepIsNotWaitedFor) {
  const Result drawn = murosimf("run " + scene_ + " --duration 0 --no-cameras --pictures " + file("drawn"));
  if (drawn.exit_code != 0) GTEST_SKIP() << drawn.errors;
  OnTerminal program("run " + scene_ + " --speed 1e-6 --no-cameras --pictures " + file("p") + " --picture-every 1");
  ASSERT_TRUE(comes(file("p/0000.png"))) << program.shown();
  program.send(SIGINT);
  EXPECT_EQ(program.exit_code(), 130) << program.shown();
}

TEST_F(Interruption, ARunThatIsOverIsNotMarked) {
  const Result result = murosimf("run " + scene_ + " --duration 0.01 --no-cameras --json -");
  EXPECT_EQ(result.exit_code, 0);
  expect_in(result.output, {"\"stopped\": null"});
}

TEST_F(Interruption, ProgressSaysHowMuchTimeIsLeft) {
  OnTerminal program("run " + scene_ + " --duration 1 --speed 1 --no-cameras");
  EXPECT_TRUE(program.wait_for("s left")) << program.shown();
  EXPECT_EQ(program.exit_code(), 0);
}

TEST_F(Interruption, ProgressSaysHowFastTimeGoesBy) {
  OnTerminal program("run " + scene_ + " --duration 1e6 --no-cameras --speed 3");
  ASSERT_TRUE(program.wait_for(" times real time")) << program.shown();
  program.send(SIGTERM);
  EXPECT_EQ(program.exit_code(), 143) << program.shown();
}

TEST_F(Interruption, ComparisonsShowWhatHadEnded) {
  OnTerminal program("compare " + scene_ + " --entity one --duration 0.02 --repeat 1000 --json " + file("c.json"));
  ASSERT_TRUE(program.wait_for("timing ")) << program.shown();
  program.send(SIGINT);
  EXPECT_EQ(program.exit_code(), 130) << program.shown();
  expect_in(program.shown(), {"stopped by SIGINT"});
  expect_in(program.output(), {"full_dynamics", "nothing can be said: the comparison was stopped"});
  expect_in(read_file(file("c.json")), {"\"stopped\": true"});
}

TEST_F(Interruption, ABenchmarkKeepsTheScenesItHasDone) {
  OnTerminal program("bench collision --json " + file("b.json"));
  ASSERT_TRUE(program.wait_for("] duel")) << program.shown();
  program.send(SIGINT);
  EXPECT_EQ(program.exit_code(), 130) << program.shown();
  expect_in(program.shown(), {"stopped by SIGINT after 0 of 5 scenes"});
  EXPECT_EQ(files(), (std::vector<std::string>{"b.json"}));
}

/// A servo at one place.
std::string long_log() {
  std::string text =
      "{\"mass\": 0.5, \"length\": 0.1, \"arm_mass\": 0.05, \"kp\": 400, \"vin\": 7.4, \"motor\": \"xl330\",\n"
      "\"trajectory\": \"sin_time_square\", \"entries\": [";
  for (int i = 0; i < 1000; ++i) {
    if (i > 0) text += ",\n";
    text += "{\"timestamp\": " + std::to_string(0.01 * i) +
            ", \"position\": 0.01, \"speed\": 0, \"input_volts\": 7.4, " +
            "\"goal_position\": " + (i < 20 ? "0.0" : "0.6") + ", \"torque_enable\": true}";
  }
  return text + "]}";
}

TEST_F(Interruption, AFitWritesTheBestSoFar) {
  const std::string log = write("log.json", long_log()).string();
  OnTerminal program("fit-servo " + log + " --model m6 --starts 1000 --threads 1 --json " + file("f.json") + " --out " +
                     file("s.toml"));
  if (!program.wait_for("mrad")) {
    expect_in(program.shown(), {"NLopt was missing"});
    GTEST_SKIP() << "no NLopt in this build";
  }
  program.send(SIGINT);
  EXPECT_EQ(program.exit_code(), 130) << program.shown();
  expect_in(program.shown(), {"stopped by SIGINT; ", "s.toml' is the best so far"});
  expect_in(read_file(file("f.json")), {"\"stopped\": true"});
  EXPECT_EQ(files(), (std::vector<std::string>{"f.json", "s.toml"}));
}

class InterruptedVideo : public Interruption {
 protected:
  [[nodiscard]] std::string render(const std::string& video) const {
    return "render " + scene_ + " --size 64x48 --duration 1e6 --video " + video;
  }
  static bool cannot_draw(const OnTerminal& program) {
    return program.shown().find("cannot draw") != std::string::npos ||
           program.shown().find("OpenGL") != std::string::npos;
  }
};

TEST_F(InterruptedVideo, EndsWhereItIs) {
  if (std::system("ffmpeg -version >/dev/null 2>&1") != 0) GTEST_SKIP() << "no ffmpeg here";
  OnTerminal program(render(file("v.mp4")));
  if (!program.wait_for("of 1000000.00 s") && cannot_draw(program)) GTEST_SKIP() << program.shown();
  const auto has_bytes = [&] { return !files().empty() && fs::file_size(folder() / files().front()) > 0; };
  ASSERT_TRUE(happens(has_bytes)) << "ffmpeg has had a picture: it makes the file before";
  program.type_control_c();  // reaches ffmpeg, too, if that were in the foreground
  EXPECT_EQ(program.exit_code(), 130) << program.shown();
  expect_in(program.shown(), {"stopped by SIGINT at ", "v.mp4' ends there"});
  EXPECT_EQ(files(), (std::vector<std::string>{"v.mp4"}));
  EXPECT_EQ(read_file(file("v.mp4")).substr(4, 4), "ftyp");
}

TEST_F(InterruptedVideo, ASecondSignalEndsTheProgramAndItsChildrenAtOnce) {
  const std::string path =
      path_with_ffmpeg(folder() / "bin", "for f; do :; done\ntouch \"${f#file:}\"\necho $$ >" + file("pid") +
                                             "\ncat >/dev/null\ntouch " + file("ended") + "\nexec sleep 1000\n");
  OnTerminal program(render(file("v.mp4")), "PATH='" + path + "'");
  if (!program.wait_for("of 1000000.00 s") && cannot_draw(program)) GTEST_SKIP() << program.shown();
  ASSERT_TRUE(comes(file("pid"))) << "a child has begun";
  program.send(SIGINT);
  ASSERT_TRUE(comes(file("ended"))) << program.shown();  // now it waits for the child
  std::this_thread::sleep_for(150ms);                    // before, it would be the same signal
  program.send(SIGINT);
  const int status = program.wait();
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGINT) << status;
  EXPECT_EQ(files(), (std::vector<std::string>{"bin", "ended", "pid"})) << "nothing half is left";
  const pid_t child = std::stoi(read_file(file("pid")));
  while (kill(child, 0) == 0 &&
         read_file("/proc/" + std::to_string(child) + "/stat").find(") Z") == std::string::npos) {
    std::this_thread::sleep_for(5ms);
  }
}

// A command that has nothing to save ends as if nobody caught the signal.
TEST_F(Interruption, ShortCommandsEndAtOnce) {
  const std::string path =
      path_with_program(folder() / "bin", "gnuplot", "touch " + file("begun") + "\nexec sleep 1000\n");
  const std::string table = write("t.csv", "time [s],a\n0,1\n1,2\n").string();
  OnTerminal program("plot " + table + " --out " + file("t.png"), "PATH='" + path + "'");
  ASSERT_TRUE(comes(file("begun"))) << program.shown();
  program.send(SIGTERM);
  const int status = program.wait();
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGTERM) << status;
  EXPECT_EQ(files(), (std::vector<std::string>{"begun", "bin"}));
}

}  // namespace
}  // namespace murosimf::test
