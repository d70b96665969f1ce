#include "murosimf/identification/bench_logs.h"

#include <algorithm>
#include <cmath>

#include "murosimf/math/assert.h"

namespace murosimf::identification {
namespace {

constexpr double standard_gravity = 9.80665;  // [m/s^2]
constexpr auto lanes_per_pack = static_cast<std::size_t>(Pack8::lanes);

double start_of(const Piece& piece) { return piece.log->samples[piece.first].time; }
double duration_of(const Piece& piece) { return piece.log->samples[piece.last].time - start_of(piece); }

multibody::Bench<double> bench_of(const ServoLog& log, double duty_per_gain) {
  const double square = log.length * log.length;
  return {.inertia = log.mass * square + log.arm_mass * square / 3,
          .weight = (log.mass + log.arm_mass / 2) * standard_gravity * log.length,
          .gain = duty_per_gain * log.firmware_gain};
}

/// Goal, voltage and switch of a log at growing times: goal and switch are held, the voltage is interpolated.
class InputReader {
 public:
  explicit InputReader(const Piece& piece) : samples_(piece.log->samples), i_(piece.first) {}

  ServoSample at(double time) {
    // Times grow from call to call, so the search continues where it ended.
    while (i_ + 1 < samples_.size() && samples_[i_ + 1].time <= time) ++i_;
    ServoSample sample = samples_[i_];
    if (i_ + 1 == samples_.size()) return sample;
    const ServoSample& next = samples_[i_ + 1];
    MUROSIMF_ASSERT(next.time > sample.time);
    const double share = (time - sample.time) / (next.time - sample.time);
    sample.voltage += share * (next.voltage - sample.voltage);
    return sample;
  }

 private:
  const std::vector<ServoSample>& samples_;
  std::size_t i_;
};

}  // namespace

Piece whole(const ServoLog& log) {
  MUROSIMF_ASSERT(log.samples.size() >= 2);
  return {&log, 0, log.samples.size() - 1, log.samples.front().rate};
}

BenchLogs::BenchLogs(std::vector<Piece> pieces, double duty_per_gain, double step)
    : pieces_(std::move(pieces)), step_(step), packs_((pieces_.size() + lanes_per_pack - 1) / lanes_per_pack) {
  MUROSIMF_ASSERT(step > 0);
  for (std::size_t p = 0; p < packs_.size(); ++p) {
    const std::size_t first = p * lanes_per_pack, last = std::min(pieces_.size(), first + lanes_per_pack);
    double longest = 0;
    for (std::size_t i = first; i < last; ++i) longest = std::max(longest, duration_of(pieces_[i]));
    // As many steps as the longest piece of the pack needs; shorter ones run on and are not read there.
    const auto steps = static_cast<std::size_t>(std::ceil(longest / step_));
    packs_[p].inputs.resize(steps);
    packs_[p].positions.resize(steps + 1);
    for (std::size_t lane = 0; lane < lanes_per_pack; ++lane) {  // lanes that are left over repeat the last piece
      fill_lane(packs_[p], static_cast<int>(lane), pieces_[std::min(first + lane, last - 1)], duty_per_gain);
    }
  }
}

void BenchLogs::fill_lane(Lanes& lanes, int lane, const Piece& piece, double duty_per_gain) const {
  MUROSIMF_ASSERT(lane >= 0 && lane < Pack8::lanes && piece.first <= piece.last);
  const ServoLog& log = *piece.log;
  const auto bench = bench_of(log, duty_per_gain);
  lanes.bench.inertia.set_lane(lane, bench.inertia);
  lanes.bench.weight.set_lane(lane, bench.weight);
  lanes.bench.gain.set_lane(lane, bench.gain);
  lanes.start.position.set_lane(lane, log.samples[piece.first].position);
  lanes.start.rate.set_lane(lane, piece.rate);
  InputReader reader(piece);
  for (std::size_t k = 0; k < lanes.inputs.size(); ++k) {
    // Inputs in the middle of the step: a quadrature of second order.
    const ServoSample sample = reader.at(start_of(piece) + (static_cast<double>(k) + 0.5) * step_);
    multibody::BenchInput<Pack8>& input = lanes.inputs[k];
    input.goal.set_lane(lane, sample.goal);
    input.voltage.set_lane(lane, sample.voltage);
    input.enabled.set_lane(lane, sample.enabled ? 1.0 : 0.0);
  }
}

void BenchLogs::simulate(const multibody::BenchServo& servo, Lanes& lanes) const {
  MUROSIMF_ASSERT(lanes.positions.size() == lanes.inputs.size() + 1);
  multibody::BenchState<Pack8> state = lanes.start;
  lanes.positions[0] = state.position;
  for (std::size_t k = 0; k < lanes.inputs.size(); ++k) {
    multibody::advance(servo, lanes.bench, lanes.inputs[k], step_, state);
    lanes.positions[k + 1] = state.position;
  }
}

double BenchLogs::position_at(std::size_t piece, double time) const {
  MUROSIMF_ASSERT(piece < pieces_.size() && time >= 0);
  const Lanes& lanes = packs_[piece / lanes_per_pack];
  const auto lane = static_cast<int>(piece % lanes_per_pack);
  const double steps = time / step_;
  const auto before = std::min(static_cast<std::size_t>(steps), lanes.inputs.size() - 1);
  const double low = lanes.positions[before].lane(lane), high = lanes.positions[before + 1].lane(lane);
  return low + (steps - static_cast<double>(before)) * (high - low);
}

void BenchLogs::errors(const multibody::BenchServo& servo, std::span<double> errors) {
  MUROSIMF_ASSERT(errors.size() == pieces_.size());
  for (Lanes& lanes : packs_) simulate(servo, lanes);
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const Piece& piece = pieces_[i];
    double sum = 0;
    for (std::size_t k = piece.first; k <= piece.last; ++k) {
      const ServoSample& sample = piece.log->samples[k];
      sum += std::fabs(position_at(i, sample.time - start_of(piece)) - sample.position);
    }
    errors[i] = sum / static_cast<double>(piece.last - piece.first + 1);
  }
}

std::vector<double> BenchLogs::positions(std::size_t i) const {
  MUROSIMF_ASSERT(i < pieces_.size());
  const Piece& piece = pieces_[i];
  std::vector<double> positions;
  for (std::size_t k = piece.first; k <= piece.last; ++k) {
    positions.push_back(position_at(i, piece.log->samples[k].time - start_of(piece)));
  }
  return positions;
}

}  // namespace murosimf::identification
