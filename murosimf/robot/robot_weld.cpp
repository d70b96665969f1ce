#include "murosimf/robot/robot_weld.h"

#include <utility>

namespace murosimf::robot {
namespace {

/// Moves everything that `body` has to `parent`.
void weld(description::DraftBody& body, description::DraftBody& parent) {
  const description::Place& place = body.place;
  parent.solid =
      description::combined({parent.solid, description::moved(body.solid, place.position, place.orientation)});
  if (parent.solid_where.empty()) parent.solid_where = body.solid_where;
  for (description::DraftShape& shape : body.shapes) {
    const description::Place there = description::inside(place, {shape.placed.position, shape.placed.orientation});
    shape.placed.position = there.position;
    shape.placed.orientation = there.orientation;
    parent.shapes.push_back(std::move(shape));
  }
  for (description::DraftVisual& visual : body.visuals) {
    visual.place = description::inside(place, visual.place);
    parent.visuals.push_back(std::move(visual));
  }
  parent.frames.push_back({body.name, body.where, "body", place, {}});
  for (description::DraftFrame& frame : body.frames) {
    frame.place = description::inside(place, frame.place);
    parent.frames.push_back(std::move(frame));
  }
}

}  // namespace

void weld_fixed_bodies(description::RobotDraft& draft) {
  std::vector<description::DraftBody> kept;
  std::vector<int> index;                  // of each body, or of the one that it is welded to, among those kept
  std::vector<description::Place> welded;  // of each body in that one
  for (description::DraftBody& body : draft.bodies) {
    if (body.parent >= 0) {
      body.place = description::inside(welded[body.parent], body.place);
      body.parent = index[body.parent];
    }
    const bool moves = body.parent < 0 || !body.joints.empty();
    index.push_back(moves ? static_cast<int>(kept.size()) : body.parent);
    welded.push_back(moves ? description::Place{} : body.place);
    if (moves) {
      kept.push_back(std::move(body));
    } else {
      weld(body, kept[body.parent]);
    }
  }
  draft.bodies = std::move(kept);
}

}  // namespace murosimf::robot
