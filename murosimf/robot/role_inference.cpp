#include "murosimf/robot/role_inference.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/component_files/servo_sections.h"
#include "murosimf/files/lower_case.h"
#include "murosimf/files/xml_element.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/robot/body_names.h"
#include "murosimf/robot/robot_feet.h"
#include "murosimf/robot/robot_soles.h"
#include "murosimf/robot/servo_inference.h"

namespace murosimf::robot {
namespace {

bool contains(const std::string& text, std::string_view part) {
  return files::lower_case(text).find(part) != std::string::npos;
}

/// The body that has a frame or the name `name`, and the frame.
struct Found {
  std::size_t body = 0;
  robot_formats::FrameDescription* frame = nullptr;
};

std::optional<Found> find_place(robot_formats::RobotDescription& description, const std::string& name) {
  for (std::size_t i = 0; i < description.bodies.size(); ++i) {
    for (robot_formats::FrameDescription& frame : description.bodies[i].frames) {
      if (frame.name == name) return Found{i, &frame};
    }
  }
  for (std::size_t i = 0; i < description.bodies.size(); ++i) {
    if (description.bodies[i].name == name) return Found{i, nullptr};
  }
  return std::nullopt;
}

/// A sole on the body, under its shapes; its name is `name` with ".sole".
bool add_sole(robot_formats::RobotDescription& description, const Found& foot, const std::string& name) {
  MUROSIMF_ASSERT(foot.body < description.bodies.size());
  const Mat3d axes = foot.frame ? foot.frame->place.orientation : Mat3d{};
  auto sole = sole_under(description, foot.body, name + ".sole", axes);
  if (sole) description.bodies[foot.body].frames.push_back(*std::move(sole));
  return sole.has_value();
}

bool has_sole(const robot_formats::RobotDescription& description, const RobotConfig& table) {
  return std::ranges::any_of(description.bodies, [&](const robot_formats::BodyDescription& body) {
    return std::ranges::any_of(body.frames,
                               [&](const robot_formats::FrameDescription& frame) { return is_sole(frame, table); });
  });
}

/// Frames that are probably meant as soles. Not the rule of is_sole: they need no rectangle, since
/// one is computed for them, and upper and lower case are equal, for a guess that is reported to the user.
std::vector<std::string> frames_called_sole(const robot_formats::RobotDescription& description) {
  std::vector<std::string> names;
  for (const robot_formats::BodyDescription& body : description.bodies) {
    for (const robot_formats::FrameDescription& frame : body.frames) {
      if (files::lower_case(frame.name).ends_with("sole")) names.push_back(frame.name);
    }
  }
  return names;
}

/// Left before right, of four the front ones first; sides as in the names, if all have one: a robot may face backwards.
void sort_feet(robot_formats::RobotDescription& description, std::vector<std::string>& feet) {
  const auto places = body_places(description);
  MUROSIMF_ASSERT(feet.size() == 2 || feet.size() == 4);
  const auto place = [&](const std::string& foot) { return places[find_place(description, foot)->body].position; };
  const bool named = std::ranges::all_of(feet, [](const std::string& foot) { return side_of(foot) != Side::unknown; });
  const auto left_first = [&](const auto& a, const auto& b) {
    return named ? side_of(a) < side_of(b) : place(a).y > place(b).y;
  };
  if (feet.size() == 4) {
    std::ranges::sort(feet, [&](const auto& a, const auto& b) { return place(a).x > place(b).x; });
    std::sort(feet.begin() + 2, feet.end(), left_first);
  }
  std::sort(feet.begin(), feet.begin() + 2, left_first);
}

void guess_soles(robot_formats::RobotDescription& description, RobotConfig& table) {
  if (description.fixed_base || !table.soles.empty() || has_sole(description, table)) return;
  std::vector<std::string> feet = frames_called_sole(description);
  std::erase_if(feet, [&](const std::string& foot) {
    return !sole_under(description, find_place(description, foot)->body, foot);
  });
  if (feet.empty()) {
    for (const std::size_t body : find_feet(description)) feet.push_back(description.bodies[body].name);
  }
  if (feet.size() != 2 && feet.size() != 4) return;
  sort_feet(description, feet);
  for (const std::string& foot : feet) table.soles.push_back({foot, description.bodies[0].where});
  description.notes.push_back(
      fmt::format("{}: guessed: the soles are under {}", description.bodies[0].where, fmt::join(feet, ", ")));
}

bool is_joint(const robot_formats::RobotDescription& description, const std::string& name) {
  return std::ranges::any_of(description.bodies, [&](const robot_formats::BodyDescription& body) {
    return std::ranges::find(body.joints, name, &robot_formats::JointDescription::name) != body.joints.end();
  });
}

void take_frame(robot_formats::RobotDescription& description, RobotConfig& table, const std::string& role,
                const std::string& name) {
  const bool taken = table.frames.contains(role) || table.joints.contains(role) || find_place(description, role) ||
                     is_joint(description, role) || role == description.base_joint;
  if (name.empty() || name == role || taken) return;
  table.frames[role] = {name, description.bodies[0].where};
  description.notes.push_back(fmt::format("{}: guessed: {} is '{}'", description.bodies[0].where, role, name));
}

/// The first frame or body with `word` in its name; preferably one with `better` as well.
std::string name_with(const robot_formats::RobotDescription& description, std::string_view word,
                      std::string_view better) {
  std::string found;
  const auto inspect = [&](const std::string& name) {
    if (!contains(name, word)) return;
    if (found.empty() || (!contains(found, better) && contains(name, better))) found = name;
  };
  for (const robot_formats::BodyDescription& body : description.bodies) {
    for (const robot_formats::FrameDescription& frame : body.frames) inspect(frame.name);
  }
  for (const robot_formats::BodyDescription& body : description.bodies) inspect(body.name);
  return found;
}

std::string frame_of_sensor(robot_formats::RobotDescription& description, std::string_view kind) {
  for (const robot_formats::SensorDescription& sensor : description.sensors) {
    if (sensor.kind == kind && sensor.obstacle.empty() && find_place(description, sensor.frame)) return sensor.frame;
  }
  return {};
}

/// The last of consecutive bodies with names of hands: the one with the fingers, if there are any.
std::size_t end_of_hand(const robot_formats::RobotDescription& description, std::size_t hand) {
  MUROSIMF_ASSERT(hand < description.bodies.size());
  for (;;) {
    std::vector<std::size_t> next;
    for (std::size_t i = hand + 1; i < description.bodies.size(); ++i) {
      const robot_formats::BodyDescription& body = description.bodies[i];
      if (body.parent == static_cast<int>(hand) && names_hand(body.name) && !names_finger(body.name)) next.push_back(i);
    }
    if (next.size() != 1) return hand;
    hand = next.front();
  }
}

/// Bodies with names of hands below parents without.
std::vector<std::size_t> first_of_hands(const robot_formats::RobotDescription& description) {
  std::vector<std::size_t> firsts;
  for (std::size_t i = 1; i < description.bodies.size(); ++i) {
    const robot_formats::BodyDescription& body = description.bodies[i];
    MUROSIMF_ASSERT(description.bodies[i].parent >= 0 && description.bodies[i].parent < static_cast<int>(i));
    if (names_hand(body.name) && !names_hand(description.bodies[body.parent].name)) firsts.push_back(i);
  }
  return firsts;
}

/// One hand on each side: sides as in the names, or else by the places of the bodies, if there is one on both.
void guess_hands(robot_formats::RobotDescription& description, RobotConfig& table) {
  const auto places = body_places(description);
  std::map<Side, std::string> named, placed;
  for (const std::size_t first : first_of_hands(description)) {
    const std::size_t hand = end_of_hand(description, first);
    const std::string& name = description.bodies[hand].name;
    const double y = places[hand].position.y;
    if (const Side side = side_of(name); side != Side::unknown) {
      named.emplace(side, name);
    } else if (std::abs(y) > 0.01) {
      placed.emplace(y > 0 ? Side::left : Side::right, name);
    }
  }
  const auto& hands = named.empty() && placed.size() == 2 ? placed : named;
  for (const auto& [side, name] : hands) {
    take_frame(description, table, side == Side::left ? "left_hand" : "right_hand", name);
  }
}

void guess_frames(robot_formats::RobotDescription& description, RobotConfig& table) {
  std::string imu = frame_of_sensor(description, "gyro");
  // A sensor of the file is better evidence than a name.
  if (imu.empty()) imu = frame_of_sensor(description, "imu");
  take_frame(description, table, "imu", imu.empty() ? name_with(description, "imu", "imu_") : imu);
  const std::string camera = frame_of_sensor(description, "camera");
  take_frame(description, table, "camera", camera.empty() ? name_with(description, "camera", "optical") : camera);
  guess_hands(description, table);
}

std::string soles_toml(const RobotConfig& table) {
  const std::vector<std::string_view> two{"left", "right"};
  const std::vector<std::string_view> four{"front_left", "front_right", "hind_left", "hind_right"};
  const auto& feet = table.soles.size() == 4 ? four : two;
  std::string text = "[soles]  # box sites at the bottoms of the feet, or the feet themselves\n";
  for (std::size_t i = 0; i < std::min(feet.size(), table.soles.size()); ++i) {
    text += fmt::format("{} = {}\n", feet[i], component_files::toml_quoted(table.soles[i].name));
  }
  return table.soles.empty() ? "" : text + "\n";
}

std::string frames_toml(const RobotConfig& table) {
  if (table.frames.empty()) return {};
  std::string text = "[frames]  # other names for frames, bodies and joints\n";
  for (const auto& [role, frame] : table.frames)
    text += fmt::format("{} = {}\n", component_files::toml_quoted(role), component_files::toml_quoted(frame.name));
  return text + "\n";
}

}  // namespace

void place_soles(robot_formats::RobotDescription& description, RobotConfig& table) {
  for (const TableName& sole : table.soles) {
    const auto found = find_place(description, sole.name);
    // A box of the file is used as it is; other frames and bodies get a rectangle.
    const bool placed = found && found->frame && found->frame->box;
    if (found && !placed && !add_sole(description, *found, sole.name)) {
      throw SetupError(
          fmt::format("{}: '{}' cannot be a sole: its body has no shape that collides", sole.where, sole.name));
    }
    table.sole_frames.push_back(placed ? sole.name : sole.name + ".sole");
  }
}

void guess_roles(robot_formats::RobotDescription& description, RobotConfig& table) {
  guess_soles(description, table);
  guess_frames(description, table);
  guess_servos(description, table);
}

std::string roles_toml(const robot_formats::RobotDescription& description, const RobotConfig& table) {
  const std::string head = fmt::format(
      "# What the file of {} cannot say, partly guessed (docs/robots.md): correct it. Servos are on the output side "
      "of\n"
      "# the gear, SI units; instead of numbers, the type of a ready-made one will do: type = \"mx64\".\n\n",
      files::one_line(description.name));
  return head + soles_toml(table) + frames_toml(table) + component_files::servo_sections(description);
}

}  // namespace murosimf::robot
