#include "murosimf/recording/recorder.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "murosimf/model/error.h"
#include "murosimf/recording/attached_files.h"
#include "murosimf/recording/state_file.h"
#include "murosimf/scene/scene_labels.h"

namespace murosimf::recording {
namespace {

constexpr Duration batch_span = std::chrono::milliseconds(100);  // of simulated time
// With a batch on its way, and those that wait, less than a second of simulated time is not in the file.
constexpr Duration chunk_span = std::chrono::milliseconds(400);
constexpr Duration hash_period = std::chrono::seconds(1);
constexpr Duration others_period = std::chrono::milliseconds(40);  // between looks at their drawings: eyes need no more

Duration period_of(double rate, double fastest) {
  if (rate >= slowest_rate && rate <= fastest) return from_seconds(1 / rate);
  throw SetupError(fmt::format("poses cannot be recorded at {} Hz; write a rate from {} to the {} steps per second",
                               rate, slowest_rate, fastest));
}

}  // namespace

Recorder::Recorder(scene::Scene& scene, const RecorderOptions& options)
    : scene_(scene),
      rate_(options.rate),
      period_(period_of(options.rate, scene.spec().rate)),
      what_(options.what),
      program_(options.program),
      command_line_(options.command_line),
      files_read_(options.files),
      files_of_(options.files_of),
      state_period_(options.state_period),
      ticks_(options.ticks),
      run_(options.run),
      file_(options.file, {.library = options.program, .chunk_span = chunk_span}),
      others_(what_.contains("drawings") ? options.others : nullptr),
      keep_(options.keep),
      after_(options.after),
      outside_(scene.parts().outside.notes.get()) {
  if (!options.record_on.empty()) {
    if (what_.contains("pictures")) throw SetupError("pictures of cameras are not kept until something happens");
    watch_.emplace(scene, options.record_on);
    what_.insert("states");  // what is kept begins with one
    state_period_ = std::min(state_period_, std::max(keep_ / 4, batch_span));
  }
  if (what_.contains("pictures")) want_pictures(scene.simulation().world());
  thread_ = std::make_unique<RecordingThread>([this](const RecordingThread::Batch& batch) { write(batch); });
  // later than the simulation's schedule is made: a state that is loaded knows nothing of the recorder
  const auto begin = [this] { scene_.simulation().at(Duration{}, [this] { start(); }); };
  scene.simulation().after_start(begin);
  if (options.in_the_middle) begin();
}

Recorder::~Recorder() = default;

void Recorder::describe() {
  Metadata run = run_metadata(scene_, program_, paths_.in_command_line(command_line_));
  run.values["record_rate_hz"] = fmt::format("{}", rate_);
  file_.add(run);
  std::vector<std::string> robots;
  for (const scene_file::RobotSpec& robot : scene_.spec().robots) robots.push_back(robot.name);
  attach_text("layout.json", foxglove_layout(robots));
}

void Recorder::attach_text(const std::string& name, const std::string& text) {
  file_.attach(text_attachment(name, text, scene_.simulation().now()));
}

/// Whether nothing is wrong with the file.
template <class Call>
bool Recorder::on_file(const Call& call) {
  if (!trouble().empty()) return false;
  try {
    call();
  } catch (const SetupError& error) {
    file_trouble_ = error.what();
  }
  return file_trouble_.empty();
}

void Recorder::start() {
  if (finished_) return;
  if (frames_) throw SetupError("a recording is of one run: this one began anew");
  const World& world = scene_.simulation().world();
  entities_ = recorded_entities(world);
  others_watch_.meet(world, entities_);
  if (what_.contains("sensors")) sensors_ = recorded_sensors(world);
  if (what_.contains("pictures")) cameras_ = recorded_cameras(entities_);
  if (what_.contains("scene")) looks_ = std::make_unique<SceneLooks>(scene_, entities_);
  if (files_read_) {
    paths_ = RecordedPaths(files_read_->list(), files_read_->names());
    files_now_ = files_now(files_read_->list(), paths_);
  }
  if (!watch_ && !on_file([this] { begin_file(); })) return;
  frames_ = std::make_unique<FrameWriter>(file_, entities_, sensors_, looks_.get(), what_);
  pictures_ = std::make_unique<PictureWriter>(file_, *frames_, cameras_, scene::label_table_json(scene_));
  drawings_ = std::make_unique<DrawingWriter>(file_, *frames_);
  next_frame_ = next_hash_ = next_state_ = next_others_ = scene_.simulation().now();
  look();
}

/// Files of meshes are known only when the scene is initialized; what is kept before an event begins with a state.
void Recorder::begin_file() {
  if (began_) return;
  began_ = true;
  file_.begin();
  describe();
  if (files_read_) attach_files(file_, files_now_);
  if (files_of_) copy_files(file_, *files_of_);
  if (!run_) return;
  run_->start = held_.empty() ? scene_.simulation().now() : held_.front().front().time;
  if (files_read_) {
    run_->names = files_read_->names();
    run_ = paths_.in_description(*std::move(run_));
  }
  if (outside_) {
    run_->outside.clear();  // it is in the recording
    run_->channels = outside_->names();
  }
  attach_text("run.json", to_json(*run_));
}

bool Recorder::in_every_tick() const {
  const Duration now = scene_.simulation().now();
  return ticks_ && now >= ticks_->begin && now <= ticks_->end;
}

/// Sensors and cameras have rates of their own: they are looked at after every step.
Duration Recorder::next_look() const {
  const Duration next_step = scene_.simulation().now() + scene_.simulation().tick();
  if (!sensors_.empty() || !cameras_.empty() || in_every_tick()) return next_step;
  if (ticks_ && ticks_->begin >= next_step) return std::min(next_frame_, ticks_->begin);
  return next_frame_;
}

/// Between two steps: what is due is taken.
void Recorder::look() {
  if (finished_) return;
  Simulation& simulation = scene_.simulation();
  const Duration now = simulation.now();
  if (now >= next_frame_) {
    take_frame();
    while (next_frame_ <= now) next_frame_ += period_;
  } else {
    RecordedFrame frame{.time = now};
    take_samples(frame);
    take_state(frame);
    if (!frame.samples.empty() || !frame.pictures.empty() || frame.hash) add(std::move(frame));
  }
  simulation.at(next_look(), [this] { look(); });
}

void Recorder::take_frame(bool is_last) {
  const Simulation& simulation = scene_.simulation();
  RecordedFrame frame = new_frame();
  take_numbers(entities_, frame);
  constexpr std::size_t usual_contacts = 64;
  frame.contacts.reserve(what_.contains("contacts") ? usual_contacts : 0);
  if (what_.contains("contacts")) touching_.add(simulation.world(), frame.contacts);
  take_samples(frame);
  take_drawings(frame, is_last);
  take_lines(frame);
  take_state(frame, is_last);
  if (watch_) watch(frame);
  last_frame_ = frame.time;
  add(std::move(frame));
}

/// Of now, in the memory of one that was written, if there is one.
RecordedFrame Recorder::new_frame() {
  RecordedFrame frame;
  if (!spare_.empty()) {
    frame = std::move(spare_.back());
    spare_.pop_back();
  }
  frame.begin_anew(scene_.simulation().now());
  return frame;
}

/// Hash and state, if they are due. A run that does not begin at the time 0 began with a state.
void Recorder::take_state(RecordedFrame& frame, bool is_last) {
  const bool dense = in_every_tick(), loaded = !last_frame_ && frame.time > Duration{};
  const bool state = dense || loaded || (what_.contains("states") && (is_last || frame.time >= next_state_));
  const bool hash = state || (what_.contains("hashes") && (is_last || frame.time >= next_hash_));
  if (hash) frame.hash = scene_.simulation().state_hash();
  if (state) frame.state = scene_.save();
  while (hash && next_hash_ <= frame.time) next_hash_ += hash_period;
  while (state && next_state_ <= frame.time) next_state_ += state_period_;
}

void Recorder::take_samples(RecordedFrame& frame) {
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    const sensors::Reading& reading = *sensors_[i].reading;
    if (reading.samples == sensors_[i].samples) continue;
    sensors_[i].samples = reading.samples;
    frame.samples.push_back({.sensor = i, .arrived = frame.time, .taken = reading.time, .values = reading.values});
  }
  take_pictures(cameras_, frame);
}

