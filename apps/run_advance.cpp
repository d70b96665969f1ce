#include "apps/run_advance.h"

#include <algorithm>

#include <fmt/format.h>

#include "apps/error_output.h"
#include "apps/interruption.h"
#include "murosimf/control_software/crash_note.h"
#include "murosimf/model/error.h"
#include "murosimf/scene/scene_report.h"
#include "murosimf/session/session.h"

namespace murosimf::app {

RunAdvance::RunAdvance(scene::Scene& scene, const RunOptions& options, RunOutputs& outputs, const Others& others,
                       Duration end)
    : scene_(scene),
      options_(options),
      outputs_(outputs),
      others_(others),
      start_(scene.simulation().now()),
      end_(end) {}

void RunAdvance::run(Steering& steering) {
  try {
    is_steered(options_) ? run_steered(steering) : run_alone();
  } catch (const control_software::SoftwareCrash&) {
    crashed_ = true;  // reports of the run are written all the same
  }
  line_.hide();
}

void RunAdvance::run_alone() {
  Clock clock(speed_of(options_));
  clock.publish_overruns([&](const Overrun& overrun) { warn(overrun.simulated, scene::to_text(overrun.lateness)); });
  PictureSequence* pictures = outputs_.pictures();
  while (pictures && !lacks_pictures_ && pictures->next() <= end_) {
    advance_to(pictures->next(), clock);
    if (interrupted()) return;
    take(*pictures);
  }
  advance_to(end_, clock);
}

/// The run goes on without pictures if the disk is full.
void RunAdvance::take(PictureSequence& pictures) {
  try {
    pictures.take();
  } catch (const SetupError& error) {
    warn(scene_.simulation().now(), fmt::format("no more pictures: {}", error.what()));
    lacks_pictures_ = true;
  }
}

void RunAdvance::advance_to(Duration time, Clock& clock) {
  struct AtEnd {  // also if software crashes
    RunAdvance& run;
    const Clock& clock;
    WallClock::time_point start = WallClock::now();
    ~AtEnd() {
      run.wall_ += WallClock::now() - start;
      run.lateness_ = clock.lateness();
    }
  } at_end{*this, clock};
  Simulation& simulation = scene_.simulation();
  simulation.run(std::max(Duration{}, time - simulation.now()), clock, [&](Duration now) { show(now); });
}

/// As browsers and supervisors want.
void RunAdvance::run_steered(Steering& steering) {
  const auto tell = [&](const Overrun& overrun) { warn(overrun.simulated, scene::to_text(overrun.lateness)); };
  session::Session session(scene_, {.speed = speed_of(options_),
                                    .paused = options_.supervision.paused,
                                    .stays = stays_at_end(options_),
                                    .publish_overruns = tell,
                                    .record = outputs_.record_switch(),
                                    .no_way_back = no_way_back(options_)});
  steering.begin(session, scene_, options_, outputs_);
  struct AtEnd {  // also if software crashes
    Steering& steering;
    ~AtEnd() { steering.leave(); }
  } at_end{steering};
  const league::League* const game = others_.game;
  const auto view = web_view_of(scene_, session, options_.web, {game ? game->game() : nullptr, others_.drawing});
  const auto services = services_of(session, others_.ros2, steering);
  const auto start = WallClock::now();
  session.run(end_, [&](Duration now) { show(now); });
  wall_ = WallClock::now() - start;
  lateness_ = session.lateness();
}

void RunAdvance::show(Duration now) {
  const double share = end_ > Duration{} ? seconds(now) / seconds(end_) : 1;
  const std::string rate =
      rate_of(seconds(now - start_), std::chrono::duration<double>(WallClock::now() - wall_start_).count());
  line_.show(share, fmt::format("{:.1f} of {:.1f} s{}{}", seconds(now), seconds(end_), rate.empty() ? "" : ", ", rate));
  if (told_of_trouble_ || outputs_.trouble().empty()) return;
  warn(now, "nothing is recorded any more: " + outputs_.trouble());
  told_of_trouble_ = true;
}

void RunAdvance::warn(Duration now, const std::string& text) {
  line_.hide();
  say_warning(fmt::format("{:.1f} s: {}", seconds(now), text));
}

}  // namespace murosimf::app
