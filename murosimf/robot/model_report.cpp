#include "murosimf/robot/model_report.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "murosimf/files/json_document.h"
#include "murosimf/locomotion/leg.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"
#include "murosimf/model/properties.h"
#include "murosimf/multibody/spatial_tendon.h"
#include "murosimf/robot/finding_groups.h"

namespace murosimf::robot {
namespace {

constexpr std::size_t most_lines = 10;  // of findings: they fit on a screen, below the tree

using nlohmann::json;

/// Name of the body of an object: the alias of a joint, else the object's own name.
std::vector<std::string> body_names(const Model& model) {
  std::vector<std::string> names;
  for (const Object& object : model.objects()) names.push_back(object.name);
  for (const std::string_view name : model.object_names()) {
    const int object = *model.find_object(name);
    if (model.objects()[object].is_joint() && name != model.objects()[object].name) names[object] = name;
  }
  return names;
}

ReportRow make_row(const Model& model, int object, const std::string& body) {
  const Object& o = model.objects()[object];
  MUROSIMF_ASSERT(object >= 0 && object < model.size());
  const double* mass = model.find(properties::mass, object);
  ReportRow row;
  if (mass || model.find(properties::shapes, object) || !o.is_joint()) row.body = body;
  row.mass_kg = mass ? *mass : 0;
  if (!o.is_joint()) return row;
  row.joint = o.name;
  row.kind = kind_name(o.kind);
  row.axis = o.vector;
  if (const Vec3d* range = model.find(properties::joint_range, object)) row.range = *range;
  if (const Servo* servo = model.find(properties::servo, object)) {
    row.servo = servo->type;
    row.servo_law = servo->law;
    row.stall_torque = servo->stall_torque;
    row.torque_limit = servo->torque_limit;
    row.no_load_speed = servo->no_load_speed;
    row.position_gain = servo->position_gain;
  }
  return row;
}

std::vector<ReportRow> make_tree(const Model& model) {
  const auto names = body_names(model);
  std::vector<int> depth_behind(model.size());  // depth of a row after the object
  std::vector<ReportRow> tree;
  for (int i = 0; i < model.size(); ++i) {
    const Object& object = model.objects()[i];
    const int depth = object.parent < 0 ? 0 : depth_behind[object.parent];
    MUROSIMF_ASSERT(object.parent < i);
    const bool shown =
        object.parent < 0 || object.is_joint() || model.find(properties::mass, i) || model.find(properties::shapes, i);
    if (shown) {
      tree.push_back(make_row(model, i, names[i]));
      tree.back().depth = depth;
    }
    depth_behind[i] = depth + (shown ? 1 : 0);
  }
  return tree;
}

std::vector<LimbReport> make_limbs(const Model& model) {
  const Tree& tree = model.tree();
  std::vector<LimbReport> limbs;
  std::vector<int> limb_of(tree.links.size(), -1);
  for (std::size_t l = 1; l < tree.links.size(); ++l) {
    const int parent = tree.links[l].parent;
    MUROSIMF_ASSERT(tree.links[l].parent >= 0 && tree.links[l].parent < static_cast<int>(l));
    if (parent == 0 && multibody::is_tendon(model, tree.links[l].object)) continue;
    if (parent == 0) {
      limb_of[l] = static_cast<int>(limbs.size());
      limbs.push_back({model.objects()[tree.links[l].object].name, 0, 0});
    } else {
      limb_of[l] = limb_of[parent];
    }
    ++limbs[limb_of[l]].joints;
  }
  for (const int body : model.bodies()) {
    const double* mass = model.find(properties::mass, body);
    const int limb = limb_of[tree.link_of[body]];
    MUROSIMF_ASSERT(tree.link_of[body] >= 0 && tree.link_of[body] < static_cast<int>(limb_of.size()));
    if (mass && limb >= 0) limbs[limb].mass_kg += *mass;
  }
  return limbs;
}

std::vector<LegReport> make_legs(const Model& model) {
  std::vector<LegReport> legs;
  for (const int sole : model.having(properties::sole)) {
    try {
      const locomotion::Leg leg = locomotion::find_leg(model, sole);
      legs.push_back({model.objects()[sole].name, leg.thigh, leg.shin, leg.thigh + leg.shin + leg.ankle_height,
                      leg.signs.has_value()});
    } catch (const SetupError&) {
      continue;  // the checks report why (examine_legs)
    }
  }
  return legs;
}

std::string range_text(const ReportRow& row) {
  if (row.joint.empty()) return {};
  if (!row.range) return "unlimited";
  const bool hinge = row.kind == "revolute";
  const double unit = hinge ? 180.0 / pi : 1.0;
  return fmt::format("{:.4g} to {:.4g} {}", unit * row.range->x, unit * row.range->y, hinge ? "deg" : "m");
}

/// "mx64 dc_motor 4.93 N m, 7.4 rad/s", with "at most 3 N m" if the current is limited.
std::string servo_text(const ReportRow& row) {
  if (row.servo.empty()) return {};
  const bool hinge = row.kind == "revolute";
  const char* torque = hinge ? "N m" : "N";
  std::string text = fmt::format("{} {} ", row.servo, row.servo_law);
  text += row.stall_torque > 0 ? fmt::format("{:.3g} {}", row.stall_torque, torque) : "unlimited";
  if (row.no_load_speed > 0) text += fmt::format(", {:.3g} {}", row.no_load_speed, hinge ? "rad/s" : "m/s");
  if (row.torque_limit > 0) text += fmt::format(", at most {:.3g} {}", row.torque_limit, torque);
  return text;
}

using Line = std::array<std::string, 6>;

Line make_line(const ReportRow& row) {
  Line line;
  MUROSIMF_ASSERT(row.depth >= 0);
  line[0] = std::string(2 * static_cast<std::size_t>(row.depth), ' ') + (row.body.empty() ? "-" : row.body);
  line[1] = row.mass_kg > 0 ? fmt::format("{:.3f} kg", row.mass_kg) : "";
  line[2] = row.joint;
  // + 0.0 avoids "-0"
  if (!row.joint.empty()) {
    line[3] = fmt::format("{:.3g} {:.3g} {:.3g}", row.axis.x + 0.0, row.axis.y + 0.0, row.axis.z + 0.0);
  }
  line[4] = range_text(row);
  line[5] = servo_text(row);
  return line;
}

std::string aligned(const std::vector<Line>& lines) {
  std::array<std::size_t, 6> widths{};
  for (const Line& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], line[i].size());
  }
  std::string text;
  for (const Line& line : lines) {
    std::string row;
    for (std::size_t i = 0; i < line.size(); ++i) row += fmt::format("{:<{}}  ", line[i], widths[i]);
    row.erase(row.find_last_not_of(' ') + 1);
    text += row + '\n';
  }
  return text;
}

