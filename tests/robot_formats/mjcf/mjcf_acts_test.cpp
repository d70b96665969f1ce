/// mjcf_acts_test - the table `murosimf list mjcf` is true: a change of anything that it lists as used changes the model.
#include "murosimf/robot/robot_reader.h"

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "murosimf/collision/contact_properties.h"
#include "murosimf/dynamics/motion_properties.h"
#include "murosimf/dynamics/passive_joint.h"
#include "murosimf/model/keyframe.h"
#include "murosimf/model/properties.h"
#include "murosimf/model/visual_mesh.h"
#include "murosimf/multibody/loops.h"
#include "murosimf/multibody/spatial_tendon.h"
#include "murosimf/multibody/tendon_tie.h"
#include "murosimf/robot_formats/mjcf/mjcf_schema.h"
#include "tests/temp_folder.h"

namespace murosimf::robot_formats::mjcf {
namespace {

namespace fs = std::filesystem;

// ---- all data of a robot in a simulation, as text ----

std::string text_of(const Color& c) { return fmt::format("{} {} {} {}", c.red, c.green, c.blue, c.alpha); }
std::string text_of(const Vec3d& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); }
std::string text_of(const Mat3d& m) { return text_of(m.x) + " " + text_of(m.y) + " " + text_of(m.z); }

std::string text_of(const PlacedShape& placed) {
  std::string text = fmt::format("{} {} {} {} {} {} {} {}", shape_name(placed.shape), bounding_radius(placed.shape),
                                 text_of(placed.position), text_of(placed.orientation), placed.surface.friction,
                                 text_of(placed.color), placed.contact_type, placed.contact_affinity);
  if (const auto* box = std::get_if<Box>(&placed.shape)) text += text_of(box->half_size);
  if (const auto* convex = std::get_if<Convex>(&placed.shape)) {
    for (const Vec3d& v : convex->hull->vertices) text += ", " + text_of(v);
  }
  return text;
}

std::string text_of(const Servo& s) {
  return fmt::format("{} {} {} {} {} {} {} {}", s.type, s.law, s.stall_torque, s.lowest_share, s.highest_share,
                     s.position_gain, s.velocity_gain, s.command_filter);
}

std::string text_of(const SpatialTendon& tendon) {
  std::string text;
  for (const SpatialTendon::Branch& branch : tendon.branches) {
    text += fmt::format(" {}:", branch.divisor);
    for (const SpatialTendon::Part& part : branch.parts) {
      text += fmt::format(" {} {} {} {}", part.at.object, text_of(part.at.place.position), part.radius, part.cylinder);
      if (part.side) text += fmt::format(" {} {}", part.side->object, text_of(part.side->place.position));
    }
  }
  return text;
}

std::string tendons_of(const Model& model, int i) {
  std::string text;
  if (const JointTendon* tendon = model.find(properties::joint_tendon, i)) {
    for (const auto& [joint, coefficient] : tendon->parts) text += fmt::format("  {} {}", joint, coefficient);
  }
  if (const SpatialTendon* tendon = model.find(properties::spatial_tendon, i)) text += text_of(*tendon);
  if (const TendonTie* tie = model.find(properties::tendon_tie, i)) {
    text += fmt::format("  {} {}", tie->other, fmt::join(tie->polynomial, " "));
  }
  return text;
}

std::string text_of(const Model& model, int i) {
  const Object& object = model.objects()[i];
  std::string text = fmt::format("{} {} {} {}\n", object.name, static_cast<int>(object.kind), text_of(object.vector),
                                 text_of(object.turn));
  for (const auto& [key, column] : model.constants().columns()) {
    if (column->has(i)) text += fmt::format("  {} {}\n", column->info().name, fmt::join(column->numbers(i), " "));
  }
  if (const Servo* servo = model.find(properties::servo, i)) text += "  " + text_of(*servo) + "\n";
  if (const Shapes* shapes = model.find(properties::shapes, i)) {
    for (const PlacedShape& placed : *shapes) text += "  " + text_of(placed) + "\n";
  }
  if (const Visuals* visuals = model.find(properties::visuals, i)) {
    for (const VisualMesh& v : *visuals) {
      text += fmt::format("  {} {} {} {} {} {} {} {}\n", v.file, v.picture, v.picture_repeat[0], v.picture_repeat[1],
                          text_of(v.scale), text_of(v.position), text_of(v.orientation), text_of(v.color));
    }
  }
  if (const Sole* sole = model.find(properties::sole, i)) {
    text += fmt::format("  sole {} {}\n", sole->half_length, sole->half_width);
  }
  if (const JointCoupling* c = model.find(properties::joint_coupling, i)) {
    text += fmt::format("  {} {} {}\n", c->leader, c->ratio, c->offset);
  }
  if (const LoopClosure* c = model.find(properties::loop_closure, i)) {
    text += fmt::format("  {} {} {}\n", c->other, model.object_index(c->other), c->welded);
  }
  return text + tendons_of(model, i);
}

std::string relations_of(const Model& model) {
  std::string text;
  if (const ExcludedPairs* pairs = model.find(properties::excluded_pairs, 0)) {
    for (const auto& [a, b] : *pairs) text += fmt::format("exclude {} {}\n", a, b);
  }
  if (const AllowedPairs* pairs = model.find(properties::allowed_pairs, 0)) {
    for (const auto& [a, b] : *pairs) text += fmt::format("pair {} {} {} {}\n", a.object, a.index, b.object, b.index);
  }
  if (const Keyframes* keys = model.find(properties::keyframes, 0)) {
    for (const Keyframe& key : *keys) {
      text += key.name + " " + text_of(key.base);
      for (const auto& [joint, q] : key.positions) text += fmt::format(" {} {}", joint, q);
      for (const auto& [joint, q] : key.targets) text += fmt::format(" target {} {}", joint, q);
    }
  }
  return text;
}

std::string text_of(const sensors::SensorSpec& sensor) {
  std::string text = fmt::format("sensor {} {} {} {} {} {}\n", sensor.name, sensor.type, sensor.frame,
                                 fmt::join(sensor.objects, " "), text_of(sensor.position), text_of(sensor.orientation));
  for (const auto& [output, signal] : sensor.signals) {
    text += fmt::format("  {} {} {} {}\n", output, signal.noise, signal.lowest, signal.highest);
  }
  for (const auto& [key, number] : sensor.numbers) text += fmt::format("  {} {}\n", key, number);
  return text;
}

std::string text_of(const robot::RobotFile& robot) {
  std::string text = robot.model->name() + "\n";
  for (int i = 0; i < robot.model->size(); ++i) text += text_of(*robot.model, i);
  for (const std::string_view name : robot.model->object_names()) text += fmt::format("{} ", name);
  text += relations_of(*robot.model);
  for (const sensors::SensorSpec& sensor : robot.sensors) text += text_of(sensor);
  return text;
}

// ---- small files ----

constexpr const char* tetrahedron = "v 0 0 0\nv {0} 0 0\nv 0 {0} 0\nv 0 0 {0}\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

/// A folder with meshes of different sizes and a file to include.
fs::path folder() {
  const fs::path here = fixtures::temp_folder() / "mjcf_acts";
  fs::create_directories(here / "sub");
  std::ofstream(here / "a.obj") << fmt::format(fmt::runtime(tetrahedron), 0.1);
  std::ofstream(here / "b.obj") << fmt::format(fmt::runtime(tetrahedron), 0.2);
  std::ofstream(here / "sub/a.obj") << fmt::format(fmt::runtime(tetrahedron), 0.3);
  return here;
}

/// The model of a file as text; of one that is refused, "refused".
std::string result_of(const std::string& text) {
  const fs::path file = folder() / "robot.xml";
  std::ofstream(file) << text;
  try {
    return text_of(robot::read_robot(file, {.guess = false}));
  } catch (const SetupError&) {
    return "refused";
  }
}

/// Parts of a file that are inserted by a test.
struct Parts {
  std::string compiler = "<compiler angle='radian'/>";
  std::string defaults{}, assets{};
  std::string base = "<freejoint/><geom name='trunk' size='.1'/>";
  std::string link = "<joint name='j' axis='0 1 0' range='-1 1'/><geom name='g' type='box' size='.1 .1 .1' mass='1'/>";
  std::string rest{}, model = "model='m'", more{}, world{};
};

std::string file_of(const Parts& parts) {
  return fmt::format(
      "<mujoco {}>{}{}{}<worldbody{}><body name='b'>{}<body name='l' pos='0 0 .3'>{}</body>"
      "<body name='k' pos='0 .2 0'><joint name='i' axis='1 0 0'/><geom name='h' size='.1'/><site name='s' pos='.1 0 "
      "0'/>"
      "</body>{}</body></worldbody>{}</mujoco>",
      parts.model, parts.compiler, parts.defaults, parts.assets, parts.world, parts.base, parts.link, parts.more,
      parts.rest);
}

using Attributes = std::map<std::string, std::string>;

/// An element in its place: `%` of one part becomes its attributes.
struct Place {
  Parts parts;
  Attributes always{};  ///< attributes that it has unless a probe says something else of them
};

std::string with(const Place& place, const Attributes& own) {
  Attributes all = place.always;
  for (const auto& [name, value] : own) all[name] = value;
  std::string text;
  for (const auto& [name, value] : all) {
    if (value != "-") text += fmt::format(" {}='{}'", name, value);
  }
  std::string file = file_of(place.parts);
  for (auto at = file.find('%'); at != std::string::npos; at = file.find('%')) file.replace(at, 1, text);
  return file;
}

const std::string servo_of_j = "<actuator><position name='a' joint='j' kp='5'/></actuator>";

Parts rest(const std::string& text) {
  Parts parts;
  parts.rest = text;
  return parts;
}
/// `text` on the body, as well as its joint.
Parts on_link(const std::string& text) {
  Parts parts;
  parts.link += text;
  return parts;
}

void add_tendons(std::map<std::string, Place>& places) {
  const auto fixed = [](const std::string& name, const std::string& words = "") {
    return fmt::format("<fixed name='{0}' {1}><joint joint='j' coef='1'/><joint joint='i' coef='2'/></fixed>", name,
                       words);
  };
  const auto all = [](const std::string& tendons) {
    Parts parts = on_link("<site name='u' pos='.2 0 0'/><geom name='ball' size='.05'/>");
    parts.base += "<site name='o' pos='0 -1 0'/>";
    parts.defaults = "<default><default class='c'><tendon damping='3'/></default></default>";
    parts.rest = "<tendon>" + tendons + "</tendon>";
    return parts;
  };
  const std::string servo = "<actuator><position name='a' tendon='t' kp='5'/></actuator>";
  Parts parts = all("<fixed %><joint joint='j' coef='1'/><joint joint='i' coef='2'/></fixed>");
  parts.rest += servo;
  places["fixed"] = {parts, {{"name", "t"}}};
  parts = all("<spatial %><site site='u'/><site site='s'/></spatial>");
  parts.rest += servo;
  places["spatial"] = {parts, {{"name", "t"}}};
  parts = all(fixed("t"));
  parts.defaults = "<default><tendon %/></default>";
  parts.rest += servo;
  places["default/tendon"] = {parts};
  const std::string string = "<spatial name='t' stiffness='1'>";
  places["fixed/joint"] = {all("<fixed name='t' damping='1'><joint %/><joint joint='i' coef='2'/></fixed>"),
                           {{"joint", "j"}}};
  places["spatial/site"] = {all(string + "<site %/><site site='o'/></spatial>"), {{"site", "s"}}};
  places["spatial/geom"] = {all(string + "<site site='u'/><geom %/><site site='s'/></spatial>"), {{"geom", "ball"}}};
  places["pulley"] = {
      all(string + "<site site='u'/><site site='s'/><pulley %/><site site='u'/><site site='o'/></spatial>")};
  parts = all(fixed("t") + fixed("u") + fixed("v"));
  parts.rest += "<equality><tendon %/></equality>";
  places["equality/tendon"] = {parts, {{"tendon1", "t"}, {"tendon2", "u"}}};
}

std::map<std::string, Place> make_places() {
  std::map<std::string, Place> places;
  Parts parts;
  parts.model = "%";
  places["mujoco"] = {parts};
  parts = {};
  parts.compiler = "<compiler %/>";
  parts.assets =
      "<asset><mesh name='mesh' file='a.obj'/><mesh name='deep' file='sub/a.obj'/>"
      "<texture name='t' type='2d' file='a.png'/><material name='skin' texture='t'/></asset>";
  parts.link =
      "<geom type='mesh' mesh='mesh' contype='0' conaffinity='0' mass='0' material='skin'/>"
      "<joint name='j' axis='0 1 0' range='-1 1' limited='auto'/><inertial pos='0 0 0' mass='2' diaginertia='1 2 9'/>"
      "<geom type='mesh' mesh='deep'/><geom type='box' size='.1 .1 .1' mass='1' euler='.1 .2 .3'/>";
  places["compiler"] = {parts, {{"angle", "radian"}}};
  parts = {};
  parts.defaults = "<default class='main'><default %><geom rgba='1 0 0 1'/></default></default>";
  parts.link = "<joint name='j' axis='0 1 0'/><geom size='.1' class='c'/>";
  places["default"] = {parts, {{"class", "c"}}};
  parts = {};
  parts.defaults = "<default><default class='c'><mesh scale='2 2 2'/></default></default>";
  parts.assets = "<asset><mesh %/><material name='red' rgba='1 0 0 1'/></asset>";
  parts.link = "<joint name='j' axis='0 1 0'/><geom type='mesh' mesh='mesh'/>";
  places["mesh"] = {parts, {{"name", "mesh"}, {"file", "a.obj"}}};
  parts.defaults = "<default><default class='c'><material rgba='0 1 0 1'/></default></default>";
  parts.assets =
      "<asset><material %/><texture name='paint' builtin='flat' rgb1='.5 .5 .5'/>"
      "<mesh name='mesh' file='a.obj'/></asset>";
  parts.link =
      "<joint name='j' axis='0 1 0'/><geom size='.1' material='red'/>"
      "<geom type='mesh' mesh='mesh' contype='0' conaffinity='0' mass='0' material='red'/>";
  places["material"] = {parts, {{"name", "red"}}};
  parts.assets = "<asset><material name='red' texture='paint'/><texture %/></asset>";
  parts.assets += "<asset><mesh name='mesh' file='a.obj'/></asset>";
  places["texture"] = {parts, {{"name", "paint"}, {"builtin", "checker"}}};
  parts = {};
  parts.defaults = "<default><default class='c'><joint axis='1 0 0'/></default></default>";
  parts.link = "<joint %/><geom name='g' type='box' size='.1 .1 .1' mass='1'/>";
  parts.rest = servo_of_j;
  places["joint"] = {parts, {{"name", "j"}, {"axis", "0 1 0"}}};
  parts = {};
  parts.base = "<freejoint %/><geom name='trunk' size='.1'/>";
  places["freejoint"] = {parts};
  places["inertial"] = {on_link("<inertial %/>"), {{"pos", "0 0 0"}, {"mass", "1"}, {"diaginertia", "1 2 3"}}};
  parts = on_link("<geom %/>");
  parts.compiler = "<compiler angle='radian' inertiagrouprange='0 1'/>";
  parts.defaults = "<default><default class='c'><geom rgba='1 0 0 1'/></default></default>";
  parts.assets =
      "<asset><mesh name='mesh' file='a.obj'/><mesh name='big' file='b.obj'/>"
      "<material name='red' rgba='1 0 0 1'/></asset>";
  parts.rest = "<contact><pair geom1='x' geom2='trunk'/></contact>";
  places["geom"] = {parts, {{"name", "x"}, {"type", "box"}, {"size", ".1 .2 .3"}}};
  parts = on_link("<site %/>");
  parts.defaults = "<default><default class='c'><site pos='1 0 0'/></default></default>";
  places["site"] = {parts, {{"name", "x_sole"}, {"type", "box"}, {"size", ".1 .2 .3"}}};
  parts = on_link("<camera %/>");
  parts.defaults = "<default><default class='c'><camera fovy='60'/></default></default>";
  places["camera"] = {parts, {{"name", "eye"}}};
  parts = {};
  parts.defaults = "<default><default class='c'><geom rgba='1 0 0 1'/></default></default>";
  parts.more = "<body %><joint name='n' axis='1 0 0'/><geom size='.1'/></body>";
  places["body"] = {parts, {{"name", "x"}}};
  parts.more = "<frame %><body name='x' pos='.1 .2 .3'><joint name='n' axis='1 0 0'/><geom size='.1'/></body></frame>";
  places["frame"] = {parts};
  parts.more =
      "<replicate %><body name='x' pos='.1 .2 .3'><joint name='n' axis='1 0 0'/><geom size='.1'/></body></replicate>";
  places["replicate"] = {parts, {{"count", "2"}}};
  parts = {};
  parts.defaults = "<default><default class='c'><geom rgba='1 0 0 1'/></default></default>";
  parts.rest = "<contact><exclude %/></contact>";
  places["exclude"] = {parts, {{"body1", "l"}, {"body2", "k"}}};
  places["pair"] = {rest("<contact><pair %/></contact>"), {{"geom1", "g"}, {"geom2", "h"}}};
  places["equality/joint"] = {rest("<equality><joint %/></equality>"), {{"joint1", "j"}, {"joint2", "i"}}};
  for (const char* kind : {"connect", "weld"}) {
    parts = on_link("<site name='t'/><site name='u' pos='.2 0 0'/>");
    parts.rest = fmt::format("<equality><{} %/></equality>", kind);
    places[kind] = {parts, {{"body1", "l"}, {"body2", "k"}, {"anchor", ".1 0 0"}}};
  }
  add_tendons(places);
  places["key"] = {rest(servo_of_j + "<keyframe><key %/></keyframe>"), {{"qpos", "0 0 1 1 0 0 0 .1 .2"}}};
  for (const char* kind : {"position", "velocity", "intvelocity", "motor", "general"}) {
    parts = rest(fmt::format(
        "<actuator><{} %/></actuator><sensor><actuatorfrc actuator='b'/></sensor><tendon><fixed name='single'>"
        "<joint joint='j' coef='1'/></fixed><fixed name='double'><joint joint='j' coef='2'/></fixed></tendon>",
        kind));
    parts.defaults = fmt::format("<default><default class='c'><{} gear='2'/></default></default>", kind);
    places[kind] = {parts, {{"joint", "j"}}};
  }
  for (const auto& [element, rule] : mjcf_schema()) {
    if (!element.starts_with("sensor/")) continue;
    const std::string kind = element.substr(7);
    parts = rest(servo_of_j + fmt::format("<sensor><{} %/></sensor>", kind));
    const auto has = [&](std::string_view name) { return std::ranges::find(rule.used, name) != rule.used.end(); };
    Attributes always;
    if (has("site")) always["site"] = "s";
    if (has("joint")) always["joint"] = "j";
    if (has("actuator")) always["actuator"] = "a";
    if (has("body")) always["body"] = "b";
    if (has("objname")) always = {{"objtype", "site"}, {"objname", "s"}};
    places[element] = {parts, always};
  }
  parts = {};
  parts.defaults = "<default><default class='c'><geom rgba='1 0 0 1'/></default></default>";
  parts.world = "%";
  places["worldbody"] = {parts};
  return places;
}

/// Two values of an attribute that make different models; "-": it is not there. `also`: other attributes for it.
struct Probe {
  std::string one, other;
  Attributes also{};
};
using Probes = std::map<std::string, Probe>;

const Probes& orientations() {
  static const Probes all{{"quat", {"1 0 0 0", "1 1 0 0"}},
                          {"axisangle", {"1 0 0 .1", "1 0 0 .2"}},
                          {"xyaxes", {"1 0 0 0 1 0", "0 1 0 -1 0 0"}},
                          {"zaxis", {"0 0 1", "1 0 0"}},
                          {"euler", {"0 0 0", "0 .1 0"}}};
  return all;
}

Probes operator+(Probes a, const Probes& b) {
  a.insert(b.begin(), b.end());
  return a;
}

Probes of_actuator(const Attributes& gains) {
  Attributes without_joint = gains;
  without_joint["joint"] = "-";
  return {{"name", {"-", "b", gains}},
          {"class", {"-", "c", gains}},
          {"joint", {"j", "i", gains}},
          {"tendon", {"single", "double", without_joint}},
          {"forcerange", {"-1 1", "-1 2", gains}},
          {"forcelimited", {"true", "false", {{"forcerange", "-1 1"}}}},
          {"ctrlrange", {"-1 1", "-1 2", gains}},
          {"ctrllimited", {"true", "false", {{"ctrlrange", "-1 1"}}}},
          {"gear", {"1", "-2", {{"forcerange", "-1 2"}}}}};
}

const Probes& of_sensor() {
  static const Probes all{{"name", {"one", "two"}},   {"noise", {"0", "1"}},         {"cutoff", {"0", "1"}},
                          {"site", {"s", "none"}},    {"joint", {"j", "i"}},         {"actuator", {"a", "none"}},
                          {"objname", {"s", "none"}}, {"objtype", {"site", "geom"}}, {"body", {"b", "k"}}};
  return all;
}

std::map<std::string, Probes> make_probes() {
  const Probes place = orientations() + Probes{{"pos", {"0 0 0", "0 0 1"}}};
  const Probes named{{"name", {"x_sole", "y"}}, {"class", {"-", "c"}}};
  std::map<std::string, Probes> probes;
  probes["mujoco"] = {{"model", {"a", "b"}}};
  probes["compiler"] = {{"angle", {"radian", "degree"}},
                        {"eulerseq", {"xyz", "zyx"}},
                        {"autolimits", {"true", "false"}},
                        {"inertiafromgeom", {"true", "false"}},
                        {"coordinate", {"local", "global"}},
                        {"meshdir", {".", "sub", {{"strippath", "true"}}}},
                        {"assetdir", {".", "sub", {{"strippath", "true"}}}},
                        {"texturedir", {".", "sub"}},
                        {"strippath", {"false", "true"}},
                        {"inertiagrouprange", {"0 5", "1 5"}},
                        {"boundmass", {"0", "50"}},
                        {"boundinertia", {"0", "50"}},
                        {"settotalmass", {"-1", "5"}},
                        {"balanceinertia", {"false", "true", {{"inertiafromgeom", "auto"}}}}};
  probes["default"] = {{"class", {"c", "d"}}};
  probes["mesh"] = {{"name", {"mesh", "other"}},
                    {"class", {"-", "c"}},
                    {"file", {"a.obj", "b.obj"}},
                    {"vertex", {"0 0 0 1 0 0 0 1 0 0 0 1", "0 0 0 1 0 0 0 1 0 0 0 2", {{"file", "-"}}}},
                    {"face",
                     {"-",
                      "0 2 1 0 1 3 0 3 2 1 2 3",
                      {{"file", "-"}, {"inertia", "shell"}, {"vertex", "0 0 0 1 0 0 0 1 0 0 0 1 1 1 1"}}}},
                    {"scale", {"1 1 1", "1 2 1"}},
                    {"refpos", {"0 0 0", "0 .1 0"}},
                    {"refquat", {"1 0 0 0", "1 1 0 0"}},
                    {"inertia", {"exact", "shell"}},
                    {"material", {"-", "red"}}};
  probes["material"] = {{"name", {"red", "blue"}},
                        {"class", {"-", "c"}},
                        {"rgba", {"1 0 0 1", "1 0 0 .5"}},
                        {"texture", {"-", "paint"}},
                        {"texrepeat", {"1 1", "2 1"}}};
  probes["texture"] = {{"name", {"paint", "other"}},
                       {"type", {"2d", "cube", {{"builtin", "-"}, {"file", "a.png"}}}},
                       {"file", {"a.png", "b.png", {{"builtin", "-"}, {"type", "2d"}}}},
                       {"builtin", {"flat", "gradient"}},
                       {"rgb1", {"1 0 0", "0 1 0"}},
                       {"rgb2", {"1 0 0", "0 1 0"}}};
  probes["joint"] = {{"name", {"j", "n"}},
                     {"class", {"-", "c", {{"axis", "-"}}}},
                     {"type", {"hinge", "slide"}},
                     {"pos", {"0 0 0", "0 0 1"}},
                     {"axis", {"0 1 0", "0 0 1"}},
                     {"range", {"-1 1", "-1 2"}},
                     {"limited", {"true", "false", {{"range", "-1 1"}}}},
                     {"armature", {"0", "1"}},
                     {"damping", {"0", "1"}},
                     {"frictionloss", {"0", "1"}},
                     {"actuatorfrcrange", {"-1 1", "-1 2"}},
                     {"actuatorfrclimited", {"true", "false", {{"actuatorfrcrange", "-1 1"}}}},
                     {"ref", {"0", ".5"}},
                     {"stiffness", {"0", "1"}},
                     {"springref", {"0", "1", {{"stiffness", "1"}}}},
                     {"springdamper", {"1 1", "2 1"}}};
  probes["freejoint"] = {{"name", {"free", "root"}}};
  probes["inertial"] = place + Probes{{"mass", {"1", "2"}},
                                      {"diaginertia", {"1 2 3", "2 2 3"}},
                                      {"fullinertia", {"1 2 3 0 0 0", "1 2 3 .1 0 0", {{"diaginertia", "-"}}}}};
  probes["geom"] = place + Probes{{"name", {"x", "y"}},
                                  {"class", {"-", "c"}},
                                  {"type", {"box", "ellipsoid"}},
                                  {"size", {".1 .2 .3", ".2 .2 .3"}},
                                  {"fromto", {"0 0 0 1 0 0", "0 0 0 0 1 0", {{"type", "capsule"}}}},
                                  {"friction", {"1", ".5"}},
                                  {"rgba", {"1 0 0 1", "1 0 0 0"}},
                                  {"mass", {"1", "2"}},
                                  {"density", {"1000", "500"}},
                                  {"contype", {"1", "2"}},
                                  {"conaffinity", {"1", "2"}},
                                  {"mesh", {"mesh", "big", {{"type", "mesh"}, {"size", "-"}}}},
                                  {"material", {"-", "red"}},
                                  {"group", {"0", "3"}}};
  probes["site"] = named + place +
                   Probes{{"type", {"box", "sphere"}},
                          {"size", {".1 .2 .3", ".2 .2 .3"}},
                          {"fromto", {"0 0 0 0 0 1", "0 0 0 0 1 0"}}};
  const Attributes sensor{{"sensorsize", ".01 .01"}, {"focal", ".01 .01"}};
  Attributes pixels = sensor;
  pixels["focal"] = "-";
  pixels["focalpixel"] = "100 100";
  probes["camera"] = named + place +
                     Probes{{"mode", {"fixed", "track"}},
                            {"fovy", {"45", "60"}},
                            {"resolution", {"640 480", "320 240"}},
                            {"focal", {".01 .01", ".02 .02", sensor}},
                            {"focalpixel", {"100 100", "200 200", pixels}},
                            {"principal", {"0 0", ".001 0", sensor}},
                            {"principalpixel", {"0 0", "5 0", sensor}},
                            {"sensorsize", {".01 .01", ".02 .02", sensor}},
                            {"orthographic", {"false", "true"}},
                            {"projection", {"perspective", "orthographic"}}};
  probes["body"] = named + place + Probes{{"childclass", {"-", "c"}}};
  probes["frame"] = place + Probes{{"childclass", {"-", "c"}}};
  probes["worldbody"] = {{"childclass", {"-", "c"}}};
  probes["replicate"] = {{"count", {"2", "3"}},
                         {"offset", {"0 0 0", "0 1 0"}},
                         {"euler", {"0 0 0", "0 1 0"}},
                         {"sep", {"-", "_"}}};
  probes["exclude"] = {{"body1", {"l", "b"}}, {"body2", {"k", "b"}}};
  probes["pair"] = {{"geom1", {"g", "trunk"}}, {"geom2", {"h", "trunk"}}};
  probes["equality/joint"] = {{"joint1", {"j", "none"}},
                              {"joint2", {"i", "none"}},
                              {"polycoef", {"0 1", "0 2"}},
                              {"active", {"true", "false"}}};
  const Attributes at_sites{{"body1", "-"}, {"body2", "-"}, {"anchor", "-"}, {"site1", "t"}, {"site2", "s"}};
  probes["connect"] = {
      {"name", {"one", "two"}},       {"active", {"true", "false"}},    {"body1", {"l", "b"}},
      {"body2", {"k", "b"}},          {"anchor", {".1 0 0", ".2 0 0"}}, {"site1", {"t", "u", at_sites}},
      {"site2", {"s", "u", at_sites}}};
  probes["weld"] = probes["connect"] + Probes{{"relpose", {"0 0 0 1 0 0 0", "0 0 0 1 1 0 0"}}};
  const Attributes limits{{"actuatorfrcrange", "-1 1"}};
  const Probes along{{"range", {"0 1", "0 2"}},
                     {"limited", {"true", "false", {{"range", "0 1"}}}},
                     {"stiffness", {"1", "2"}},
                     {"springlength", {".1", ".2 .4", {{"stiffness", "1"}}}},
                     {"damping", {"1", "2"}},
                     {"armature", {"1", "2"}},
                     {"frictionloss", {"1", "2"}},
                     {"actuatorfrcrange", {"-1 1", "-1 2"}},
                     {"actuatorfrclimited", {"true", "false", limits}}};
  probes["default/tendon"] = along;
  probes["fixed"] = probes["spatial"] = along + Probes{{"name", {"t", "w"}}, {"class", {"-", "c"}}};
  probes["fixed/joint"] = {{"joint", {"j", "i"}}, {"coef", {"1", "2"}}};
  probes["spatial/site"] = {{"site", {"s", "u"}}};
  probes["spatial/geom"] = {{"geom", {"ball", "trunk"}}, {"sidesite", {"-", "o"}}};
  probes["pulley"] = {{"divisor", {"1", "2"}}};
  probes["equality/tendon"] = {{"tendon1", {"t", "v"}},
                               {"tendon2", {"u", "v"}},
                               {"polycoef", {"0 1", "0 2"}},
                               {"active", {"true", "false"}}};
  probes["key"] = {{"name", {"one", "two"}},
                   {"qpos", {"0 0 1 1 0 0 0 .1 .2", "0 0 1 1 1 0 0 .1 .3"}},
                   {"ctrl", {".1", ".2"}}};
  probes["position"] = of_actuator({{"kp", "3"}}) + Probes{{"kp", {"1", "2"}},
                                                           {"kv", {"0", "1"}},
                                                           {"dampratio", {"0", "1"}},
                                                           {"timeconst", {"0", "1"}},
                                                           {"inheritrange", {"0", "1"}}};
  const Attributes held{{"actrange", "-1 1"}};
  probes["intvelocity"] = of_actuator({{"kp", "3"}}) + Probes{{"kp", {"1", "2"}},
                                                              {"kv", {"0", "1"}},
                                                              {"dampratio", {"0", "1"}},
                                                              {"inheritrange", {"0", "1"}},
                                                              {"actrange", {"-1 1", "-1 2"}},
                                                              {"actlimited", {"true", "false", held}}};
  probes["velocity"] = of_actuator({{"kv", "3"}}) + Probes{{"kv", {"1", "2"}}};
  probes["motor"] = of_actuator({{"forcerange", "-9 9"}});
  probes["motor"]["forcerange"] = {"-1 1", "-1 2"};
  const Attributes affine{{"biastype", "affine"}, {"gainprm", "3"}, {"biasprm", "0 -3 -1"}, {"ctrlrange", "-1 1"}};
  Attributes filter = affine;
  filter["dyntype"] = "filterexact";
  Attributes integral = affine;
  integral["dyntype"] = "integrator";
  Attributes held_integral = integral;
  held_integral["actrange"] = "-1 1";
  probes["general"] =
      of_actuator(affine) +
      Probes{{"gainprm", {"3", "4", affine}},          {"biasprm", {"0 -3", "0 -4", affine}},
             {"gaintype", {"fixed", "affine"}},        {"biastype", {"none", "affine", affine}},
             {"dyntype", {"none", "filter", affine}},  {"dynprm", {".1", ".2", filter}},
             {"actrange", {"-1 1", "-1 2", integral}}, {"actlimited", {"true", "false", held_integral}}};
  return probes;
}

TEST(MjcfActs, EveryAttributeThatActsMakesADifference) {
  const auto places = make_places();
  const auto probes = make_probes();
  int looked_at = 0;
  for (const auto& [element, rule] : mjcf_schema()) {
    const bool sensor = element.starts_with("sensor/");
    const auto known = probes.find(element);
    for (const std::string_view attribute : rule.used) {
      const std::string name = fmt::format("{}.{}", element, attribute);
      // they need another file: ModelsAreAttachedWithAllThatBelongsToThem
      if (element == "asset/model" || element == "attach") continue;
      const Probes& own = sensor ? of_sensor() : known == probes.end() ? Probes{} : known->second;
      const auto probe = own.find(std::string(attribute));
      ASSERT_NE(probe, own.end()) << name << " acts, but no test says how";
      const Place& place = places.at(element);
      const auto result = [&](const std::string& value) {
        Attributes attributes = probe->second.also;
        attributes[std::string(attribute)] = value;
        return result_of(with(place, attributes));
      };
      const std::string one = result(probe->second.one), other = result(probe->second.other);
      EXPECT_NE(one, "refused") << name;
      EXPECT_NE(one, other) << name;
      ++looked_at;
    }
  }
  EXPECT_GT(looked_at, 150);
}

}  // namespace
}  // namespace murosimf::robot_formats::mjcf
