// No command destroys a file: not one that it reads, not one of a run that does not start, not one that another run writes.
#include <arpa/inet.h>
#include <sys/socket.h>

#include <csignal>
#include <functional>
#include <map>
#include <thread>

#include "tests/apps/folder.h"
#include "tests/apps/program.h"

namespace murosimf::test {
namespace {

using namespace std::chrono_literals;

/// Of this computer, where somebody listens already.
class TakenPort {
 public:
  TakenPort() : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    EXPECT_EQ(::bind(socket_, reinterpret_cast<sockaddr*>(&address), size) + ::listen(socket_, 1), 0);
    EXPECT_EQ(::getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size), 0);
    number_ = std::to_string(ntohs(address.sin_port));
  }
  ~TakenPort() { ::close(socket_); }
  TakenPort(const TakenPort&) = delete;
  TakenPort& operator=(const TakenPort&) = delete;
  [[nodiscard]] const std::string& number() const { return number_; }

 private:
  int socket_;
  std::string number_;
};

class Outputs : public InFolder {
 protected:
  static std::string in(const std::string& text, const fs::path& folder) {
    std::string command;
    for (const char c : text) command += c == '@' ? folder.string() + "/" : std::string(1, c);
    return command;
  }
  [[nodiscard]] std::string in_folder(const std::string& text) const { return in(text, folder()); }
  /// By name: what shows that a file is another one.
  [[nodiscard]] std::map<std::string, std::size_t> all() const {
    std::map<std::string, std::size_t> contents;
    for (const std::string& name : files()) {
      if (fs::is_regular_file(file(name))) contents[name] = std::hash<std::string>{}(read_file(file(name)));
    }
    return contents;
  }
  void make_inputs() const {
    const fs::path source = MUROSIMF_SOURCE_DIR;
    fs::copy_file(source / "scenes/walk.toml", file("walk.toml"));
    fs::copy_file(source / "models/kid21.xml", file("kid21.xml"));
    fs::copy_file(source / "models/kid21.toml", file("kid21.toml"));
    ASSERT_EQ(murosimf(in_folder("run walk --duration 1 --record @in.mcap --log walker.* --out @in.csv --save-state "
                                 "@in.state --log-rate 10"))
                  .exit_code,
              0);
    fs::remove(file("in.foxglove.json"));
    fs::create_symlink(file("in.mcap"), file("soft.mcap"));
    fs::create_hard_link(file("in.mcap"), file("hard.mcap"));
  }
};

TEST_F(Outputs, AreNoInputs) {
  make_inputs();
  const auto before = all();
  for (const char* command : {"run @walk.toml --duration 1 --record @walk.toml",
                              "run @walk.toml --duration 1 --json @walk.toml",
                              "run @walk.toml --duration 1 --log walker.* --out @walk.toml",
                              "run @walk.toml --duration 1 --save-state @walk.toml",
                              "run @walk.toml --duration 1 --save-at 0.5:@walk.toml",
                              "run @walk.toml --duration 1 --html @walk.toml",
                              "run walk --duration 1 --from @in.state --save-state @in.state",
                              "run walk --duration 1 --set walker.model=@kid21.xml --json @kid21.xml",
                              "run walk --duration 1 --set walker.model=@kid21.xml --record @kid21.toml",
                              "rerun @in.mcap --record @in.mcap",
                              "rerun @in.mcap --record @soft.mcap",
                              "rerun @soft.mcap --record @hard.mcap",
                              "rerun @in.mcap --json @in.mcap",
                              "export @in.mcap --csv @in.mcap",
                              "export @in.mcap --npy @hard.mcap",
                              "export @in.mcap --bvh @soft.mcap",
                              "branch @in.state --csv @in.state",
                              "branch @in.mcap --json @soft.mcap",
                              "replay @in.mcap --json @hard.mcap",
                              "replay @in.mcap --html @in.mcap",
                              "sweep @walk.toml --duration 1 --csv @walk.toml",
                              "sweep @walk.toml --duration 1 --summary @walk.toml",
                              "compare @walk.toml --entity walker --json @walk.toml",
                              "check @kid21.xml --json @kid21.xml",
                              "check @kid21.xml --json @kid21.toml",
                              "convert @kid21.xml --out @kid21.xml --force",
                              "plot @in.csv --out @in.csv"}) {
    const Result result = murosimf(in_folder(command));
    EXPECT_EQ(result.exit_code, 2) << command;
    EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << command << ": " << result.errors;
    EXPECT_EQ(all(), before) << command;
  }
  expect_mistake(in_folder("rerun @in.mcap --record @soft.mcap"),
                 {"--record '", "soft.mcap': this file is read by the same command; name another one"});
  expect_mistake("export " + fs::relative(file("in.mcap")).string() + in_folder(" --csv @in.mcap"),
                 {"--csv", "is read by"});
}

