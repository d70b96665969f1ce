#include "murosimf/web/foxglove_live.h"

#include <algorithm>
#include <deque>
#include <exception>
#include <optional>
#include <set>
#include <utility>

#include "murosimf/math/assert.h"
#include "murosimf/recording/recorded_external_drawings.h"
#include "murosimf/recording/recorded_picture.h"

namespace murosimf::web {
namespace {

using namespace std::chrono_literals;

constexpr auto between_frames = 33ms;  // [wall]
constexpr auto while_it_stands = 1s;   // [wall] period of repeated frames, for new clients

const std::set<std::string>& sent() {
  static const std::set<std::string> what = {"poses", "scene", "joints", "contacts", "sensors", "events", "drawings"};
  return what;
}

}  // namespace

/// Data filled in by the simulation's thread, one visit at a time; its prerequisites are kept until entities are added.
struct FoxgloveLive::Visit {
  std::uint64_t setups = 0;
  std::string scene_name;
  std::size_t count = 0;  // of entities in the world
  std::vector<recording::RecordedEntity> entities;
  std::vector<recording::RecordedSensor> sensors;
  std::vector<recording::RecordedCamera> cameras;
  std::shared_ptr<std::deque<sensors::CameraFrame>> infos;  // targets of `cameras`: copies, without pictures
  std::unique_ptr<recording::SceneLooks> looks;
  recording::SketchWatch sketches;
  recording::OthersWatch others;
  int changes = -1;
  std::size_t events = 0, warnings = 0;  // sent so far

  bool again = false;  // even if time stands still
  recording::RecordedFrame frame;
  std::map<std::string, std::string> parameters;

  void set_up(scene::Scene& scene) {
    const World& world = scene.simulation().world();
    count = world.entities().size();
    changes = scene.parts().changes_to_see;
    entities = recording::recorded_entities(world);
    sensors = recording::recorded_sensors(world);
    cameras = recording::recorded_cameras(entities);
    infos = std::make_shared<std::deque<sensors::CameraFrame>>();
    for (recording::RecordedCamera& camera : cameras) {
      camera.shown = &infos->emplace_back(sensors::CameraFrame{.info = camera.shown->info});
    }
    looks = std::make_unique<recording::SceneLooks>(scene, entities);
    scene_name = scene.spec().name;
    sketches = recording::SketchWatch(true);
    others.meet(world, entities);
    ++setups;
  }

  void make(scene::Scene& scene) {
    Simulation& simulation = scene.simulation();
    if (count != simulation.world().entities().size() || changes != scene.parts().changes_to_see) set_up(scene);
    frame = {.time = simulation.now()};
    recording::take_numbers(entities, frame);
    simulation.poses().add_contacts(simulation.world(), frame.contacts);
    for (std::size_t i = 0; i < sensors.size(); ++i) take_sample(i);
    sketches.take(entities, frame);
    events = std::min(events, simulation.events().size());  // a reset drops them
    warnings = std::min(warnings, simulation.warnings().size());
    for (; events < simulation.events().size(); ++events) {
      frame.events.emplace_back(simulation.events()[events].time, simulation.events()[events].text);
    }
    for (; warnings < simulation.warnings().size(); ++warnings) {
      frame.warnings.emplace_back(frame.time, simulation.warnings()[warnings]);
    }
    for (const Entity* entity : scene.moving_entities()) {
      if (!entity->level.empty()) parameters[entity->name() + ".level"] = entity->level;
      if (!entity->contact.empty()) parameters[entity->name() + ".contact"] = entity->contact;
    }
  }

