#include "murosimf/identification/bench_logs.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/fixtures.h"
#include "tests/identification/synthetic.h"
#include "tests/law.h"

namespace murosimf::identification {
namespace {

using fixtures::same_bits;
using synthetic::record;

const multibody::BenchServo servo{.torque_constant = 0.366,
                                  .resistance = 3.2,
                                  .rotor_inertia = 0.0018,
                                  .encoder_offset = 0.02,
                                  .friction = {.coulomb = 0.006,
                                               .viscous = 0.005,
                                               .stribeck = 0.006,
                                               .stribeck_rate = 0.5,
                                               .stribeck_exponent = 1.5,
                                               .motor_load = 0.15,
                                               .external_load = 0.15}};

std::vector<double> errors_of(const std::vector<ServoLog>& logs, double step = 1e-3) {
  std::vector<Piece> pieces;
  for (const ServoLog& log : logs) pieces.push_back(whole(log));
  BenchLogs bench(pieces, synthetic::duty_per_gain, step);
  std::vector<double> errors(logs.size());
  bench.errors(servo, errors);
  return errors;
}

// Law: the servo that made a recording explains it, on every course, with the torque off in between, on a grid and with
// time stamps of 5 to 8 ms. Tolerance: 3 mrad, the error of a step of 1 ms; where it sticks may differ by that much.
TEST(BenchLogs, TheServoThatWasRecordedExplainsTheRecording) {
  for (const auto& course :
       {synthetic::two_sines(), synthetic::up_and_down(), synthetic::chirp(), synthetic::drops()}) {
    for (const double period : {5e-3, 0.0}) {
      EXPECT_LT(errors_of({record(servo, course, {.period = period})})[0], 3e-3) << course.name << " " << period;
    }
  }
}

// Law: a servo holds the goal that its driver sent last. With 20 ms between two, a line from goal to goal would lead by 10 ms.
// Tolerance: 3 mrad, as above.
TEST(BenchLogs, GoalsAreHeldUntilTheNext) {
  for (const auto& course : {synthetic::two_sines(), synthetic::chirp()}) {
    law::expect_below({"recording of a servo that got a goal every 20 ms: mean error of the servo that made it",
                       course.name, "goals are held, not interpolated"},
                      errors_of({record(servo, course, {.period = 20e-3})})[0], 3e-3, "rad");
  }
}

// Law: the error is the mean of |q_sim - q|: positions that are all 0.1 rad off have an error of 0.1 rad. Tolerance: 3
// mrad, as above.
TEST(BenchLogs, TheErrorIsTheMeanDistance) {
  ServoLog log = record(servo, synthetic::two_sines());
  for (std::size_t i = 1; i < log.samples.size(); ++i) log.samples[i].position += 0.1;
  EXPECT_NEAR(errors_of({log})[0], 0.1, 3e-3);
}

// Rule: a log's error does not depend on the logs beside it, nor on how many there are. No tolerance.
TEST(BenchLogs, LogsDoNotTouchEachOther) {
  std::vector<ServoLog> logs;
  for (int i = 0; i < 11; ++i) {
    const synthetic::Setting setting{.gain = 100.0 * (1 + i % 4), .voltage = 7 + 0.1 * i, .duration = 1 + 0.2 * i};
    logs.push_back(record(servo, i % 2 ? synthetic::chirp() : synthetic::drops(), setting));
    logs.back().samples[3].position += 0.01;
  }
  const std::vector<double> together = errors_of(logs);
  for (std::size_t i = 0; i < logs.size(); ++i) {
    EXPECT_TRUE(same_bits(together[i], errors_of({logs[i]})[0])) << i;
  }
}

// Law: a piece starts at the measured state, and uses only its own entries. Tolerance: 1 mrad: it has less time to
// diverge than a whole log.
TEST(BenchLogs, APieceStartsWhereTheRecordingIs) {
  ServoLog log = record(servo, synthetic::drops());
  log.samples.front().position = 100;
  log.samples.back().position = 100;
  const Piece piece{.log = &log, .first = 200, .last = 400, .rate = log.samples[200].rate};
  BenchLogs bench({piece}, synthetic::duty_per_gain, 1e-3);
  std::vector<double> error(1);
  bench.errors(servo, error);
  EXPECT_LT(error[0], 1e-3);
  EXPECT_EQ(bench.positions(0).size(), 201U);
  EXPECT_EQ(bench.positions(0)[0], log.samples[200].position);
}

// Law: a switch of the torque within a log is applied at its time: without it the same log is another one.
TEST(BenchLogs, TheTorqueSwitchCounts) {
  ServoLog log = record(servo, synthetic::drops());
  for (ServoSample& sample : log.samples) sample.enabled = true;
  EXPECT_GT(errors_of({log})[0], 0.1);
}

}  // namespace
}  // namespace murosimf::identification
