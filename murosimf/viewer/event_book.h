/// event_book.h - events of a run, in all of its branches: events and warnings of the simulation, falls, goals.
#pragma once

#include <string>
#include <vector>

#include "murosimf/viewer/inspection.h"
#include "murosimf/viewer/timeline_layout.h"

namespace murosimf::viewer {

class EventBook {
 public:
  /// Adds new ones; `branch`: of the timeline; `jumped`: time has jumped since the last call, so numbers of falls are not
  /// compared.
  void take(const Inspection& seen, int branch, bool jumped);
  void goal(double time, int branch, std::string text);

  /// Ordered by time.
  [[nodiscard]] const std::vector<TimeMark>& marks() const { return marks_; }
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }
  /// For the next request.
  [[nodiscard]] std::size_t events_known() const { return events_known_; }
  [[nodiscard]] std::size_t warnings_known() const { return warnings_.size(); }

 private:
  void add(TimeMark mark);

  std::vector<TimeMark> marks_;
  std::vector<std::string> warnings_;
  std::vector<int> falls_;  // by entity
  std::size_t events_known_ = 0;
};

}  // namespace murosimf::viewer