void Recorder::take_drawings(RecordedFrame& frame, bool is_last) {
  if (what_.contains("drawings")) sketches_.take(entities_, frame);
  if (!others_ || (!is_last && frame.time < next_others_)) return;
  others_watch_.take(*others_->shown(), frame);
  next_others_ = frame.time + others_period;
}

void Recorder::take_lines(RecordedFrame& frame) {
  const Simulation& simulation = scene_.simulation();
  for (; events_ < simulation.events().size(); ++events_) {
    frame.events.emplace_back(simulation.events()[events_].time, paths_.in_text(simulation.events()[events_].text));
  }
  for (; commands_ < simulation.commands().size(); ++commands_) {
    frame.commands.emplace_back(simulation.commands()[commands_].time, simulation.commands()[commands_].text);
  }
  for (; warnings_ < simulation.warnings().size(); ++warnings_) {
    frame.warnings.emplace_back(frame.time, paths_.in_text(simulation.warnings()[warnings_]));
  }
  if (outside_) frame.outside = outside_->take();
}

void Recorder::add(RecordedFrame&& frame) {
  if (watch_ && !frame.state.empty()) hand_over();  // states begin batches
  batch_.push_back(std::move(frame));
  if (batch_.back().time - batch_.front().time >= batch_span) hand_over();
}

