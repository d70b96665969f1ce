#include "apps/servo_logs.h"

#include "murosimf/identification/bench_servo.h"

namespace murosimf::app {
namespace {

using identification::Piece;
using identification::ServoLog;

std::vector<Piece> whole_logs(std::span<const ServoLog> logs) {
  std::vector<Piece> pieces;
  for (const ServoLog& log : logs) pieces.push_back(identification::whole(log));
  return pieces;
}

}  // namespace

ServoReplay::ServoReplay(const identification::FittedServo& fitted, std::span<const ServoLog> logs)
    : bench_(whole_logs(logs), identification::duty_per_gain(fitted.servo), replay_step) {
  std::vector<double> errors(logs.size());
  bench_.errors(identification::bench_servo(fitted.servo, fitted.encoder_offset), errors);
  for (std::size_t i = 0; i < logs.size(); ++i) {
    errors_.push_back({logs[i].name, logs[i].trajectory, logs[i].firmware_gain, errors[i]});
  }
}

}  // namespace murosimf::app