TEST_F(Outputs, EachHaveAFileOfTheirOwn) {
  expect_mistake(in_folder("run walk --duration 1 --json @a --log walker.* --out @a"),
                 {"--out '", "this is the same file as --json '", "each result needs one of its own"});
  expect_mistake(in_folder("run walk --duration 1 --save-at 0.1:@a --save-at 0.2:@a"),
                 {"--save-at 0.2", "--save-at 0.1"});
  expect_mistake(in_folder("run walk --duration 1 --record @a.mcap --json @a.foxglove.json"), {"--json", "layout"});
  EXPECT_EQ(files(), std::vector<std::string>{});
}

// Each begins, and fails before the first step.
TEST_F(Outputs, OfARunThatDoesNotStartAreAsTheyWere) {
  const TakenPort taken;
  for (const char* name : {"a.mcap", "a.json", "a.csv", "a.html", "a.png", "a.state", "a.foxglove.json"}) {
    std::ofstream(file(name)) << "an older " << name;
  }
  const auto before = all();
  const std::string outputs = in_folder(
      " --record @a.mcap --json @a.json --log walker.* --out @a.csv --html @a.html --picture @a.png --save-state "
      "@a.state");
  for (const char* error :
       {"--from @missing.state", "--set walker.model=nothing", "--web", "--supervise", "--listen", "--duration -1",
        "--record-rate 5000", "--log nobody.x", "--game-repeat @missing.log", "--record-what poses,nothing",
        "--game-log @no/such", "--set walker.nothing=1", "--push nobody=[1,0,0]%0..1"}) {
    std::string words = in_folder(error);
    std::ranges::replace(words, '%', '@');
    if (words.find(' ') == std::string::npos) words += " " + taken.number();
    EXPECT_EQ(murosimf("run walk --duration 1 " + words + outputs).exit_code, 2) << words;
    EXPECT_EQ(all(), before) << words;
  }
}

