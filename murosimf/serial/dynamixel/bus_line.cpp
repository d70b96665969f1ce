#include "murosimf/serial/dynamixel/bus_line.h"

#include <algorithm>
#include <vector>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::serial::dynamixel {

void BusLine::set_rate(double rate) {
  if (rate != rate_) parser_.forget();  // bytes at different rates form no packet
  rate_ = rate;
  if (byte_time_ > 0 && rate > 0) byte_time_ = 10 / rate;
}

void BusLine::push(ByteView bytes, double now) {
  MUROSIMF_ASSERT(byte_time_ >= 0);
  parser_.push(bytes);
  while (auto packet = parser_.next()) {
    free_ = std::max(free_, now) + static_cast<double>(parser_.size_of_last()) * byte_time_;
    // With byte times an instruction is executed later, in run(), when its last byte has arrived.
    arrivals_.push_back({free_, std::move(*packet)});
    if (byte_time_ > 0) continue;
    execute(arrivals_.front());
    arrivals_.pop_front();
  }
}

/// Half duplex: an answer begins when the line is free of the answers before.
void BusLine::execute(const Arrival& arrival) {
  ++instructions_;
  double begin = std::max(arrival.due, answered_);
  for (BusAnswer& answer : bus_->execute(arrival.packet, rate_)) {
    const double delay = byte_time_ > 0 ? answer.delay : 0;
    departures_.push_back({begin + delay, std::move(answer.bytes)});
    begin += delay + static_cast<double>(departures_.back().bytes.size()) * byte_time_;
  }
  answered_ = begin;
  MUROSIMF_ASSERT(answered_ >= arrival.due);
  free_ = std::max(free_, begin);
}

void BusLine::run(double now, Bytes& out) {
  constexpr double rounding = 1e-9;  // [s] of sums of byte times
  while (!arrivals_.empty() && arrivals_.front().due <= now + rounding) {
    execute(arrivals_.front());
    arrivals_.pop_front();
  }
  while (!departures_.empty()) {
    Departure& next = departures_.front();
    MUROSIMF_ASSERT(next.sent <= next.bytes.size());
    while (next.sent < next.bytes.size() &&
           next.begin + static_cast<double>(next.sent + 1) * byte_time_ <= now + rounding) {
      out.push_back(next.bytes[next.sent++]);
    }
    if (next.sent < next.bytes.size()) return;
    departures_.pop_front();
  }
}

void BusLine::hang_up() {
  parser_.forget();
  arrivals_.clear();
  departures_.clear();
  free_ = answered_ = 0;
}

void BusLine::Arrival::state(StateArchive& archive) {
  archive(due, packet.protocol, packet.id, packet.instruction, packet.parameters);
}

void BusLine::Departure::state(StateArchive& archive) {
  archive(begin, bytes, sent);
  if (sent > bytes.size()) throw SetupError("an answer on its way is damaged");
}

void BusLine::state(StateArchive& archive) {
  std::vector<Arrival> arrivals(arrivals_.begin(), arrivals_.end());
  std::vector<Departure> departures(departures_.begin(), departures_.end());
  archive(parser_, arrivals, departures, free_, answered_, instructions_, rate_, byte_time_);
  arrivals_.assign(arrivals.begin(), arrivals.end());
  departures_.assign(departures.begin(), departures.end());
}

}  // namespace murosimf::serial::dynamixel
