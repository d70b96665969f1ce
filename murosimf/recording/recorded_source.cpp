#include "murosimf/recording/recorded_source.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"
#include "murosimf/recording/topics.h"
#include "murosimf/world/drawing.h"

namespace murosimf::recording {
namespace {

constexpr std::string_view arrow = " -> ";  // in events about a change of level

template <class T>
Column<T>* column_of(Entity& entity, const Property<T>& property) {
  return dynamic_cast<Column<T>*>(entity.find(property.name));
}

void set_number(Entity& entity, const Property<double>& property, int object, double value) {
  if (std::isnan(value)) return;  // not recorded
  if (Column<double>* column = column_of(entity, property)) column->values[static_cast<std::size_t>(object)] = value;
}

}  // namespace

RecordedSource::RecordedSource(std::shared_ptr<const recording::RecordedRun> run,
                               const recording::RepeatOptions& options,
                               std::shared_ptr<drawing::DebugDrawBuffer> others)
    : run_(std::move(run)), scene_(run_->build_to_show(options)), drawings_(run_->file()), others_(std::move(others)) {
  run_->initialize(*scene_);
  run_->add_all(*scene_);
  make_room_for_drawings();
  entities_ = recording::recorded_entities(scene_->simulation().world());
  others_then_.emplace(scene_->simulation().world());
  frames_ = std::make_unique<recording::FrameReader>(run_->file(), entities_);
  for (const PropertyInfo& info :
       std::initializer_list<PropertyInfo>{properties::position, properties::orientation, properties::joint_position,
                                           properties::joint_velocity, properties::joint_torque,
                                           properties::joint_target}) {
    known_.emplace_back(info.name);
  }
  read_lines();
}

RecordedSource::~RecordedSource() = default;

/// Robots whose software drew have none here.
void RecordedSource::make_room_for_drawings() {
  World& world = scene_->simulation().world();
  const std::set<std::string> draw = drawings_.robots();
  world.thaw_columns();
  for (const auto& entity : world.entities()) {
    if (draw.contains(entity->name())) (void)entity->column(properties::drawings);
  }
  world.freeze_columns();
}

/// Lines are few: all of them are read at the start.
void RecordedSource::read_lines() {
  recording::visit_topics(run_->file(), {"/events", "/warnings"},
                          [&](const std::string& topic, const recording::Message& message, std::size_t) {
                            std::string text = recording::text_of_log(message.data);
                            const Duration time = recording::time_of(message);
                            if (topic == "/events") {
                              events_.push_back({time, std::move(text)});
                            } else {
                              warnings_.emplace_back(time, std::move(text));
                            }
                          });
  std::ranges::stable_sort(events_, {}, &Event::time);
  std::ranges::stable_sort(warnings_, {}, &std::pair<Duration, std::string>::first);
  find_levels();
}

/// Levels from events: "blue1: kinematic_walking -> full_dynamics".
void RecordedSource::find_levels() {
  for (std::size_t i = 0; i < entities_.size(); ++i) levels_.push_back({{}, i, entities_[i].entity->level});
  for (const Event& event : events_) {
    const std::size_t name = event.text.find(": "), found = event.text.rfind(arrow);
    if (name == std::string::npos || found == std::string::npos) continue;
    const auto entity = std::ranges::find(entities_, event.text.substr(0, name), &recording::RecordedEntity::name);
    if (entity == entities_.end()) continue;
    levels_.push_back(
        {event.time, static_cast<std::size_t>(entity - entities_.begin()), event.text.substr(found + arrow.size())});
  }
}

void RecordedSource::begin() {
  PoseFeed& poses = scene_->simulation().poses();
  poses.contacts_from([this](const World&, std::vector<ContactMark>& contacts) {
    contacts.insert(contacts.end(), contacts_.begin(), contacts_.end());
  });
  poses.complete_by({});  // columns are complete as recorded
  if (others_) others_->pin({});
  show(frames_->begin());
}

void RecordedSource::step() {
  if (const auto next = frames_->after(scene_->simulation().now())) show(*next);
}

bool RecordedSource::at_end() const { return scene_->simulation().now() >= frames_->end(); }

void RecordedSource::reset(std::optional<std::uint64_t> seed) {
  if (seed) throw SetupError("a recording has one seed");
  show(frames_->begin());
}

void RecordedSource::seek(Duration time, std::optional<int> branch, const std::function<bool()>& given_up) {
  if (branch.value_or(0) != 0) throw SetupError(fmt::format("a recording has no branch {}", *branch));
  if (!given_up()) show(time);
}

void RecordedSource::load(const std::function<void(scene::Scene&)>&) {
  throw SetupError("a recording goes on from no other state");
}

void RecordedSource::change(const std::vector<std::string>& changes) {
  throw SetupError(
      fmt::format("{}: this is a recording; 'murosimf branch' goes on from it with changes", fmt::join(changes, "; ")));
}

/// A recording is one branch that cannot be left.
std::vector<session::BranchView> RecordedSource::branches() const {
  return {{.number = 0,
           .parent = {},
           .begin = frames_->begin(),
           .end = frames_->end(),
           .commands = run_->states().commands(),
           .states = {}}};
}

bool RecordedSource::has_grown() { return !std::exchange(told_, true); }

void RecordedSource::show(Duration time) {
  const recording::RecordedFrame& frame = frames_->at(time);
  MUROSIMF_ASSERT(frame.present.size() == entities_.size());
  std::size_t link = 0, joint = 0;
  for (std::size_t i = 0; i < entities_.size(); ++i) {
    show_entity(i, frame, link, joint);
    link += entities_[i].links.size();
    joint += entities_[i].joints.size();
  }
  contacts_ = frame.contacts;
  show_drawings(frame.time);
  show_levels(frame.time);
  const auto events = std::ranges::upper_bound(events_, frame.time, {}, &Event::time) - events_.begin();
  const auto warnings = std::ranges::upper_bound(warnings_, frame.time, {}, &std::pair<Duration, std::string>::first);
  // only the difference to the last instant is added: it may be earlier or later
  warnings_so_far_.resize(std::min(warnings_so_far_.size(), static_cast<std::size_t>(warnings - warnings_.begin())));
  for (auto next = warnings_.begin() + static_cast<std::ptrdiff_t>(warnings_so_far_.size()); next != warnings; ++next) {
    warnings_so_far_.push_back(next->second);
  }
  scene_->simulation().show_past(frame.time, std::span(events_).first(static_cast<std::size_t>(events)),
                                 warnings_so_far_);
}

void RecordedSource::show_entity(std::size_t index, const recording::RecordedFrame& frame, std::size_t link,
                                 std::size_t joint) {
  const recording::RecordedEntity& recorded = entities_[index];
  Entity& entity = scene_->simulation().world().entity(recorded.name);
  entity.set_present(frame.present[index] != 0);
  if (!entity.present()) return;
  Column<Vec3d>* position = column_of(entity, properties::position);
  Column<Mat3d>* orientation = column_of(entity, properties::orientation);
  if (!position || !orientation) return;
  for (int object = 0; object < entity.model().size(); ++object) {
    const FixedObject at = entity.model().placement(object);
    const Transformd pose = frame.poses[link + static_cast<std::size_t>(at.link)] * Transformd{at.offset, at.turn};
    position->values[static_cast<std::size_t>(object)] = pose.position;
    orientation->values[static_cast<std::size_t>(object)] = pose.orientation;
  }
  for (std::size_t k = 0; k < recorded.joints.size(); ++k) {
    const recording::JointNumbers& numbers = frame.joints[joint + k];
    const int object = recorded.joints[k].object;
    set_number(entity, properties::joint_position, object, numbers.position);
    set_number(entity, properties::joint_velocity, object, numbers.velocity);
    set_number(entity, properties::joint_torque, object, numbers.torque);
    set_number(entity, properties::joint_target, object, numbers.target);
  }
}

void RecordedSource::show_drawings(Duration time) {
  std::map<recording::DrawingTopic, std::vector<DrawnGroup>> news = drawings_.news(time);
  if (others_then_->take(news) && others_) others_->pin(others_then_->shown());
  for (auto& [topic, groups] : news) {
    const auto known = std::ranges::find(entities_, topic.robot, &recording::RecordedEntity::name);
    if (topic.by_others || known == entities_.end()) continue;  // of an entity that was added later
    Column<Drawings>* column = column_of(scene_->simulation().world().entity(topic.robot), properties::drawings);
    if (!column) continue;
    Drawings& drawn = column->values[0];
    drawn.groups = std::move(groups);
    ++drawn.changes;
  }
}

void RecordedSource::show_levels(Duration time) {
  World& world = scene_->simulation().world();
  for (const LevelChange& change : levels_) {
    if (change.time <= time) world.entity(entities_[change.entity].name).level = change.level;
  }
}

}  // namespace murosimf::recording
