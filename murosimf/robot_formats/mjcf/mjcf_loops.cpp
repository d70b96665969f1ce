#include "murosimf/robot_formats/mjcf/mjcf_loops.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "murosimf/math/assert.h"
#include "murosimf/math/quaternion.h"
#include "murosimf/model/error.h"
#include "murosimf/robot_formats/mjcf/mjcf_defaults.h"
#include "murosimf/robot_formats/mjcf/mjcf_frame.h"
#include "murosimf/robot_formats/mjcf/mjcf_idle.h"

namespace murosimf::robot_formats::mjcf {
namespace {

constexpr double open_shift = 1e-3;           // [m]
constexpr double open_turn = 1.0 * pi / 180;  // [rad]

class Loops {
 public:
  explicit Loops(robot_formats::RobotDescription& description) : description_(description) {
    for (const robot_formats::BodyDescription& body : description.bodies) {
      MUROSIMF_ASSERT(body.parent < static_cast<int>(places_.size()));
      places_.push_back(body.parent < 0 ? Transformd{} : places_[body.parent] * body.place);
    }
  }

  /// Reads a `connect` or `weld`.
  void read(const files::XmlElement& element) {
    MjcfAttributes attributes(element);
    attributes.overlay(element);
    (void)attributes.choice("active", {"true", "false"});  // refuses other words
    const bool welded = element.tag() == "weld";
    const bool sites = attributes.has("site1") || attributes.has("site2");
    const std::string name = name_of(attributes, sites ? "site" : "body");
    robot_formats::LoopDescription loop{name, element.where(), {}, {}, welded};
    if (sites) {
      for (const char* attribute : {"body1", "body2", "anchor", "relpose"}) {
        if (attributes.has(attribute)) element.fail(fmt::format("{} goes without sites; keep one of both", attribute));
      }
      loop.frame1 = site(attributes, "site1");
      loop.frame2 = site(attributes, "site2");
    } else {
      add_ends(attributes, loop);
    }
    // Ends that move together are no constraint, and would make the solver's matrix singular.
    if (mover_of(loop.frame1) == mover_of(loop.frame2)) {
      element.fail("a loop of a body with itself, or what is fixed to it; name two bodies with joints between them");
    }
    put_free_end_second(element, loop);
    warn_if_open(loop);
    description_.loops.push_back(loop);
  }

 private:
  /// Makes a frame the second one that closes no other loop yet: a frame can be the second one of one loop only.
  void put_free_end_second(const files::XmlElement& element, robot_formats::LoopDescription& loop) const {
    const auto closes = [&](const std::string& frame) {
      return std::ranges::count(description_.loops, frame, &robot_formats::LoopDescription::frame2) > 0;
    };
    if (!closes(loop.frame2)) return;
    if (closes(loop.frame1)) element.fail("both sites close another loop each; give this one sites of its own");
    std::swap(loop.frame1, loop.frame2);
  }

  [[nodiscard]] std::string name_of(const MjcfAttributes& attributes, const std::string& kind) const {
    const std::string otherwise = attributes.text(kind + "1") + "_" + attributes.text(kind + "2");
    std::string name = attributes.text("name", otherwise);
    const auto taken = [&] {
      return std::ranges::count(description_.loops, name, &robot_formats::LoopDescription::name);
    };
    while (taken() > 0) name += "2";
    return name;
  }

  /// Adds frames on the two bodies at the anchor.
  void add_ends(const MjcfAttributes& attributes, robot_formats::LoopDescription& loop) {
    const std::size_t one = body(attributes, "body1"), other = body(attributes, "body2");
    const Transformd anchor{attributes.vector("anchor", {}), Mat3d{}};
    Transformd first = anchor, second = anchor;
    if (!loop.welded) {
      if (!attributes.has("anchor")) attributes.element().fail("connect without anchor; add it");
      second = from(other, places_[one] * anchor);
    } else if (const auto pose = attributes.numbers("relpose", 7, 7); has_turn(pose)) {
      const Quaterniond turn = normalized(Quaterniond{pose[3], pose[4], pose[5], pose[6]});
      first = {{pose[0], pose[1], pose[2]}, to_matrix(turn)};
    } else {
      first = from(one, places_[other] * anchor);
    }
    loop.frame1 = add_frame(one, loop, ".end1", first);
    loop.frame2 = add_frame(other, loop, ".end2", second);
  }

