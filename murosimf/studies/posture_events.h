/// posture_events.h - when an entity falls and gets up, and how two runs differ in that.
#pragma once

#include <string>
#include <vector>

namespace murosimf::studies {

/// The torso went down (it leans more than 60 degrees) or came up again (less than 30). A run's first event is how it begins,
/// at time 0.
struct PostureEvent {
  double time = 0;  ///< [s]
  bool down = false;
};

class Posture {
 public:
  /// The next sample: cosine of the angle by which the torso leans.
  void see(double time, double cos_lean);
  [[nodiscard]] const std::vector<PostureEvent>& events() const { return events_; }

 private:
  std::vector<PostureEvent> events_;
};

/// How often it went down after it had been up.
[[nodiscard]] int falls_in(const std::vector<PostureEvent>& events);

/// [s] When it went down first after it had been up; infinity: never.
[[nodiscard]] double first_fall(const std::vector<PostureEvent>& events);

/// "falls once, the reference does not", "falls 0.31 s later than the reference"; empty: they do not differ by more than `tolerance` [s].
[[nodiscard]] std::string difference(const std::vector<PostureEvent>& mine, const std::vector<PostureEvent>& reference,
                                     double tolerance);

}  // namespace murosimf::studies
