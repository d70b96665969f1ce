// States of runs as files: one process saves, another one goes on.
#include <fstream>

#include "tests/apps/program.h"

namespace murosimf::test {
namespace {

std::string hash_of(const Result& result) {
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  return state_hash_in(result.output);
}

TEST(StateFiles, AnotherProcessGoesOnBitForBit) {
  const std::string file = scratch("state.bin").string();
  for (const std::string scene : {"three_on_three --no-cameras", "nudge"}) {
    const std::string whole = hash_of(murosimf("run " + scene + " --duration 1.3"));
    hash_of(murosimf("run " + scene + " --duration 0.9 --save-state " + file));
    EXPECT_EQ(hash_of(murosimf("run " + scene + " --duration 1.3 --from " + file)), whole) << scene;
  }
}

// Who only looks on is no part of a state.
TEST(StateFiles, ALogMayBeginWhereTheStateIs) {
  const std::string file = scratch("state.bin").string(), log = scratch("log.csv").string();
  const std::string scene = "run three_on_three --no-cameras --duration ";
  hash_of(murosimf(scene + "0.25 --save-state " + file));
  const std::string plain = hash_of(murosimf(scene + "0.5 --from " + file));
  const std::string logging = " --log ball.ball.position --log-rate 10 --out " + log;
  EXPECT_EQ(hash_of(murosimf(scene + "0.5 --from " + file + logging)), plain);
  std::stringstream lines(read_file(log));
  std::vector<std::string> times;
  for (std::string line; std::getline(lines, line);) times.push_back(line.substr(0, line.find(',')));
  EXPECT_EQ(times, (std::vector<std::string>{times.front(), "0.25", "0.3", "0.4"}));
}

TEST(StateFiles, MistakesAreOneLine) {
  const std::string file = scratch("state.bin").string();
  hash_of(murosimf("run walk --duration 0.01 --save-state " + file));
  expect_mistake("run nudge --from " + file, {file, "entity 'walker'"});
  expect_mistake("run walk --from /nowhere/state.bin", {"/nowhere/state.bin"});
  expect_mistake("run walk --from /dev/zero", {"/dev/zero"});
  expect_mistake("run walk --save-state /nowhere/state.bin", {"/nowhere/state.bin"});
  fs::resize_file(file, fs::file_size(file) / 2);
  expect_mistake("run walk --from " + file, {file, "no whole state"});
  expect_mistake("run walk --from " + write("text", "not a state at all, but long enough").string(), {"text"});
}

}  // namespace
}  // namespace murosimf::test
