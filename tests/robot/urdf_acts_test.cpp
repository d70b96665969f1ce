// Every attribute of URDF that the schema lists as used has an effect, and so has every element of gazebo blocks.
#include <set>

#include <fmt/format.h>

#include "murosimf/robot/robot_reader.h"
#include "murosimf/robot_formats/urdf/gazebo_schema.h"
#include "murosimf/robot_formats/urdf/urdf_schema.h"
#include "tests/robot_formats/urdf/urdf_files.h"

namespace murosimf::robot {
namespace {

using namespace robot_formats::urdf::urdf_files;

/// A robot with every used attribute once, with a value of its own; "{}" are places for probes.
std::string whole_robot(const std::string& gazebo = "") {
  return "<robot name='whole'>"
         "<mujoco><compiler meshdir='meshes' strippath='true' balanceinertia='false'/></mujoco>"
         "<material name='blue'><color rgba='0 0 1 1'/><texture filename='x/a.png'/></material>"
         "<material name='red'><color rgba='1 0 0 1'/></material>"
         "<link name='trunk'><inertial><origin xyz='0 0 0.01' rpy='0 0 0.1'/><mass value='3'/>"
         "<inertia ixx='0.03' ixy='0.001' ixz='0.002' iyy='0.032' iyz='0.003' izz='0.034' iyx='0.001' izx='0.002' "
         "izy='0.003'/></inertial>"
         "<visual name='look'><geometry><mesh filename='x/t.obj' scale='1 2 1'/></geometry><material "
         "name='blue'/></visual>"
         "<visual><geometry><box size='0.1 0.2 0.3'/></geometry><material name='own'><color rgba='0 1 0 "
         "1'/></material></visual>"
         "<collision name='hit'><geometry><cylinder radius='0.11' length='0.21'/></geometry></collision>"
         "<collision><geometry><capsule radius='0.12' length='0.22'/></geometry></collision>"
         "<collision><geometry><sphere radius='0.13'/></geometry></collision>"
         "<contact><lateral_friction value='0.9'/></contact></link>"
         "<link name='arm'>" +
         solid() + "</link><link name='hand'>" + solid() +
         "</link><link name='flat'><inertial>"
         "<mass value='1'/><inertia ixx='1' iyy='1' izz='2.5'/></inertial></link>"
         "<joint name='shoulder' type='revolute'><origin xyz='0 0.1 0' rpy='0.2 0 0'/><parent link='trunk'/>"
         "<child link='arm'/><axis xyz='0 1 0'/><limit lower='-1' upper='1.5' effort='20' velocity='6'/>"
         "<dynamics damping='0.4' friction='0.5'/></joint>"
         "<joint name='wrist' type='revolute'><parent link='arm'/><child link='hand'/><axis xyz='0 0 1'/>"
         "<limit lower='-4' upper='4' effort='3' velocity='0'/><mimic joint='shoulder' multiplier='0.7' "
         "offset='0.2'/></joint>"
         "<joint name='third' type='revolute'><parent link='arm'/><child link='flat'/><axis xyz='1 0 0'/>"
         "<limit lower='-2' upper='2' effort='3' velocity='9'/></joint>" +
         gazebo + "</robot>";
}

/// All data of a description, as a text.
std::string text_of(const robot_formats::RobotDescription& robot) {
  std::string text = robot.name;
  const auto put = [&](const auto&... values) { ((text += fmt::format(" {}", values)), ...); };
  const auto vector = [&](const Vec3d& v) { put(v.x, v.y, v.z); };
  const auto place = [&](const Transformd& t) {
    vector(t.position);
    for (const Vec3d& axis : {t.orientation.x, t.orientation.y, t.orientation.z}) vector(axis);
  };
  for (const auto& body : robot.bodies) {
    put(body.name, body.parent, body.solid.mass);
    place(body.place);
    vector(body.solid.center);
    const SymMat3d& I = body.solid.inertia;
    put(I.xx, I.yy, I.zz, I.xy, I.xz, I.yz);
    for (const auto& joint : body.joints) {
      put(joint.name, static_cast<int>(joint.kind), joint.damping, joint.friction, joint.stiffness,
          joint.spring_reference, joint.effort_limit, joint.rate_limit);
      vector(joint.axis);
      if (joint.range) vector(*joint.range);
    }
    for (const auto& shape : body.shapes) {
      put(shape.name, robot_formats::volume(shape.placed.shape), shape.placed.collides, shape.placed.color.red,
          shape.placed.color.green, shape.placed.color.blue, shape.placed.surface.friction);
      vector(robot_formats::unit_inertia(shape.placed.shape).xx * Vec3d{1, 1, 1});
      place(shape.placed.place());
    }
    for (const auto& visual : body.visuals)
      put(visual.name, visual.mesh, visual.color.red, visual.color.blue, visual.picture);
  }
  for (const auto& mimic : robot.mimics) put(mimic.joint, mimic.leader, mimic.ratio, mimic.offset);
  for (const auto& mesh : robot.meshes) put(mesh.file.string(), mesh.scale.y);
  for (const auto& sensor : robot.sensors) {
    put(sensor.kind, sensor.name, sensor.frame, sensor.rate);
    place(sensor.place);
    for (const auto& [key, number] : sensor.numbers) put(key, number);
    for (const auto& [key, word] : sensor.texts) put(key, word);
    for (const auto& [output, s] : sensor.signals) put(output, s.mean, s.noise, s.bias_mean, s.bias, s.resolution);
  }
  for (const std::string& warning : robot.warnings) put(warning);
  return text;
}

/// The description of a file, or the reason of its refusal.
std::string meaning(const std::string& xml) {
  try {
    return text_of(read(xml));
  } catch (const SetupError& error) {
    return error.what();
  }
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

using Change = std::pair<std::string, std::string>;

const std::map<std::string, Change>& attribute_probes() {
  static const std::map<std::string, Change> probes{
      {"lateral_friction.value", {"value='0.9'", "value='0.8'"}},
      {"robot.name", {"'whole'", "'other'"}},
      {"link.name", {"name='flat'", "name='plate'"}},
      {"origin.xyz", {"0 0.1 0", "0 0.2 0"}},
      {"origin.rpy", {"0.2 0 0", "0.3 0 0"}},
      {"mass.value", {"value='3'", "value='4'"}},
      {"inertia.ixx", {"ixx='0.03'", "ixx='0.031'"}},
      {"inertia.ixy", {"ixy='0.001'", "ixy='0.0015'"}},
      {"inertia.ixz", {"ixz='0.002'", "ixz='0.0025'"}},
      {"inertia.iyy", {"iyy='0.032'", "iyy='0.033'"}},
      {"inertia.iyz", {"iyz='0.003'", "iyz='0.0035'"}},
      {"inertia.izz", {"izz='0.034'", "izz='0.035'"}},
      {"inertia.iyx", {"iyx='0.001'", "iyx='0.0015'"}},
      {"inertia.izx", {"izx='0.002'", "izx='0.0025'"}},
      {"inertia.izy", {"izy='0.003'", "izy='0.0035'"}},
      {"visual.name", {"'look'", "'other'"}},
      {"collision.name", {"'hit'", "'other'"}},
      {"box.size", {"0.1 0.2 0.3", "0.1 0.2 0.4"}},
      {"cylinder.radius", {"radius='0.11'", "radius='0.14'"}},
      {"cylinder.length", {"length='0.21'", "length='0.24'"}},
      {"capsule.radius", {"radius='0.12'", "radius='0.14'"}},
      {"capsule.length", {"length='0.22'", "length='0.24'"}},
      {"sphere.radius", {"radius='0.13'", "radius='0.14'"}},
      {"mesh.filename", {"x/t.obj", "x/u.obj"}},
      {"mesh.scale", {"1 2 1", "1 3 1"}},
      {"material.name", {"<material name='blue'/>", "<material name='red'/>"}},
      {"color.rgba", {"0 1 0 1", "0 0.5 0 1"}},
      {"texture.filename", {"x/a.png", "x/b.png"}},
      {"joint.name", {"name='third'", "name='fourth'"}},
      {"joint.type", {"name='third' type='revolute'", "name='third' type='prismatic'"}},
      {"parent.link", {"<parent link='arm'/><child link='flat'/>", "<parent link='trunk'/><child link='flat'/>"}},
      {"child.link", {"<child link='flat'/>", "<child link='hand'/>"}},
      {"axis.xyz", {"1 0 0'/><limit lower='-2'", "0 1 0'/><limit lower='-2'"}},
      {"limit.lower", {"lower='-1'", "lower='-1.1'"}},
      {"limit.upper", {"upper='1.5'", "upper='1.6'"}},
      {"limit.effort", {"effort='20'", "effort='21'"}},
      {"limit.velocity", {"velocity='6'", "velocity='7'"}},
      {"dynamics.damping", {"damping='0.4'", "damping='0.45'"}},
      {"dynamics.friction", {"friction='0.5'", "friction='0.55'"}},
      {"mimic.joint", {"mimic joint='shoulder'", "mimic joint='third'"}},
      {"mimic.multiplier", {"multiplier='0.7'", "multiplier='0.8'"}},
      {"mimic.offset", {"offset='0.2'", "offset='0.3'"}},
      {"compiler.meshdir", {"meshdir='meshes'", "meshdir='others'"}},
      {"compiler.strippath", {"strippath='true'", "strippath='false'"}},
      {"compiler.balanceinertia", {"balanceinertia='false'", "balanceinertia='true'"}},
  };
  return probes;
}

TEST(UrdfActs, EveryUsedAttributeMakesADifference) {
  write("meshes/t.obj", tetrahedron());
  write("meshes/u.obj", tetrahedron());
  for (const char* picture : {"meshes/a.png", "meshes/b.png"}) write(picture, "found, and not read");
  const std::string base = whole_robot();
  const std::string before = meaning(base);
  ASSERT_TRUE(contains(before, "whole")) << before;
  for (const auto& [element, rule] : robot_formats::urdf::urdf_schema()) {
    for (const std::string_view attribute : rule.used) {
      const std::string name = fmt::format("{}.{}", element, attribute);
      const auto probe = attribute_probes().find(name);
      if (probe == attribute_probes().end()) {
        ADD_FAILURE() << name << " is used, says the schema: change it in a probe";
        continue;
      }
      EXPECT_NE(meaning(replaced(base, probe->second.first, probe->second.second)), before) << name;
    }
  }
}

std::string sensor(const std::string& type, const std::string& inside) {
  return "<gazebo reference='shoulder'><sensor name='s' type='" + type + "'>" + inside + "</sensor></gazebo>";
}
std::string of_joint(const std::string& inside) { return "<gazebo reference='shoulder'>" + inside + "</gazebo>"; }
std::string of_link(const std::string& inside) { return "<gazebo reference='trunk'>" + inside + "</gazebo>"; }
std::string in(const std::string& path, std::string inside) {
  for (std::size_t end = path.size(); end != std::string::npos;) {
    const std::size_t slash = end == 0 ? std::string::npos : path.rfind('/', end - 1);
    const std::string tag =
        path.substr(slash == std::string::npos ? 0 : slash + 1, end - (slash == std::string::npos ? 0 : slash + 1));
    inside = "<" + tag + ">" + inside + "</" + tag + ">";
    end = slash;
  }
  return inside;
}

/// Elements of gazebo blocks with a value: a block with it, and one with another value.
const std::map<std::string, Change>& element_probes() {
  const auto camera = [](const std::string& path, const std::string& a, const std::string& b) {
    return Change{sensor("camera", in("camera/" + path, a)), sensor("camera", in("camera/" + path, b))};
  };
  const auto scan = [](const std::string& tag, const std::string& a, const std::string& b) {
    const std::string path = "ray/scan/horizontal/" + tag;
    return Change{sensor("ray", in(path, a)), sensor("ray", in(path, b))};
  };
  const auto range = [](const std::string& tag) {
    return Change{sensor("ray", in("ray/range/" + tag, "0.1")), sensor("ray", in("ray/range/" + tag, "0.2"))};
  };
  const auto surface = [](const std::string& inside) { return of_link(in("collision/surface/friction/ode", inside)); };
  const std::string lens = "<fx>200</fx><fy>200</fy>";
  static const std::map<std::string, Change> probes{
      {"gazebo/mu1", {of_link("<mu1>0.5</mu1>"), of_link("<mu1>0.6</mu1>")}},
      {"gazebo/mu2", {of_link("<mu2>0.5</mu2>"), of_link("<mu2>0.6</mu2>")}},
      {"ode/mu", {surface("<mu>0.5</mu>"), surface("<mu>0.6</mu>")}},
      {"ode/mu2", {surface("<mu2>0.5</mu2>"), surface("<mu2>0.6</mu2>")}},
      {"gazebo/springStiffness", {of_joint(in("springStiffness", "1")), of_joint(in("springStiffness", "2"))}},
      {"gazebo/springReference", {of_joint(in("springReference", "1")), of_joint(in("springReference", "2"))}},
      {"sensor/pose", {sensor("imu", in("pose", "0 0 1 0 0 0")), sensor("imu", in("pose", "0 0 2 0 0 0"))}},
      {"sensor/update_rate", {sensor("imu", in("update_rate", "100")), sensor("imu", in("update_rate", "50"))}},
      {"camera/pose", camera("pose", "0 0 1 0 0 0", "0 0 2 0 0 0")},
      {"camera/horizontal_fov", camera("horizontal_fov", "1", "1.5")},
      {"image/width", camera("image/width", "100", "200")},
      {"image/height", camera("image/height", "100", "200")},
      {"intrinsics/fx", camera("lens/intrinsics", lens, "<fx>210</fx><fy>200</fy>")},
      {"intrinsics/fy", camera("lens/intrinsics", lens, "<fx>200</fx><fy>210</fy>")},
      {"intrinsics/cx", camera("lens/intrinsics", lens, lens + "<cx>9</cx>")},
      {"intrinsics/cy", camera("lens/intrinsics", lens, lens + "<cy>9</cy>")},
      {"intrinsics/s", camera("lens/intrinsics", lens, lens + "<s>9</s>")},
      {"horizontal/samples", scan("samples", "10", "20")},
      {"horizontal/resolution", scan("resolution", "1", "2")},
      {"horizontal/min_angle", scan("min_angle", "-1", "-2")},
      {"horizontal/max_angle", scan("max_angle", "1", "2")},
      {"range/min", range("min")},
      {"range/max", range("max")},
      {"range/resolution", range("resolution")},
      {"force_torque/frame",
       {sensor("force_torque", in("force_torque/frame", "child")),
        sensor("force_torque", in("force_torque/frame", "parent"))}},
      {"force_torque/measure_direction",
       {sensor("force_torque", in("force_torque/measure_direction", "child_to_parent")),
        sensor("force_torque", in("force_torque/measure_direction", "parent_to_child"))}},
      {"distortion/k1", camera("distortion/k1", "0.1", "0.2")},
      {"distortion/k2", camera("distortion/k2", "0.1", "0.2")},
      {"distortion/k3", camera("distortion/k3", "0.1", "0.2")},
      {"distortion/p1", camera("distortion/p1", "0.1", "0.2")},
      {"distortion/p2", camera("distortion/p2", "0.1", "0.2")},
  };
  return probes;
}

/// Elements that only hold others, and those of noise (urdf_noise_test.cpp) and of plugins.
bool holds_others(const std::string& name) {
  static const std::set<std::string> tags{"collision",
                                          "surface",
                                          "friction",
                                          "ode",
                                          "sensor",
                                          "imu",
                                          "ray",
                                          "lidar",
                                          "camera",
                                          "force_torque",
                                          "plugin",
                                          "noise",
                                          "scan",
                                          "horizontal",
                                          "range",
                                          "image",
                                          "lens",
                                          "intrinsics",
                                          "distortion",
                                          "angular_velocity",
                                          "linear_acceleration",
                                          "force",
                                          "torque",
                                          "x",
                                          "y",
                                          "z",
                                          "rate",
                                          "accel"};
  const std::size_t slash = name.rfind('/');
  const std::string parent = name.substr(0, slash);
  return tags.contains(name.substr(slash + 1)) || parent == "noise" || parent == "imu/noise" || parent == "rate" ||
         parent == "accel";
}

TEST(UrdfActs, EveryElementOfAGazeboBlockMakesADifference) {
  write("meshes/t.obj", tetrahedron());
  for (const auto& [element, rule] : robot_formats::urdf::gazebo_schema()) {
    for (const std::string_view child : rule.children) {
      const std::string name = fmt::format("{}/{}", element, child);
      if (holds_others(name)) continue;
      const auto probe = element_probes().find(name);
      if (probe == element_probes().end()) {
        ADD_FAILURE() << name << " acts, says the schema: change it in a probe";
        continue;
      }
      const std::string before = meaning(whole_robot(probe->second.first));
      EXPECT_TRUE(contains(before, "whole")) << name << ": " << before;
      EXPECT_NE(meaning(whole_robot(probe->second.second)), before) << name;
    }
  }
}

TEST(UrdfActs, WhatHasNoEffectIsNamed) {
  write("meshes/t.obj", tetrahedron());
  const auto words = [](const std::string& xml) {
    std::set<std::string> words;
    for (const robot_formats::Unused& unused : read(xml).unused) words.insert(unused.word);
    return words;
  };
  const auto of_gazebo =
      words(whole_robot(sensor("imu", "<always_on>1</always_on><plugin/>") + of_joint("<kp>1</kp>")));
  for (const char* word : {"always_on", "sensor/plugin", "gazebo/kp"}) EXPECT_TRUE(of_gazebo.contains(word)) << word;
  const auto of_joints =
      words(replaced(whole_robot("<transmission name='t'><joint name='shoulder'/><actuator "
                                 "name='m'><mechanicalReduction>50</mechanicalReduction>"
                                 "</actuator></transmission>"),
                     "<dynamics", "<safety_controller k_velocity='1'/><calibration rising='0'/><dynamics"));
  for (const char* word : {"transmission", "transmission/mechanicalReduction", "safety_controller", "calibration"}) {
    EXPECT_TRUE(of_joints.contains(word)) << word;
  }
}

}  // namespace
}  // namespace murosimf::robot
