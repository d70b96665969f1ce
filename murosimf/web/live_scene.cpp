#include "murosimf/web/live_scene.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "murosimf/web/drawings_message.h"
#include "murosimf/web/entity_states.h"
#include "murosimf/web/json_line.h"
#include "murosimf/web/picture_message.h"
#include "murosimf/web/pose_message.h"
#include "murosimf/web/watched_numbers.h"

namespace murosimf::web {
namespace {

using nlohmann::json;
using namespace std::chrono_literals;

constexpr auto between_visits = 100ms;   // [wall]
constexpr auto between_numbers = 40ms;   // while numbers are plotted
constexpr Duration frame_period = 16ms;  // [wall] of poses

json state_of(const session::SessionStatus& status, const json& entities, const json& beliefs, const json& game) {
  const Duration known = std::max(status.time, status.last);
  const bool endless = status.end == Duration::max();
  return {{"is", "state"},
          {"state",
           {{"time", seconds(status.time)},
            {"begin", seconds(status.first)},
            {"last", seconds(known)},
            {"end", seconds(endless ? known : std::max(known, status.end))},
            {"paused", status.paused},
            {"speed", status.speed ? json(*status.speed) : json(nullptr)},
            {"factor", status.factor},
            {"branch", status.branch},
            {"jumps", status.jumps},
            {"diagnostic", status.diagnostic},
            {"entities", entities},
            {"beliefs", beliefs},
            {"game", game}}}};
}

/// Source of a camera's pictures, or the reason why there are none.
json note_of(const std::string& camera, const SeenPicture& seen) {
  return {{"is", "camera"}, {"camera", camera}, {"own", seen.own}, {"trouble", seen.trouble}};
}

}  // namespace

/// Data filled in by the simulation's thread, one visit at a time.
struct LiveScene::Visit {
  const league::GameTask* referee = nullptr;
  // requested
  bool publish = false;  // poses, for a reader that has none yet
  int known_changes = -1;
  std::size_t known_entities = 0;
  std::vector<std::string> paths;
  std::uint64_t known_drawings = 0;  // drawing::drawn_changes

  // results
  std::shared_ptr<const SceneDocument> document;
  int changes = -1;
  double time = 0;  // [s]
  json entities, beliefs, game, lines;
  std::vector<std::pair<std::string, std::optional<double>>> values;
  bool is_new_drawing = false;
  std::vector<drawing::Drawn> drawn;
  std::vector<std::string> teams;

  WatchedNumbers numbers;  // kept from visit to visit

  void make(scene::Scene& scene) {
    Simulation& simulation = scene.simulation();
    changes = scene.parts().changes_to_see;
    if (changes != known_changes || simulation.world().entities().size() != known_entities) {
      document = std::make_shared<SceneDocument>(scene_document(scene));
    }
    time = seconds(simulation.now());
    entities = entity_states(simulation.world());
    beliefs = beliefs_of(simulation.world());
    game = game_of(referee);
    lines = lines_of(simulation);
    values = numbers.read(simulation.world(), paths);
    if (publish || document) simulation.publish_poses();
    take_drawings(simulation.world());
  }