TEST_F(Outputs, ARecordingIsOfOneRun) {
  std::ofstream(file("a.mcap")) << "an older recording";
  const std::string first =
      std::string(MUROSIMF_PROGRAM) +
      in_folder(" run walk --speed 1 --duration 100 --record @a.mcap >/dev/null 2>&1 & echo $! >@pid");
  ASSERT_EQ(std::system(first.c_str()), 0);
  const pid_t process = std::stoi(read_file(file("pid")));
  const auto has_begun = [&] { return fs::exists(file("a.mcap.part")) && fs::file_size(file("a.mcap.part")) > 50'000; };
  for (int i = 0; i < 3000 && !has_begun(); ++i) std::this_thread::sleep_for(10ms);
  ASSERT_TRUE(has_begun());
  const std::vector<std::string> holder{"a.mcap': it is being written by process " + std::to_string(process)};
  expect_mistake(in_folder("run walk --duration 1 --record @a.mcap"), holder);
  const Result replayed = murosimf(in_folder("replay @a.mcap.part"));
  EXPECT_EQ(replayed.exit_code, 0) << "is read while it grows: " << replayed.errors;
  expect_mistake(in_folder("repair @a.mcap.part"), {"being written by process " + std::to_string(process)});
  EXPECT_EQ(read_file(file("a.mcap")), "an older recording");
  ::kill(process, SIGINT);
  const auto is_whole = [&] { return !fs::exists(file("a.mcap.part")); };
  for (int i = 0; i < 3000 && !is_whole(); ++i) std::this_thread::sleep_for(10ms);
  EXPECT_EQ(murosimf(in_folder("replay @a.mcap")).errors, "");
}

// What is killed leaves what it had; the next run with the same name does not destroy that.
TEST_F(Outputs, WhatAKilledRunHadIsKept) {
  std::ofstream(file("a.mcap")) << "an older recording";
  const std::string command = "timeout -s KILL 3 " + std::string(MUROSIMF_PROGRAM) +
                              in_folder(" run walk --speed 1 --duration 100 --record @a.mcap >/dev/null 2>&1");
  EXPECT_NE(std::system(command.c_str()), 0);
  ASSERT_TRUE(fs::exists(file("a.mcap.part")));
  EXPECT_EQ(read_file(file("a.mcap")), "an older recording");
  const Result next = murosimf(in_folder("run walk --duration 1 --record @a.mcap"));
  EXPECT_EQ(next.exit_code, 0) << next.errors;
  EXPECT_NE(next.errors.find("a.cut_off_1.mcap': this is what an earlier run had recorded"), std::string::npos);
  EXPECT_EQ(murosimf(in_folder("repair @a.cut_off_1.mcap")).exit_code, 0);
  EXPECT_EQ(murosimf(in_folder("rerun @a.cut_off_1.mcap")).exit_code, 0);
  EXPECT_EQ(files(), (std::vector<std::string>{"a.cut_off_1.mcap", "a.foxglove.json", "a.mcap"}));
}

TEST_F(Outputs, GoIntoPipesAndDescriptors) {
  make_inputs();
  const std::string program = MUROSIMF_PROGRAM;
  const auto run = [&](const std::string& arguments) {
    EXPECT_EQ(std::system((program + " " + in_folder(arguments)).c_str()), 0) << arguments;
  };
  run("export @in.mcap --csv @table.csv");
  run("export @in.mcap --csv /dev/stdout >@by_file.csv");
  run("export @in.mcap --csv /dev/stdout | cat >@by_pipe.csv");
  run("export @in.mcap --csv /dev/fd/3 3>@by_number.csv");
  for (const char* name : {"by_file.csv", "by_pipe.csv", "by_number.csv"}) {
    EXPECT_EQ(read_file(file(name)), read_file(file("table.csv"))) << name;
  }
  run("run walk --duration 1 --record /dev/stdout --json /dev/null | cat >@piped.mcap");
  run("run walk --duration 1 --json - >@report.json");
  EXPECT_EQ(read_file(file("report.json")).front(), '{');
}

// Without space each result is written that can be, and the exit code says that one is missing.
TEST_F(Outputs, ThatCannotBeWrittenTakeNoOthersWithThem) {
  const auto limited = [&](const std::string& arguments) {
    const std::string command = in_folder("ulimit -f 8; exec " + std::string(MUROSIMF_PROGRAM) + " " + arguments);
    std::ofstream(file("script")) << command;
    const int status = std::system(in_folder("bash @script >@out 2>@errors </dev/null").c_str());
    fs::remove(file("script"));
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  };
  std::ofstream(file("log.csv")) << "older";
  EXPECT_EQ(
      limited(
          "run walk --duration 5 --log walker.* --out @log.csv --save-at 1:@one.state --html @a.html --json @a.json"),
      2);
  EXPECT_EQ(read_file(file("log.csv")), "older");
  EXPECT_NE(read_file(file("out")).find("state hash"), std::string::npos) << read_file(file("errors"));
  EXPECT_EQ(files(), (std::vector<std::string>{"a.json", "errors", "log.csv", "out"}));
  EXPECT_EQ(limited("sweep walk --seeds 1..3 --duration 0.1 --runs @runs --csv @a.csv"), 0)
      << read_file(file("errors"));
}

TEST_F(Outputs, PicturesArePngFiles) {
  std::ofstream(file("x.jpg")) << "older";
  std::ofstream(file("in.csv")) << "time [s],a\n0,1\n1,2\n";
  for (const char* command : {"render walk --out @x.jpg", "run walk --duration 1 --picture @x.jpg",
                              "check kid21 --picture @x.svg", "plot @in.csv --out @x.pdf"}) {
    expect_mistake(in_folder(command), {"pictures are PNG files; write a name that ends with .png"});
  }
  EXPECT_EQ(read_file(file("x.jpg")), "older");
}

}  // namespace
}  // namespace murosimf::test
