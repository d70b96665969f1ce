#include "murosimf/connect/delayed_rows.h"

#include <algorithm>
#include <utility>

namespace murosimf::connect {

void DelayedRows::send(Duration now, std::span<const double> numbers) {
  ++sent_;
  ++counts_.sent;
  const auto arrival = link_.arrival(now, numbers.size_bytes());
  if (!arrival) {
    ++counts_.lost;
    return;
  }
  counts_.longest = std::max(counts_.longest, *arrival - now);
  on_their_way_.push_back({*arrival, sent_, {numbers.begin(), numbers.end()}});
}

const std::vector<double>* DelayedRows::receive(Duration now) {
  bool any = false;
  std::erase_if(on_their_way_, [&](Packet& packet) {
    if (packet.arrival > now) return false;
    if (packet.number > newest_) {
      newest_ = packet.number;
      received_ = std::move(packet.numbers);
      any = true;
    } else {
      ++counts_.overtaken;
    }
    return true;
  });
  return any ? &received_ : nullptr;
}

void DelayedRows::restart() {
  link_.restart();
  on_their_way_.clear();
  sent_ = newest_ = 0;
  counts_ = {};
}

}  // namespace murosimf::connect