  /// Whether a relative pose is given; one of zeros stands for the pose of the file.
  [[nodiscard]] static bool has_turn(const std::vector<double>& pose) {
    return std::any_of(pose.begin() + (pose.empty() ? 0 : 3), pose.end(), [](double number) { return number != 0; });
  }

  [[nodiscard]] Transformd from(std::size_t body, const Transformd& place) const {
    const auto& [position, orientation] = places_[body];
    // The inverse of a rotation matrix is its transpose.
    const Mat3d back = transpose(orientation);
    return {back * (place.position - position), back * place.orientation};
  }

  std::string add_frame(std::size_t body, const robot_formats::LoopDescription& loop, const char* end,
                        const Transformd& place) {
    MUROSIMF_ASSERT(body < description_.bodies.size());
    description_.bodies[body].frames.push_back({loop.name + end, loop.where, "loop", place, {}});
    return loop.name + end;
  }

  [[nodiscard]] std::size_t body(const MjcfAttributes& attributes, const char* attribute) const {
    const std::string name = attributes.text(attribute, world_name);
    std::vector<std::string_view> known;
    for (std::size_t i = 0; i < description_.bodies.size(); ++i) {
      if (description_.bodies[i].name == name) return i;
      known.emplace_back(description_.bodies[i].name);
    }
    attributes.element().fail(unknown_name("body", name, known));
  }

  [[nodiscard]] std::string site(const MjcfAttributes& attributes, const char* attribute) const {
    const std::string name = attributes.text(attribute);
    if (name.empty())
      attributes.element().fail(fmt::format("{} without {}; add it", attributes.element().tag(), attribute));
    std::vector<std::string_view> known;
    for (const robot_formats::BodyDescription& body : description_.bodies) {
      for (const robot_formats::FrameDescription& frame : body.frames) {
        if (frame.kind == "site") known.emplace_back(frame.name);
      }
    }
    if (std::ranges::find(known, name) == known.end()) attributes.element().fail(unknown_name("site", name, known));
    return name;
  }

  /// The body with joints, or the base, that a frame moves with.
  [[nodiscard]] int mover_of(const std::string& frame) const {
    int i = static_cast<int>(find(frame).first);
    while (description_.bodies[i].parent >= 0 && description_.bodies[i].joints.empty())
      i = description_.bodies[i].parent;
    return i;
  }

  /// The body and the frame of a name.
  [[nodiscard]] std::pair<std::size_t, const robot_formats::FrameDescription*> find(const std::string& name) const {
    for (std::size_t i = 0; i < description_.bodies.size(); ++i) {
      for (const robot_formats::FrameDescription& frame : description_.bodies[i].frames) {
        if (frame.name == name && (frame.kind == "site" || frame.kind == "loop")) return {i, &frame};
      }
    }
    return {0, nullptr};
  }

  void warn_if_open(const robot_formats::LoopDescription& loop) {
    const auto place = [&](const std::string& name) {
      const auto [body, frame] = find(name);
      MUROSIMF_ASSERT(frame != nullptr);
      return places_[body] * frame->place;
    };
    const Transformd one = place(loop.frame1), other = place(loop.frame2);
    const double shift = norm(other.position - one.position);
    const double turn = norm(rotation_vector(from_matrix(other.orientation * transpose(one.orientation))));
    if (shift > open_shift || (loop.welded && turn > open_turn)) {
      description_.warnings.push_back(files::one_line(
          fmt::format("{}: loop '{}' is open in the pose of the file, by {:.3g} mm{}; it is closed at the start",
                      loop.where, loop.name, 1e3 * shift,
                      loop.welded ? fmt::format(" and {:.3g} degrees", turn * 180 / pi) : "")));
    }
  }

  robot_formats::RobotDescription& description_;
  std::vector<Transformd> places_;  // of the bodies in the base, in the pose of the file
};

}  // namespace

void read_loops(const files::XmlElement& root, const MjcfNames& names, robot_formats::RobotDescription& description) {
  Loops loops(description);
  for (const files::XmlElement& section : root.children("equality")) {
    for (const files::XmlElement& element : section.children()) {
      const bool closes = element.tag() == "connect" || element.tag() == "weld";
      if (closes && !is_idle_equality(element, names)) loops.read(element);
    }
  }
}

}  // namespace murosimf::robot_formats::mjcf