/// The present one is held; frames that were written are kept for those to come.
void Recorder::begin_batch() {
  RecordingThread::Batch spent = thread_->spent();
  for (RecordedFrame& frame : spent) {
    if (frame.of_poses) spare_.push_back(std::move(frame));
  }
  spent.clear();
  spent.reserve(batch_.size() + batch_.size() / 4);
  held_.push_back(std::move(batch_));
  batch_ = std::move(spent);
}

void Recorder::hand_over() {
  if (batch_.empty()) return;
  const Duration begin = batch_.front().time;
  begin_batch();
  if (watch_ && !asked_ && begin > write_until_) return forget_old();
  if (on_file([this] { begin_file(); })) {
    for (RecordingThread::Batch& batch : held_) thread_->push(std::move(batch));
  }
  held_.clear();
}

/// In the thread.
void Recorder::write(const RecordingThread::Batch& batch) {
  for (const RecordedFrame& frame : batch) {
    frames_->write(frame);
    pictures_->write(frame);
    drawings_->write(frame);
  }
  const auto now = std::chrono::steady_clock::now();
  if (now - synced_ < std::chrono::seconds(1)) return;
  file_.sync();  // what a loss of power leaves, at most a second old
  synced_ = now;
}

void Recorder::finish(const scene::RunReport& report) {
  if (!frames_ && trouble().empty()) start();  // of a run without steps
  finished_ = true;
  if (!frames_) return;

  // after the last step
  const bool changed = commands_ < scene_.simulation().commands().size() || (outside_ && !outside_->empty());
  if (changed || last_frame_ != scene_.simulation().now()) take_frame(true);
  hand_over();
  (void)on_file([this] { begin_file(); });
  thread_->finish();
  (void)on_file([&] {
    texts_.emplace_back("report.txt", paths_.in_text(scene::to_text(report)));
    texts_.emplace_back("report.json", paths_.in_text(scene::to_json(report)));
    for (const auto& [name, text] : texts_) attach_text(name, text);
    file_.close();
  });
}

std::string Recorder::trouble() const {
  const std::string trouble = thread_->trouble();
  return trouble.empty() ? file_trouble_ : trouble;
}

}  // namespace murosimf::recording
