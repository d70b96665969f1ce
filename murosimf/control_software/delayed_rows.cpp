#include "murosimf/control_software/delayed_rows.h"

#include <algorithm>
#include <utility>

#include "murosimf/math/assert.h"

namespace murosimf::control_software {

/// A lost row still counts as sent, and takes its turn in the random numbers of the link.
void DelayedRows::send(Duration now, std::span<const double> numbers) {
  ++sent_;
  ++counts_.sent;
  const auto arrival = link_.arrival(now, numbers.size_bytes());
  if (!arrival) {
    ++counts_.lost;
    return;
  }
  MUROSIMF_ASSERT(*arrival >= now);
  counts_.longest = std::max(counts_.longest, *arrival - now);
  on_their_way_.push_back({*arrival, sent_, {numbers.begin(), numbers.end()}});
}

const std::vector<double>* DelayedRows::receive(Duration now) {
  bool any = false;
  // Without an order of arrival all are visited: jitter lets packets overtake each other, and few are in transit.
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

}  // namespace murosimf::control_software
