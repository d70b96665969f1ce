#include "murosimf/robot/lump_fixed_joints.h"

#include <utility>

#include "murosimf/math/assert.h"

namespace murosimf::robot {
namespace {

/// Moves all parts of `body` to `parent`.
void weld(robot_formats::BodyDescription& body, robot_formats::BodyDescription& parent) {
  const Transformd& place = body.place;
  parent.solid =
      robot_formats::combined({parent.solid, robot_formats::moved(body.solid, place.position, place.orientation)});
  if (parent.solid_where.empty()) parent.solid_where = body.solid_where;
  for (robot_formats::ShapeDescription& shape : body.shapes) {
    const Transformd there = place * shape.placed.place();
    shape.placed.position = there.position;
    shape.placed.orientation = there.orientation;
    parent.shapes.push_back(std::move(shape));
  }
  for (robot_formats::VisualDescription& visual : body.visuals) {
    visual.place = place * visual.place;
    parent.visuals.push_back(std::move(visual));
  }
  parent.frames.push_back({body.name, body.where, "body", place, {}});
  for (robot_formats::FrameDescription& frame : body.frames) {
    frame.place = place * frame.place;
    parent.frames.push_back(std::move(frame));
  }
}

}  // namespace

void lump_fixed_joints(robot_formats::RobotDescription& description, const std::set<std::string>& measured) {
  std::vector<robot_formats::BodyDescription> kept;
  std::vector<int> index;          // of each body, or of the one that it is welded to, among those kept
  std::vector<Transformd> welded;  // of each body in that one
  for (robot_formats::BodyDescription& body : description.bodies) {
    if (body.parent >= 0) {
      // Parents precede their children, so their places are known.
      MUROSIMF_ASSERT(body.parent < static_cast<int>(index.size()));
      body.place = welded[body.parent] * body.place;
      body.parent = index[body.parent];
    }
    const bool stays = body.parent < 0 || !body.joints.empty() || measured.contains(body.name);
    index.push_back(stays ? static_cast<int>(kept.size()) : body.parent);
    welded.push_back(stays ? Transformd{} : body.place);
    if (stays) {
      kept.push_back(std::move(body));
    } else {
      MUROSIMF_ASSERT(stays || (body.parent >= 0 && body.parent < static_cast<int>(kept.size())));
      weld(body, kept[body.parent]);
    }
  }
  description.bodies = std::move(kept);
}

}  // namespace murosimf::robot
