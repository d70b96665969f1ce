#include "murosimf/studies/outcome_recorder.h"

#include "murosimf/dynamics/motion_recorder.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/properties.h"

namespace murosimf::studies {

OutcomeRecorder::OutcomeRecorder(Setup& setup, const Entity& robot, const std::vector<Entity*>& others, double longest)
    : robot_(setup.world().index_of(&robot)),
      pairs_(setup.read(collision::pair_contacts)[0]),
      stride_(dynamics::steps_per_sample(setup.period())) {
  MUROSIMF_ASSERT(longest >= 0 && stride_ > 0);
  const auto samples = static_cast<std::size_t>(longest * dynamics::MotionRecorder::samples_per_second) + 2;
  // Room for all samples: step() must not allocate.
  record_.touching.reserve(samples);
  for (Entity* entity : others) {
    Setup other = setup.of(*entity);
    sources_.push_back({setup.world().index_of(entity), other.read(properties::position),
                        other.read(properties::linear_velocity), other.read(properties::orientation)});
    OtherRecord& record = record_.others.emplace_back();
    record.name = entity->name();
    record.can_fall = !entity->model().joints().empty();
    record.samples.reserve(samples);
  }
}

void OutcomeRecorder::step(const Instant& instant) noexcept {
  // Contacts and motions are those at the end of the step.
  const double now = seconds(instant.now + instant.period);
  watch_touches(now);
  if (++steps_ % stride_ == 0) take_sample(now);
}

void OutcomeRecorder::watch_touches(double now) noexcept {
  for (const auto* points : {&pairs_.points, &pairs_.blocked}) {
    for (const collision::PairContact& c : *points) {
      const int a = pairs_.entities[static_cast<std::size_t>(c.a)], b = pairs_.entities[static_cast<std::size_t>(c.b)];
      if (a == robot_ && b != robot_) touch(b, now);
      if (b == robot_ && a != robot_) touch(a, now);
    }
  }
}

/// The first touch counts for verdicts; the last one shows until when the robot had an effect.
void OutcomeRecorder::touch(int number, double now) noexcept {
  touching_ = true;
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    if (sources_[i].number != number) continue;
    OtherRecord& other = record_.others[i];
    if (!other.touched) other.touched = now;
    other.touched_last = now;
  }
}

void OutcomeRecorder::take_sample(double now) noexcept {
  // A touch between two samples belongs to the later one.
  record_.touching.push_back(touching_);
  touching_ = false;
  MUROSIMF_ASSERT(record_.others.size() == sources_.size());
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    const Source& s = sources_[i];
    record_.others[i].samples.push_back({now, s.r[0], norm(s.v[0]), (s.R[0] * Vec3d{0, 0, 1}).z});
  }
}

}  // namespace murosimf::studies
