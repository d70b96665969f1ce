#include "murosimf/soccer/localize.h"

#include <cmath>
#include <limits>

#include "murosimf/locomotion/gait_properties.h"
#include "murosimf/math/assert.h"
#include "murosimf/soccer/behavior_properties.h"
#include "murosimf/soccer/dead_reckoning.h"
#include "murosimf/soccer/walk_to.h"

namespace murosimf::soccer {
namespace {

constexpr double arrived = 0.25;  // [m] from a waypoint

/// Writes at most `most` of the points to `chosen`, evenly chosen.
void thin_out(const std::vector<soccer::LinePoint>& points, std::size_t most, std::vector<soccer::LinePoint>& chosen) {
  chosen.clear();
  const std::size_t count = std::min(most, points.size());
  for (std::size_t i = 0; i < count; ++i) {
    MUROSIMF_ASSERT(i * points.size() / count < points.size());
    chosen.push_back(points[i * points.size() / count]);
  }
}

}  // namespace

void append_hash(Hasher& hasher, const Particles& particles) {
  for (const soccer::Particle& particle : particles.all) {
    append_hash(hasher, particle.pose);
    hasher.add(particle.weight);
  }
}

Localize::Localize(Setup& setup, const LocalizeOptions& options)
    : options_(options),
      frame_(sensors::read_frame(setup, options.camera)),
      body_(setup, *frame_.info),
      lines_(options.markings),
      filter_(options.filter, options.seed, setup.entity().name() + "/localize"),
      velocity_(setup.read(properties::gait_velocity)[0]),
      command_(setup.write(properties::walk_command)[0]),
      estimate_(setup.write(properties::pose_estimate)[0]),
      spread_(setup.write(properties::pose_spread)[0]),
      waypoint_(setup.write(properties::next_waypoint)[0]),
      particles_(setup.write(possible_poses)[0]) {
  seen_.reserve(options.scan.most);
}

void Localize::initialize() {
  command_ = {};
  waypoint_ = 0;
  particles_.all = filter_.scatter(options_.start);
  MUROSIMF_ASSERT(!particles_.all.empty());
  particles_.points.reserve(options_.most_points);
  particles_.points.clear();
  particles_.frame = 0;
  particles_.heading = std::numeric_limits<double>::quiet_NaN();
  const soccer::PoseEstimate first = soccer::estimate(particles_.all);
  estimate_ = first.pose;
  spread_ = first.spread;
}

void Localize::step(const Instant& instant) noexcept {
  const double before = particles_.heading;
  if (!body_.sense()) return;
  particles_.heading = body_.heading();
  // Number of the step, rounded: random numbers of a step are addressed by it, also after a restored state.
  const auto number = static_cast<std::uint64_t>((instant.now + instant.period / 2) / instant.period);
  if (std::isfinite(before)) {
    const double dt = seconds(instant.period);
    filter_.move(particles_.all, soccer::step_along(velocity_, soccer::wrapped(body_.heading() - before), dt), dt,
                 number);
  }
  if (frame_.number != particles_.frame) look(number);
  const soccer::PoseEstimate result = soccer::estimate(particles_.all);
  estimate_ = result.pose;
  spread_ = result.spread;
  walk();
}

void Localize::look(std::uint64_t number) noexcept {
  particles_.frame = frame_.number;
  soccer::find_line_points(frame_.color, frame_.info->lens, body_.camera(), options_.scan, seen_);
  // Fewer points than found: neighbors on one line are wrong together and cost time.
  thin_out(seen_, options_.most_points, particles_.points);
  filter_.weigh(particles_.all, particles_.points, lines_);
  filter_.resample(particles_.all, number);
}

void Localize::walk() noexcept {
  if (options_.way.empty()) return;
  const auto place = [&] {
    return soccer::to_frame(estimate_, options_.way[static_cast<std::size_t>(waypoint_) % options_.way.size()]);
  };
  if (std::hypot(place().x, place().y) < arrived) ++waypoint_;
  command_ = walk_to(place(), options_.speed);
}

}  // namespace murosimf::soccer
