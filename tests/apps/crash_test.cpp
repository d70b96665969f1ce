// What once ended the program by a signal, or never ended: now one line and an exit code.
#include <sys/stat.h>

#include "tests/apps/program.h"
#include "tests/environment_variable.h"

namespace murosimf::test {
namespace {

#if defined(MUROSIMF_ADDRESS_SANITIZER) || defined(MUROSIMF_THREAD_SANITIZER)
constexpr bool can_limit_memory = false;
#else
constexpr bool can_limit_memory = true;
#endif

std::string repeated(const std::string& text, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

/// With at most that much address space [kB].
Result with_memory(int kilobytes, const std::string& arguments) {
  const fs::path out = scratch("out"), err = scratch("err");
  const std::string command = "ulimit -v " + std::to_string(kilobytes) + "; exec " MUROSIMF_PROGRAM " " + arguments +
                              " >" + out.string() + " 2>" + err.string() + " </dev/null";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(out), read_file(err)};
}

void expect_one_line(const Result& result, int exit_code, const std::string& part) {
  EXPECT_EQ(result.exit_code, exit_code);
  EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
  EXPECT_NE(result.errors.find(part), std::string::npos) << result.errors;
}

TEST(Crash, WhereAnEntityHasNoNumbersToLog) {
  const std::string out = " --out " + scratch("l.csv").string();
  for (const char* pattern : {"field.field.position", "'field.*.*'", "field.field.position.x"}) {
    expect_mistake(std::string("run walk --log ") + pattern + out, {"--log", "'field' has no"});
  }
}

TEST(Crash, WhereARateIsNoRate) {
  for (const char* rate : {"1e10", "1e-9", "1e300", "nan", "0", "-5"}) {
    expect_mistake(std::string("run walk --set rate=") + rate, {"'rate'"});
    expect_mistake(std::string("run walk --log walker.base.position --out /dev/null --log-rate ") + rate, {"Hz"});
  }
  expect_mistake("run walk --set walker.sensors.imu.rate=1e10", {"imu", "Hz"});
  expect_mistake("run walk --set walker.sensors.imu.rate=1e-10", {"imu", "Hz"});
}

TEST(Crash, WhereTomlNeverEnds) {
  for (const std::string& text :
       {repeated("a.", 50000) + "a = 1", "a = " + repeated("[", 50000), "[" + repeated("a.", 50000)}) {
    expect_mistake("run " + write("deep.toml", text).string(), {"deep.toml:1:", "more than"});
  }
  expect_mistake("run walk --set walker.position=" + repeated("[", 500), {"--set", "more than 64 brackets"});
  expect_mistake("run walk --at 1:walker.command=" + repeated("[", 500), {"--at", "more than 64 brackets"});
}

TEST(Crash, WhereStandardErrorIsFull) {
  EXPECT_EQ(WEXITSTATUS(std::system(MUROSIMF_PROGRAM " run nosuch 2>/dev/full")), 2);
  EXPECT_EQ(WEXITSTATUS(std::system(MUROSIMF_PROGRAM " run nosuch 2>&-")), 2);
  EXPECT_EQ(WEXITSTATUS(std::system(MUROSIMF_PROGRAM " run --nosuch 2>/dev/full")), 2);
}

TEST(Crash, WhereThreadsCannotBegin) {
  if (!can_limit_memory) GTEST_SKIP() << "sanitizers reserve more memory than a limit leaves";
  expect_one_line(with_memory(300000, "run walk --duration 0.01 --threads 256"), 2, "use fewer: --threads ");
}

TEST(Crash, WhereMemoryEnds) {
  if (!can_limit_memory) GTEST_SKIP() << "sanitizers reserve more memory than a limit leaves";
  const std::string run = "run three_on_three --no-cameras --duration 3000 --out " + scratch("l.csv").string() +
                          " --log '*.*.position' --log '*.*.orientation' --log '*.*.joint_position' --log-rate 1000";
  expect_one_line(with_memory(80000, run), 3, "murosimf: out of memory");
  expect_one_line(with_memory(80000, run + " --threads 2"), 3, "murosimf: out of memory");
}

TEST(Crash, WhereADriverHasTooLittleMemory) {
  if (!can_limit_memory) GTEST_SKIP() << "sanitizers reserve more memory than a limit leaves";
  const Result run = with_memory(500000, "run six_cameras --duration 0.05");
  EXPECT_EQ(run.exit_code, 0) << "cameras need no driver: " << run.errors;
  EXPECT_EQ(with_memory(500000, "render walk --size 160x90 --out " + scratch("p.png").string()).exit_code, 0);
  const EnvironmentVariable opengl("MUROSIMF_RENDERER", "opengl");
  const Result picture = with_memory(500000, "render walk --out " + scratch("p.png").string());
  expect_one_line(picture, 2, "no pictures by OpenGL");
  const Result pictures = with_memory(500000, "run walk --duration 1e9 --pictures " + scratch("p").string());
  expect_one_line(pictures, 2, "no pictures by OpenGL");
}

TEST(Hang, WhereAFileNeverEndsOrNeverBegins) {
  const fs::path fifo = scratch("fifo.json");
  fs::remove(fifo);
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  const std::string servo = scratch("servo.toml").string();
  for (const std::string& file : {std::string("/dev/zero"), fifo.string()}) {
    expect_mistake("replay-servo " + file + " --servo xl330", {file, "no ordinary file"});
    expect_mistake("plot " + file + " --out " + scratch("p.png").string(), {file, "no ordinary file"});
    const Result fit = murosimf("fit-servo " + file + " --out " + servo);
    if (fit.errors.find("NLopt was missing") == std::string::npos) expect_one_line(fit, 2, "no ordinary file");
  }
  fs::remove(fifo);
}

}  // namespace
}  // namespace murosimf::test