json findings_array(const ModelReport& report) {
  json findings = json::array();
  for (const Finding& finding : report.findings) {
    findings.push_back({{"severity", severity_name(finding.severity)},
                        {"where", finding.where},
                        {"what", finding.what},
                        {"advice", finding.advice}});
  }
  return findings;
}

json limbs_array(const ModelReport& report) {
  json limbs = json::array();
  for (const LimbReport& limb : report.limbs) {
    limbs.push_back({{"joint", limb.joint}, {"mass_kg", limb.mass_kg}, {"joints", limb.joints}});
  }
  return limbs;
}

json legs_array(const ModelReport& report) {
  json legs = json::array();
  for (const LegReport& leg : report.legs) {
    legs.push_back({{"sole", leg.sole},
                    {"thigh_m", leg.thigh_m},
                    {"shin_m", leg.shin_m},
                    {"reach_m", leg.reach_m},
                    {"closed_form", leg.closed_form}});
  }
  return legs;
}

/// "sensor imu: imu on torso, 200 Hz, part mpu6050"
std::string sensor_text(const sensors::SensorSpec& sensor) {
  const bool of_joints = sensor.type.starts_with("joint_") || sensor.type.starts_with("motor_");
  std::string text = fmt::format("sensor {}: {}", sensor.name, sensor.type);
  if (!sensor.objects.empty()) text += fmt::format(" of {}", fmt::join(sensor.objects, ", "));
  if (!of_joints) text += fmt::format(" on {}", sensor.frame.empty() ? "the base" : sensor.frame);
  text += sensor.rate > 0 ? fmt::format(", {:g} Hz", sensor.rate) : std::string(", every step");
  if (!sensor.part.empty()) text += ", part " + sensor.part;
  return text + "\n";
}

