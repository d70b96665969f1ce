#include "murosimf/recording/recorded_external_drawings.h"

#include <cstddef>
#include <utility>

#include "murosimf/math/assert.h"

namespace murosimf::recording {

/// Numbers of entities are those of this world: they differ after another scene was loaded.
void OthersWatch::meet(const World& world, const std::vector<RecordedEntity>& entities) {
  teams_ = drawing::teams_of(world);
  names_.assign(teams_.size(), {});
  frames_.assign(teams_.size(), {});
  for (const RecordedEntity& one : entities) {
    const auto place = static_cast<std::size_t>(world.index_of(one.entity));
    MUROSIMF_ASSERT(place < names_.size());
    names_[place] = one.name;
    if (!one.links.empty()) frames_[place] = one.links.front().frame;
  }
}

void OthersWatch::say_again() {
  changes_.reset();
  again_ = true;
}

void OthersWatch::take(const drawing::ExternalDrawings& others, RecordedFrame& frame) {
  if (changes_ == others.changes) return;
  changes_ = others.changes;
  std::map<std::string, FrameDrawings> now;
  for (const auto& [robot, groups] : drawn_) now[robot];  // empty, unless filled below: reports removals
  for (drawing::Drawn& drawn : drawing::external_drawings(others, teams_)) {
    const auto entity = static_cast<std::size_t>(drawn.entity);
    MUROSIMF_ASSERT(drawn.entity < 0 || entity < names_.size());
    if (drawn.entity >= 0 && names_[entity].empty()) continue;  // its pose is not recorded
    FrameDrawings& sheet = now[drawn.entity < 0 ? "" : names_[entity]];
    if (drawn.entity >= 0) sheet.base = frames_[entity];
    sheet.groups = std::move(drawn.groups);
  }
  for (auto& [robot, sheet] : now) {
    const auto [before, is_new] = drawn_.try_emplace(robot);
    if (!is_new && !again_ && before->second == sheet.groups) continue;
    before->second = sheet.groups;
    sheet.topic.by_others = true;
    sheet.topic.robot = robot;
    frame.drawings.push_back(std::move(sheet));
  }
  again_ = false;
}

RecordedExternalDrawings::RecordedExternalDrawings(const World& world) {
  const std::vector<std::optional<drawing::TeamPlace>> places = drawing::team_places(drawing::teams_of(world));
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i]) places_[world.entities()[i]->name()] = *places[i];
  }
}

/// Each topic has the whole sheet: it replaces the one before.
bool RecordedExternalDrawings::take(const std::map<DrawingTopic, std::vector<DrawnGroup>>& news) {
  bool any = false;
  for (const auto& [topic, groups] : news) {
    if (!topic.by_others) continue;
    drawn_[topic.robot] = groups;
    any = true;
  }
  return any;
}

drawing::ExternalDrawings RecordedExternalDrawings::shown() const {
  drawing::ExternalDrawings all;
  for (const auto& [robot, groups] : drawn_) {
    if (robot.empty()) {
      all.groups = groups;
      continue;
    }
    const auto place = places_.find(robot);
    if (place == places_.end() || groups.empty() || groups.front().shapes.empty())
      continue;  // of an entity that was added later
    const DrawnShape& text = groups.front().shapes.front();
    all.notes.push_back(
        {.team = place->second.team, .number = place->second.number, .color = text.color, .text = text.words});
  }
  return all;
}

}  // namespace murosimf::recording
