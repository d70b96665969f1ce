#include "murosimf/studies/posture_events.h"

#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/math/scalar.h"

namespace murosimf::studies {
namespace {

const double cos_down = std::cos(pi / 3);
const double cos_up = std::cos(pi / 6);

std::string times(int count) { return count == 1 ? "once" : fmt::format("{} times", count); }

std::string different_falls(int mine, int reference) {
  MUROSIMF_ASSERT(mine != reference);
  if (mine == 0) return "does not fall, the reference does";
  if (reference == 0) return fmt::format("falls {}, the reference does not", times(mine));
  return fmt::format("falls {}, the reference {}", times(mine), times(reference));
}

}  // namespace

void Posture::see(double time, double cos_lean) {
  // Two limits: a torso that sways around one of them does not fall again and again.
  if (events_.empty()) {
    events_.push_back({time, cos_lean < cos_down});
  } else if (events_.back().down ? cos_lean > cos_up : cos_lean < cos_down) {
    events_.push_back({time, !events_.back().down});
  }
}

int falls_in(const std::vector<PostureEvent>& events) {
  int falls = 0;
  for (std::size_t i = 1; i < events.size(); ++i) falls += events[i].down ? 1 : 0;
  return falls;
}

double first_fall(const std::vector<PostureEvent>& events) {
  for (std::size_t i = 1; i < events.size(); ++i) {
    if (events[i].down) return events[i].time;
  }
  return std::numeric_limits<double>::infinity();
}

std::string difference(const std::vector<PostureEvent>& mine, const std::vector<PostureEvent>& reference,
                       double tolerance) {
  if (mine.empty() || reference.empty()) return "nothing was recorded";
  if (mine[0].down != reference[0].down) {
    return mine[0].down ? "begins lying, the reference upright" : "begins upright, the reference lying";
  }
  if (falls_in(mine) != falls_in(reference)) return different_falls(falls_in(mine), falls_in(reference));
  if (mine.size() != reference.size()) {
    return mine.size() < reference.size() ? "does not get up, the reference does" : "gets up, the reference does not";
  }
  for (std::size_t i = 1; i < mine.size(); ++i) {
    const double later = mine[i].time - reference[i].time;
    if (std::abs(later) <= tolerance) continue;
    return fmt::format("{} {:.2f} s {} than the reference", mine[i].down ? "falls" : "gets up", std::abs(later),
                       later > 0 ? "later" : "earlier");
  }
  return {};
}

}  // namespace murosimf::studies
