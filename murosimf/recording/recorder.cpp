#include "murosimf/recording/recorder.h"

#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "murosimf/model/error.h"
#include "murosimf/recording/attached_files.h"
#include "murosimf/scene/contact_marks.h"

namespace murosimf::recording {
namespace {

constexpr Duration batch_span = std::chrono::milliseconds(100);  // of simulated time
// With a batch on its way, and those that wait, less than a second of simulated time is not in the file.
constexpr Duration chunk_span = std::chrono::milliseconds(400);
constexpr Duration hash_period = std::chrono::seconds(1);

Duration period_of(double rate, double fastest) {
  if (rate >= slowest_rate && rate <= fastest) return from_seconds(1 / rate);
  throw SetupError(fmt::format("poses cannot be recorded at {} Hz; write a rate from {} to the {} steps per second",
                               rate, slowest_rate, fastest));
}

}  // namespace

Recorder::Recorder(scene::Scene& scene, const RecorderOptions& options)
    : scene_(scene),
      period_(period_of(options.rate, scene.spec().rate)),
      what_(options.what),
      files_read_(options.files),
      file_(options.file, {.library = options.program, .chunk_span = chunk_span}) {
  describe(options);
  file_.sync();
  thread_ = std::make_unique<RecordingThread>([this](const RecordingThread::Batch& batch) { write(batch); });
  // later than the simulation's schedule is made: a state that is loaded knows nothing of the recorder
  scene.simulation().after_start([this] { scene_.simulation().at(Duration{}, [this] { start(); }); });
}

Recorder::~Recorder() = default;

void Recorder::describe(const RecorderOptions& options) {
  file_.add({.name = "murosimf",
             .values = {{"program", options.program},
                        {"command_line", options.command_line},
                        {"scene", scene_.spec().name},
                        {"seed", fmt::format("{}", scene_.spec().seed)},
                        {"step_rate_hz", fmt::format("{}", scene_.spec().rate)},
                        {"record_rate_hz", fmt::format("{}", options.rate)}}});
  std::vector<std::string> robots;
  for (const scene_file::RobotSpec& robot : scene_.spec().robots) robots.push_back(robot.name);
  file_.attach({.log_time = 0,
                .create_time = 0,
                .name = "layout.json",
                .media_type = "application/json",
                .data = foxglove_layout(robots)});
}

void Recorder::start() {
  if (frames_) throw SetupError("a recording is of one run: this one began anew");
  const World& world = scene_.simulation().world();
  entities_ = recorded_entities(world);
  if (what_.contains("sensors")) sensors_ = recorded_sensors(world);
  if (what_.contains("scene")) looks_ = std::make_unique<SceneLooks>(scene_, entities_);
  if (files_read_) attach_files(file_, files_read_->list());  // those of meshes are known only now
  frames_ = std::make_unique<FrameWriter>(file_, entities_, sensors_, looks_.get(), what_);
  next_frame_ = next_hash_ = scene_.simulation().now();
  look();
}

/// Between two steps: what is due is taken.
void Recorder::look() {
  Simulation& simulation = scene_.simulation();
  const Duration now = simulation.now();
  if (now >= next_frame_) {
    take_frame();
    while (next_frame_ <= now) next_frame_ += period_;
  } else if (!sensors_.empty()) {
    RecordedFrame frame{.time = now};
    take_samples(frame);
    if (!frame.samples.empty()) add(std::move(frame));
  }
  // sensors have rates of their own: they are looked at after every step
  simulation.at(sensors_.empty() ? next_frame_ : now + simulation.tick(), [this] { look(); });
}

void Recorder::take_frame() {
  const Simulation& simulation = scene_.simulation();
  RecordedFrame frame{.time = simulation.now()};
  take_numbers(entities_, frame);
  constexpr std::size_t usual_contacts = 64;
  frame.contacts.reserve(what_.contains("contacts") ? usual_contacts : 0);
  if (what_.contains("contacts")) scene::add_contact_marks(simulation.world(), frame.contacts);
  take_samples(frame);
  take_lines(frame);
  if (what_.contains("hashes") && frame.time >= next_hash_) {
    frame.hash = simulation.state_hash();
    while (next_hash_ <= frame.time) next_hash_ += hash_period;
  }
  last_frame_ = frame.time;
  add(std::move(frame));
}

void Recorder::take_samples(RecordedFrame& frame) {
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    const sensors::Reading& reading = *sensors_[i].reading;
    if (reading.samples == sensors_[i].samples) continue;
    sensors_[i].samples = reading.samples;
    frame.samples.push_back({.sensor = i, .arrived = frame.time, .taken = reading.time, .values = reading.values});
  }
}

void Recorder::take_lines(RecordedFrame& frame) {
  const Simulation& simulation = scene_.simulation();
  for (; events_ < simulation.events().size(); ++events_) {
    frame.events.emplace_back(simulation.events()[events_].time, simulation.events()[events_].text);
  }
  for (; warnings_ < simulation.warnings().size(); ++warnings_) {
    frame.warnings.emplace_back(frame.time, simulation.warnings()[warnings_]);
  }
}

void Recorder::add(RecordedFrame&& frame) {
  batch_.push_back(std::move(frame));
  if (batch_.back().time - batch_.front().time >= batch_span) hand_over();
}

void Recorder::hand_over() {
  if (batch_.empty()) return;
  const std::size_t usual = batch_.size();
  thread_->push(std::move(batch_));
  batch_ = {};
  batch_.reserve(usual + usual / 4);
}

/// In the thread.
void Recorder::write(const RecordingThread::Batch& batch) {
  for (const RecordedFrame& frame : batch) frames_->write(frame);
  const auto now = std::chrono::steady_clock::now();
  if (now - synced_ < std::chrono::seconds(1)) return;
  file_.sync();  // what a loss of power leaves, at most a second old
  synced_ = now;
}

void Recorder::finish(const scene::RunReport& report) {
  if (!frames_) start();  // of a run without steps
  if (last_frame_ != scene_.simulation().now()) take_frame();
  hand_over();
  thread_->finish();
  if (!trouble().empty()) return;
  try {
    for (const auto& [name, type, text] : {std::tuple{"report.txt", "text/plain", scene::to_text(report)},
                                           std::tuple{"report.json", "application/json", scene::to_json(report)}}) {
      file_.attach({.log_time = static_cast<std::uint64_t>(scene_.simulation().now().count()),
                    .create_time = 0,
                    .name = name,
                    .media_type = type,
                    .data = text});
    }
    file_.close();
    file_.sync();
  } catch (const SetupError& error) {
    end_trouble_ = error.what();
  }
}

std::string Recorder::trouble() const {
  const std::string trouble = thread_->trouble();
  return trouble.empty() ? end_trouble_ : trouble;
}

}  // namespace murosimf::recording
