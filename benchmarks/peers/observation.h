/// observation.h - did an engine do the work? Numbers over a run that are the same for all engines.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "benchmarks/peers/peer.h"

namespace peers {

class Observation {
 public:
  /// At the end of each control cycle, with the targets that it had.
  void add(const View& view, std::span<const double> targets);
  /// Mean height of bases [m], distance from the first place [m], mean speed of bases in the second half [mm/s], rms of joints from
  /// targets [rad], mean number of contact points, greatest depth and gap [mm], robots that lie in the end.
  /// `cycle` [s]: from one view to the next.
  [[nodiscard]] nlohmann::json result(double cycle) const;

 private:
  std::size_t views_ = 0, joints_ = 0;
  double heights_ = 0, squares_ = 0, contacts_ = 0, depth_ = 0, gap_ = 0;
  std::vector<std::vector<Vector>> places_;  // by view, then by robot
  View last_;
};

}  // namespace peers
