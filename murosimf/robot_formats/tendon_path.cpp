#include "murosimf/robot_formats/tendon_path.h"

#include <algorithm>
#include <set>

#include "murosimf/math/assert.h"

namespace murosimf::robot_formats {
namespace {

std::optional<std::pair<std::size_t, Transformd>> find_site(const RobotDescription& description,
                                                            const std::string& name) {
  for (std::size_t i = 0; i < description.bodies.size(); ++i) {
    for (const FrameDescription& frame : description.bodies[i].frames) {
      if (frame.name == name && frame.kind == "site") return std::pair{i, frame.place};
    }
  }
  return std::nullopt;
}

std::optional<PartOfBody> find_obstacle(const RobotDescription& description, const std::string& name) {
  for (std::size_t i = 0; i < description.bodies.size(); ++i) {
    for (const ShapeDescription& shape : description.bodies[i].shapes) {
      if (shape.name != name) continue;
      const auto* cylinder = std::get_if<Cylinder>(&shape.placed.shape);
      const auto* sphere = std::get_if<Sphere>(&shape.placed.shape);
      if (!cylinder && !sphere) return std::nullopt;
      const StringObstacle obstacle{cylinder ? cylinder->radius : sphere->radius, cylinder != nullptr};
      return PartOfBody{i, {shape.placed.place(), obstacle}};
    }
  }
  return std::nullopt;
}

/// How a joint moves its body from where it is in the pose of the file.
Transformd moved(const JointDescription& joint, double position) {
  const Vec3d axis = (1 / norm(joint.axis)) * joint.axis;
  const double by = position - joint.reference;
  if (joint.kind == Kind::prismatic) return {by * axis, {}};
  const Mat3d turn = rotation(axis, by);
  return {joint.anchor - turn * joint.anchor, turn};
}

std::vector<Transformd> places_of_bodies(const RobotDescription& description, double JointDescription::*position) {
  std::vector<Transformd> places;
  for (const BodyDescription& body : description.bodies) {
    MUROSIMF_ASSERT(body.parent < static_cast<int>(places.size()));
    Transformd place = body.parent < 0 ? Transformd{} : places[body.parent] * body.place;
    for (const JointDescription& joint : body.joints) place = place * moved(joint, joint.*position);
    places.push_back(place);
  }
  return places;
}

}  // namespace

std::optional<PartOfBody> find_part(const RobotDescription& description, const TendonPartDescription& part) {
  if (part.shape.empty()) {
    const auto site = find_site(description, part.site);
    return site ? std::optional(PartOfBody{site->first, {site->second}}) : std::nullopt;
  }
  auto obstacle = find_obstacle(description, part.shape);
  if (!obstacle || part.site.empty()) return obstacle;
  const auto side = find_site(description, part.site);
  if (!side) return std::nullopt;
  obstacle->side_body = static_cast<int>(side->first);
  obstacle->side = side->second.position;
  return obstacle;
}

double path_length(const RobotDescription& description, const std::vector<TendonBranchDescription>& path,
                   double JointDescription::*position) {
  const auto places = places_of_bodies(description, position);
  double sum = 0;
  for (const TendonBranchDescription& branch : path) {
    std::vector<StringPart> string;
    for (const TendonPartDescription& one : branch.parts) {
      const auto found = find_part(description, one);
      MUROSIMF_ASSERT(found && branch.divisor > 0);
      StringPart part{places[found->body] * found->part.place, found->part.obstacle};
      if (found->side_body >= 0) {
        const Transformd& body = places[found->side_body];
        const Vec3d side = body.position + body.orientation * found->side - part.place.position;
        part.obstacle.sided = true;
        part.obstacle.side = transpose(part.place.orientation) * side;
      }
      string.push_back(part);
    }
    sum += string_length(string) / branch.divisor;
  }
  return sum;
}

std::vector<std::string> joints_of(const RobotDescription& description, const TendonDescription& tendon) {
  std::vector<std::string> joints;
  for (const auto& [joint, coefficient] : tendon.parts) joints.push_back(joint);
  std::set<int> between;  // bodies
  for (const TendonBranchDescription& branch : tendon.path) {
    int last = -1;
    for (const TendonPartDescription& one : branch.parts) {
      const auto found = find_part(description, one);
      if (!found) continue;
      int a = last < 0 ? static_cast<int>(found->body) : last, b = static_cast<int>(found->body);
      last = b;
      while (a != b) {  // parents come first
        int& later = a > b ? a : b;
        between.insert(later);
        later = description.bodies[later].parent;
      }
    }
  }
  for (const int body : between) {
    for (const JointDescription& joint : description.bodies[body].joints) joints.push_back(joint.name);
  }
  return joints;
}

}  // namespace murosimf::robot_formats