/// Rate 0: every step.
json sensors_array(const ModelReport& report) {
  json sensors = json::array();
  for (const sensors::SensorSpec& sensor : report.sensors) {
    sensors.push_back({{"name", sensor.name},
                       {"type", sensor.type},
                       {"frame", sensor.frame},
                       {"objects", sensor.objects},
                       {"rate_hz", sensor.rate},
                       {"part", sensor.part}});
  }
  return sensors;
}

json row_object(const ReportRow& row) {
  json object{{"depth", row.depth}, {"mass_kg", row.mass_kg}};
  if (!row.body.empty()) object["body"] = row.body;
  if (row.joint.empty()) return object;
  object["joint"] = row.joint;
  object["kind"] = row.kind;
  object["axis"] = {row.axis.x, row.axis.y, row.axis.z};
  if (row.range) object["range"] = {row.range->x, row.range->y};
  if (!row.servo.empty()) {
    object["servo"] = row.servo;
    object["servo_law"] = row.servo_law;
    object["stall_torque"] = row.stall_torque;
    object["torque_limit"] = row.torque_limit;
    object["no_load_speed"] = row.no_load_speed;
    object["position_gain"] = row.position_gain;
  }
  return object;
}

}  // namespace

ModelReport make_report(const Model& model, std::vector<Finding> findings, std::vector<sensors::SensorSpec> sensors) {
  ModelReport report;
  report.name = model.name();
  report.total_mass_kg = model.tree().mass;
  const auto is_joint = [&](int joint) { return !multibody::is_tendon(model, joint); };
  report.joints = static_cast<int>(std::ranges::count_if(model.joints(), is_joint));
  report.bodies = static_cast<int>(model.bodies().size());
  report.objects = model.size();
  for (const int object : model.having(properties::sole)) report.soles.push_back(model.objects()[object].name);
  report.limbs = make_limbs(model);
  report.legs = make_legs(model);
  report.sensors = std::move(sensors);
  report.findings = std::move(findings);
  report.tree = make_tree(model);
  return report;
}

std::string to_text(const ModelReport& report, bool all) {
  std::string text = fmt::format("{}: {:.3f} kg, {} joints, {} bodies, {} objects, soles: {}\n", report.name,
                                 report.total_mass_kg, report.joints, report.bodies, report.objects,
                                 report.soles.empty() ? "none" : fmt::format("{}", fmt::join(report.soles, ", ")));
  std::vector<Line> lines{{"body", "mass", "joint", "axis", "range", "servo"}};
  for (const ReportRow& row : report.tree) lines.push_back(make_line(row));
  text += aligned(lines);
  for (const LimbReport& limb : report.limbs) {
    text += fmt::format("limb behind {}: {:.3f} kg, {} joints\n", limb.joint, limb.mass_kg, limb.joints);
  }
  for (const LegReport& leg : report.legs) {
    text += fmt::format("leg to {}: thigh {:.4g} m, shin {:.4g} m, reach {:.4g} m, inverse kinematics {}\n", leg.sole,
                        leg.thigh_m, leg.shin_m, leg.reach_m, leg.closed_form ? "in closed form" : "numeric");
  }
  for (const sensors::SensorSpec& sensor : report.sensors) text += sensor_text(sensor);
  if (!all) return text + grouped_text(report.findings, most_lines);
  for (const Finding& finding : report.findings) text += to_line(finding) + '\n';
  return text;
}

std::string to_json(const ModelReport& report) {
  json tree = json::array();
  for (const ReportRow& row : report.tree) tree.push_back(row_object(row));
  return files::json_text({{"schema", files::json_schema("check")},
                           {"name", report.name},
                           {"total_mass_kg", report.total_mass_kg},
                           {"joints", report.joints},
                           {"bodies", report.bodies},
                           {"objects", report.objects},
                           {"soles", report.soles},
                           {"limbs", limbs_array(report)},
                           {"legs", legs_array(report)},
                           {"sensors", sensors_array(report)},
                           {"findings", findings_array(report)},
                           {"tree", std::move(tree)}});
}

}  // namespace murosimf::robot