  void take_sample(std::size_t i) {
    const sensors::Reading& reading = *sensors[i].reading;
    if (reading.samples == 0 || (reading.samples == sensors[i].samples && !again)) return;
    sensors[i].samples = reading.samples;
    frame.samples.push_back({.sensor = i, .arrived = frame.time, .taken = reading.time, .values = reading.values});
  }
};

FoxgloveLive::FoxgloveLive(session::Session& session, const CameraSubscriptions& cameras,
                           const drawing::DebugDrawSource* others)
    : session_(session), camera_subscriptions_(cameras), others_(others) {}

FoxgloveLive::~FoxgloveLive() = default;

void FoxgloveLive::subscribe(std::uint16_t channel, bool on) {
  MUROSIMF_ASSERT(channel >= 1 && channel <= channels_.size());
  int& count = subscribers_[channel];
  count += on ? 1 : -1;
  MUROSIMF_ASSERT(count >= 0);
  if (count > 0) return;
  subscribers_.erase(channel);
  const std::string camera = camera_of(channels_[channel - 1U].topic);
  if (camera.empty()) return;
  last_.erase(channel);  // later subscriptions get the picture of that time
  if (pictures_ && !wanted_cameras().contains(camera)) pictures_->forget(camera);
}

std::set<std::string> FoxgloveLive::wanted_cameras() const {
  std::set<std::string> wanted;
  for (const auto& [channel, count] : subscribers_) wanted.insert(camera_of(channels_[channel - 1U].topic));
  wanted.erase("");
  return wanted;
}

std::string FoxgloveLive::trouble_of(std::uint16_t channel) const {
  MUROSIMF_ASSERT(channel >= 1 && channel <= channels_.size());
  const std::string camera = camera_of(channels_[channel - 1U].topic);
  const auto seen = camera.empty() ? std::nullopt : camera_subscriptions_.seen(camera);
  if (!camera.empty() && pictures_ && !pictures_->trouble().empty()) return pictures_->trouble();
  return seen ? seen->trouble : "";
}

/// Pictures are compressed in a thread of their own: a picture that is not finished skips this one.
void FoxgloveLive::take_pictures() {
  if (!pictures_ || !pictures_->is_free()) return;
  const auto add = [&](const std::string& topic, const std::string& name, const std::string& schema) {
    return add_channel(topic, "protobuf", add_schema(name, "protobuf", schema), {});
  };
  for (const Packet& packet : pictures_->take(add)) {
    if (subscribers_.contains(packet.channel)) put(packet);
  }
  pictures_->make(camera_subscriptions_, wanted_cameras());
}

std::uint16_t FoxgloveLive::add_schema(const std::string& name, const std::string&, std::string data) {
  const auto known = std::ranges::find(schemas_, name, [](const auto& schema) { return schema.first; });
  if (known != schemas_.end()) return static_cast<std::uint16_t>(known - schemas_.begin());
  schemas_.emplace_back(name, std::move(data));
  return static_cast<std::uint16_t>(schemas_.size() - 1);
}

std::uint16_t FoxgloveLive::add_channel(const std::string& topic, const std::string&, std::uint16_t schema,
                                        recording::TextMap) {
  const auto known = std::ranges::find(channels_, topic, &FoxgloveChannel::topic);
  if (known != channels_.end()) return known->id;
  MUROSIMF_ASSERT(schema < schemas_.size());
  const auto id = static_cast<std::uint16_t>(channels_.size() + 1);
  channels_.push_back(
      {.id = id, .topic = topic, .schema_name = schemas_[schema].first, .schema = schemas_[schema].second});
  return id;
}

void FoxgloveLive::write(std::uint16_t channel, Duration time, std::string_view data) {
  put({.channel = channel, .time = time, .bytes = std::make_shared<const std::string>(data)});
}

void FoxgloveLive::put(const Packet& packet) {
  last_[packet.channel] = packet;
  news_.push_back(packet);
}

FoxgloveLive::Packet FoxgloveLive::last(std::uint16_t channel) const {
  const auto found = last_.find(channel);
  return found == last_.end() ? Packet{} : found->second;
}

bool FoxgloveLive::is_of_lines(std::uint16_t channel) const {
  MUROSIMF_ASSERT(channel >= 1 && channel <= channels_.size());
  const std::string& name = channels_[channel - 1U].schema_name;
  return name == "foxglove.Log";
}

/// New writers send everything again.
void FoxgloveLive::renew_writers(Visit& visit) {
  recording::MessageSink& sink = *this;
  writer_ = std::make_unique<recording::FrameWriter>(sink, visit.entities, visit.sensors, visit.looks.get(), sent());
  drawings_ = std::make_unique<recording::DrawingWriter>(sink, *writer_);
  visit.sketches = recording::SketchWatch(true);
  visit.others.say_again();
}

void FoxgloveLive::take(Visit& visit) {
  const std::uint64_t jumps = session_.status().jumps;
  if (!writer_ || setups_ != visit.setups || jumps_ != jumps) {  // a writer relies on increasing time
    renew_writers(visit);
    if (!pictures_ || setups_ != visit.setups)
      pictures_ = std::make_unique<FoxglovePictures>(visit.infos, visit.cameras);
    setups_ = visit.setups;
    jumps_ = jumps;
  }
  scene_name_ = visit.scene_name;
  parameters_ = visit.parameters;
  time_ = visit.frame.time;
  writer_->write(visit.frame);
  if (others_) visit.others.take(*others_->shown(), visit.frame);
  drawings_->write(visit.frame);
}

void FoxgloveLive::look() {
  news_.clear();
  if (clients_ == 0) return;
  take_pictures();
  if (visited_.valid()) {
    if (visited_.wait_for(0s) != std::future_status::ready) return;
    try {
      visited_.get();
      take(*visit_);
    } catch (const std::exception&) {  // the run has ended: the last data stay
    }
  }
  const auto now = std::chrono::steady_clock::now();
  const session::SessionStatus status = session_.status();
  const bool stands = visit_ && status.time == time_ && status.jumps == jumps_;
  if (now < next_visit_ + (stands ? while_it_stands : 0s)) return;
  next_visit_ = now + between_frames;
  if (!visit_) visit_ = std::make_shared<Visit>();
  visit_->again = stands;
  visited_ = session_.visit([visit = visit_](scene::Scene& scene) { visit->make(scene); });
}

}  // namespace murosimf::web
