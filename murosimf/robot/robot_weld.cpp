#include "murosimf/robot/robot_weld.h"

#include <utility>

namespace murosimf::io {
namespace {

/// Moves everything that `body` has to `parent`.
void weld(DraftBody& body, DraftBody& parent) {
  const Place& place = body.place;
  parent.solid = combined({parent.solid, moved(body.solid, place.position, place.orientation)});
  if (parent.solid_where.empty()) parent.solid_where = body.solid_where;
  for (DraftShape& shape : body.shapes) {
    const Place there = inside(place, {shape.placed.position, shape.placed.orientation});
    shape.placed.position = there.position;
    shape.placed.orientation = there.orientation;
    parent.shapes.push_back(std::move(shape));
  }
  for (DraftVisual& visual : body.visuals) {
    visual.place = inside(place, visual.place);
    parent.visuals.push_back(std::move(visual));
  }
  parent.frames.push_back({body.name, body.where, "body", place, {}});
  for (DraftFrame& frame : body.frames) {
    frame.place = inside(place, frame.place);
    parent.frames.push_back(std::move(frame));
  }
}

}  // namespace

void weld_fixed_bodies(RobotDraft& draft) {
  std::vector<DraftBody> kept;
  std::vector<int> index;     // of each body, or of the one that it is welded to, among those kept
  std::vector<Place> welded;  // of each body in that one
  for (DraftBody& body : draft.bodies) {
    if (body.parent >= 0) {
      body.place = inside(welded[body.parent], body.place);
      body.parent = index[body.parent];
    }
    const bool moves = body.parent < 0 || !body.joints.empty();
    index.push_back(moves ? static_cast<int>(kept.size()) : body.parent);
    welded.push_back(moves ? Place{} : body.place);
    if (moves) {
      kept.push_back(std::move(body));
    } else {
      weld(body, kept[body.parent]);
    }
  }
  draft.bodies = std::move(kept);
}

}  // namespace murosimf::io
