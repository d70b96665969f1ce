/// until.h - waits for datagrams of the loopback, which usually are there at once, without a guarantee.
#pragma once

#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include "murosimf/league/datagrams.h"

namespace murosimf::league {

/// What `take` gives first that is not empty; empty after 10 s.
template <class Take>
auto until(const Take& take) {
  auto taken = take();
  for (int i = 0; i < 1000 && taken.empty(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    taken = take();
  }
  return taken;
}

/// The next `count` datagrams.
inline std::vector<std::string> all_of(Datagrams& port, std::size_t count) {
  std::vector<std::string> all;
  while (all.size() < count) {
    const auto more = until([&] { return port.take({}); });
    if (more.empty()) break;
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

}  // namespace murosimf::league