  void take_drawings(const World& world) {
    const std::uint64_t changes_of_drawings = drawing::drawn_changes(world);
    is_new_drawing = known_drawings != changes_of_drawings || document;
    known_drawings = changes_of_drawings;
    if (!is_new_drawing) return;
    drawn = drawing::drawn_by_robots(world);
    teams = drawing::teams_of(world);
  }
};

/// At many times real time, frames for display are farther apart in simulated time.
void LiveScene::subscribe(const Requests& requests) {
  const double factor = std::max(1.0, session_.status().factor);
  const auto period = std::chrono::duration_cast<Duration>(0.9 * factor * frame_period);
  const bool fits = reader_ && period < 2 * request_.period && request_.period < 2 * period;
  if (fits && request_.contacts == requests.contacts) return;
  request_ = {.period = period, .contacts = requests.contacts};
  reader_ = poses_.subscribe(request_);
  is_new_reader_ = true;
}

void LiveScene::read_poses(const Requests& requests) {
  if (!reader_ || !scene_) return;
  const PoseFrame* frame = reader_->latest();
  if (!frame || frame->first.size() <= scene_->entities) return;  // of other entities than the document
  shown_ = frame->time;
  const std::uint64_t jumps = session_.status().jumps;
  news_.poses = last_.poses = binary_message(pose_message(*scene_, *frame, jumps, false));
  if (requests.contacts) news_.poses_with_contacts = binary_message(pose_message(*scene_, *frame, jumps, true));
}

void LiveScene::take(const Visit& visit) {
  if (visit.document) {
    scene_ = visit.document;
    changes_ = visit.changes;
    document_message_ = binary_message(std::string{static_cast<char>(MessageKind::scene), 0, 0, 0} + scene_->bytes);
    ++documents_;
    last_.poses = {};  // of bodies of the old document
  }
  const std::string state = json_line(state_of(session_.status(), visit.entities, visit.beliefs, visit.game));
  if (std::exchange(state_, state) != state) news_.state = last_.state = text_message(state);
  const std::string lines = json_line({{"is", "lines"}, {"lines", visit.lines}});
  if (std::exchange(lines_, lines) != lines) news_.lines = last_.lines = text_message(lines);
  if (!visit.values.empty()) {
    json values = json::object();
    for (const auto& [path, value] : visit.values) values[path] = value ? json(*value) : json(nullptr);
    news_.values = text_message(json_line({{"is", "values"}, {"time", visit.time}, {"values", values}}));
  }
  take_drawings(visit);
}

void LiveScene::take_pictures(const Requests& requests) {
  wanted_cameras_ = {requests.cameras.begin(), requests.cameras.end()};
  const auto is_forgotten = [&](const auto& one) { return !wanted_cameras_.contains(one.first); };
  std::erase_if(last_.pictures, is_forgotten);
  std::erase_if(last_.camera_notes, is_forgotten);
  std::erase_if(told_pictures_, is_forgotten);
  for (const std::string& camera : requests.cameras) {
    const std::optional<SeenPicture> seen = cameras_.seen(camera);
    if (!seen || std::exchange(told_pictures_[camera], seen->number) == seen->number) continue;
    const Message note = text_message(json_line(note_of(camera, *seen)));
    Message& known = last_.camera_notes[camera];
    if (!known.bytes || *known.bytes != *note.bytes) news_.camera_notes[camera] = known = note;
    const std::string picture = seen->frame ? picture_message(*seen->frame) : "";
    if (!picture.empty()) news_.pictures[camera] = last_.pictures[camera] = binary_message(picture);
  }
}

void LiveScene::take_drawings(const Visit& visit) {
  const auto others = others_ ? others_->shown() : nullptr;
  const std::uint64_t changes_of_others = others ? others->changes : 0;
  if (!visit.is_new_drawing && changes_of_others == drawn_by_others_) return;
  drawn_by_others_ = changes_of_others;
  if (visit.is_new_drawing) {
    drawn_ = visit.drawn;
    teams_ = visit.teams;
  }
  std::vector<drawing::Drawn> all = drawn_;
  if (others) std::ranges::move(drawing::external_drawings(*others, teams_), std::back_inserter(all));
  if (all.empty() && !is_drawn_) return;
  is_drawn_ = !all.empty();
  news_.drawings = last_.drawings = text_message(drawings_message(all));
}

void LiveScene::ask(const Requests& requests) {
  if (!visit_) visit_ = std::make_shared<Visit>();
  Visit& visit = *visit_;
  visit.referee = game_;
  // frames arrive periodically; the instant of a pause must be shown exactly
  const session::SessionStatus status = session_.status();
  visit.publish = std::exchange(is_new_reader_, false) || (status.paused && status.time != shown_);
  visit.known_changes = changes_;
  visit.known_entities = scene_ ? scene_->entities : 0;
  visit.paths = requests.numbers;
  visit.document = nullptr;
  visited_ = session_.visit([visit = visit_](scene::Scene& scene) { visit->make(scene); });
}

void LiveScene::look() {
  news_ = {};
  Requests requests;
  for (const Subscriber* subscriber : subscribers_) subscriber->add(requests);
  take_pictures(requests);
  if (requests.clients == 0) {
    reader_ = nullptr;  // no copies without clients
    last_.poses = {};
    return;
  }
  subscribe(requests);
  if (visited_.valid()) {
    if (visited_.wait_for(0s) != std::future_status::ready) return read_poses(requests);
    try {
      visited_.get();
      take(*visit_);
    } catch (const std::exception&) {  // the run has ended: the last data stay
    }
  }
  read_poses(requests);
  const auto now = std::chrono::steady_clock::now();
  if (now < next_visit_) return;
  const bool often = is_drawn_ || !requests.numbers.empty();
  next_visit_ = now + (often ? between_numbers : between_visits);
  ask(requests);
}

}  // namespace murosimf::web
