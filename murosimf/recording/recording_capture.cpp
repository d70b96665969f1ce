#include "murosimf/recording/recording_capture.h"

#include <algorithm>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::recording {
namespace {

constexpr Duration hash_period = std::chrono::seconds(1);
constexpr Duration others_period = std::chrono::milliseconds(40);  // between looks at their drawings: eyes need no more

Duration period_of(double rate, double fastest) {
  if (rate >= slowest_rate && rate <= fastest) return from_seconds(1 / rate);
  throw SetupError(fmt::format("poses cannot be recorded at {} Hz; write a rate from {} to the {} steps per second",
                               rate, slowest_rate, fastest));
}

/// The first instant of this period, counted on from `next`, that is later than `now`.
Duration next_after(Duration next, Duration now, Duration period) {
  MUROSIMF_ASSERT(period > Duration{});
  while (next <= now) next += period;
  return next;
}

}  // namespace

RecordingCapture::RecordingCapture(scene::Scene& scene, CaptureOptions options, const RecordedPaths& paths)
    : scene_(scene),
      options_(std::move(options)),
      paths_(paths),
      period_(period_of(options_.rate, scene.spec().rate)),
      outside_(scene.parts().outside.notes.get()) {
  if (!options_.what.contains("drawings")) options_.others = nullptr;
}

void RecordingCapture::start() {
  meet_newcomers();
  next_frame_ = next_hash_ = next_state_ = next_others_ = scene_.simulation().now();
}

/// Entities that have come are the last of the world, so those of earlier frames keep their numbers.
void RecordingCapture::meet_newcomers() {
  World& world = scene_.simulation().world();
  const std::size_t entities = entities_.size();
  for (; known_ < world.entities().size(); ++known_) {
    Entity& entity = *world.entities()[known_];
    if (has_poses(entity)) entities_.push_back(recorded_entity(entity));
    if (options_.what.contains("sensors")) add_sensors_of(entity, sensors_);
    if (options_.what.contains("pictures")) want_pictures(entity);
  }
  others_watch_.meet(world, entities_);
  if (options_.what.contains("pictures")) add_cameras_of(std::span(entities_).subspan(entities), cameras_);
}

bool RecordingCapture::in_every_tick() const {
  const Duration now = scene_.simulation().now();
  return options_.ticks && now >= options_.ticks->begin && now <= options_.ticks->end;
}

/// Sensors and cameras have rates of their own: they are looked at after every step.
Duration RecordingCapture::next_look() const {
  const Duration next_step = scene_.simulation().now() + scene_.simulation().tick();
  if (!sensors_.empty() || !cameras_.empty() || in_every_tick()) return next_step;
  if (options_.ticks && options_.ticks->begin >= next_step) return std::min(next_frame_, options_.ticks->begin);
  return next_frame_;
}

void RecordingCapture::take_frame(RecordedFrame& frame, bool is_last) {
  const Simulation& simulation = scene_.simulation();
  MUROSIMF_ASSERT((!last_frame_ || *last_frame_ <= simulation.now()) && "frames are taken in the order of time");
  frame.begin_anew(simulation.now());
  take_numbers(entities_, frame);
  constexpr std::size_t usual_contacts = 64;
  frame.contacts.reserve(options_.what.contains("contacts") ? usual_contacts : 0);
  if (options_.what.contains("contacts")) touching_.add(simulation.world(), frame.contacts);
  take_samples(frame);
  take_drawings(frame, is_last);
  take_lines(frame);
  take_state(frame, is_last);
  last_frame_ = frame.time;
  next_frame_ = next_after(next_frame_, frame.time, period_);
}

std::optional<RecordedFrame> RecordingCapture::take_between() {
  RecordedFrame frame{.time = scene_.simulation().now()};
  take_samples(frame);
  take_state(frame);
  if (frame.samples.empty() && frame.pictures.empty() && !frame.hash) return std::nullopt;
  return frame;
}

bool RecordingCapture::has_news() const {
  const Simulation& simulation = scene_.simulation();
  return commands_ < simulation.commands().size() || (outside_ && !outside_->empty()) ||
         last_frame_ != simulation.now();
}

/// Hash and state, if they are due. A run that does not begin at the time 0 began with a state.
void RecordingCapture::take_state(RecordedFrame& frame, bool is_last) {
  const std::set<std::string>& what = options_.what;
  const bool dense = in_every_tick(), loaded = !last_frame_ && frame.time > Duration{};
  const bool state = dense || loaded || (what.contains("states") && (is_last || frame.time >= next_state_));
  const bool hash = state || (what.contains("hashes") && (is_last || frame.time >= next_hash_));
  if (hash) frame.hash = scene_.simulation().state_hash();
  if (state) frame.state = scene_.save();
  if (hash) next_hash_ = next_after(next_hash_, frame.time, hash_period);
  if (state) next_state_ = next_after(next_state_, frame.time, options_.state_period);
}

void RecordingCapture::take_samples(RecordedFrame& frame) {
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    const sensors::Reading& reading = *sensors_[i].reading;
    if (reading.samples == sensors_[i].samples) continue;
    sensors_[i].samples = reading.samples;
    frame.samples.push_back({.sensor = i, .arrived = frame.time, .taken = reading.time, .values = reading.values});
  }
  take_pictures(cameras_, frame);
}

void RecordingCapture::take_drawings(RecordedFrame& frame, bool is_last) {
  if (options_.what.contains("drawings")) sketches_.take(entities_, frame);
  if (!options_.others || (!is_last && frame.time < next_others_)) return;
  others_watch_.take(*options_.others->shown(), frame);
  next_others_ = frame.time + others_period;
}

void RecordingCapture::take_lines(RecordedFrame& frame) {
  const Simulation& simulation = scene_.simulation();
  const auto& events = simulation.events();
  const auto& commands = simulation.commands();
  const auto& warnings = simulation.warnings();
  for (; events_ < events.size(); ++events_) {
    frame.events.emplace_back(events[events_].time, paths_.in_text(events[events_].text));
  }
  for (; commands_ < commands.size(); ++commands_) {
    frame.commands.emplace_back(commands[commands_].time, commands[commands_].text);
  }
  for (; warnings_ < warnings.size(); ++warnings_) {
    frame.warnings.emplace_back(frame.time, paths_.in_text(warnings[warnings_]));
  }
  if (outside_) frame.outside = outside_->take();
}

}  // namespace murosimf::recording
