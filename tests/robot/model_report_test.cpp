/// model_report_test - the report of `murosimf check` has the right numbers and shows every joint.
#include "murosimf/robot/model_report.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "murosimf/model/properties.h"
#include "murosimf/robot/robot_checks.h"

namespace murosimf::robot {
namespace {

ModelReport kid21_report() {
  const robot::RobotFile robot = robot::read_robot(std::filesystem::path(MUROSIMF_SOURCE_DIR) / "models/kid21.xml");
  return make_report(*robot.model, examine(robot));
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// One joint of each kind, without servo and sole.
Model arm() {
  return Model("arm", Chain{}
                          .base("shoulder")
                          .with(properties::mass, 1)
                          .revolute("elbow", {0, 1, 0})
                          .alias("forearm")
                          .with(properties::mass, 2)
                          .with(properties::joint_range, {-0.5 * pi, pi, 0})
                          .translation({1, 0, 0})
                          .prismatic("slider", {1, 0, 0})
                          .with(properties::joint_range, {0, 0.2, 0})
                          .endpoint("hand"));
}

TEST(ModelReport, CountsKid21) {
  const ModelReport report = kid21_report();
  EXPECT_EQ(report.name, "kid21");
  EXPECT_NEAR(report.total_mass_kg, 4.30, 1e-12);
  EXPECT_EQ(report.joints, 21);
  EXPECT_EQ(report.bodies, 22);
  EXPECT_EQ(report.tree.size(), 22u);
  EXPECT_EQ(report.soles, (std::vector<std::string>{"l_sole", "r_sole"}));
  double mass = 0;
  for (const ReportRow& row : report.tree) mass += row.mass_kg;
  EXPECT_NEAR(mass, 4.30, 1e-12);
}

TEST(ModelReport, ShowsTheTreeOfKid21) {
  const std::string text = to_text(kid21_report());
  EXPECT_TRUE(contains(text, "kid21: 4.300 kg, 21 joints, 22 bodies"));
  EXPECT_TRUE(contains(text, "soles: l_sole, r_sole"));
  EXPECT_TRUE(contains(text, "\n    l_hip_roll "));
  EXPECT_TRUE(contains(text, "mx64 dc_motor 6 N m, 6.6 rad/s\n"));
  EXPECT_FALSE(contains(text, "no servo moves"));
}

TEST(ModelReport, ListsSensors) {
  std::vector<sensors::SensorSpec> sensors{{.name = "eye", .type = "laser", .frame = "hand", .rate = 40}};
  sensors.push_back({.name = "knees", .type = "joint_position", .objects = {"a", "b"}, .part = "steps"});
  const ModelReport report = make_report(arm(), {}, sensors);
  EXPECT_TRUE(contains(to_text(report), "sensor eye: laser on hand, 40 Hz\n"));
  EXPECT_TRUE(contains(to_text(report), "sensor knees: joint_position of a, b, every step, part steps\n"));
  EXPECT_TRUE(contains(to_json(report), "\"rate_hz\": 40.0"));
  EXPECT_TRUE(contains(to_json(report), "\"part\": \"steps\""));
}

TEST(ModelReport, ShowsRangesInDegreesAndMetres) {
  const std::string text = to_text(make_report(arm()));
  EXPECT_TRUE(contains(text, "forearm"));
  EXPECT_TRUE(contains(text, "-90 to 180 deg"));
  EXPECT_TRUE(contains(text, "0 to 0.2 m"));
}

TEST(ModelReport, ShowsTheLimitsOfServos) {
  Servo limited, ideal;
  limited.type = "mx106";
  limited.stall_torque = 8;
  limited.no_load_speed = 5;
  limited.position_gain = 21;
  limited.torque_limit = 3;
  ideal.type = "position";
  ideal.law = "ideal_pd";
  const Model model("arm", Chain{}
                               .base("b")
                               .with(properties::mass, 1)
                               .revolute("elbow", {0, 1, 0})
                               .with(properties::servo, limited)
                               .prismatic("slider", {1, 0, 0})
                               .with(properties::servo, ideal));
  const std::string text = to_text(make_report(model));
  EXPECT_TRUE(contains(text, "mx106 dc_motor 8 N m, 5 rad/s, at most 3 N m\n")) << text;
  EXPECT_TRUE(contains(text, "position ideal_pd unlimited\n")) << text;
  const std::string json = to_json(make_report(model));
  EXPECT_TRUE(contains(json, "\"servo_law\": \"ideal_pd\"")) << json;
  EXPECT_TRUE(contains(json, "\"torque_limit\": 3.0")) << json;
  EXPECT_TRUE(contains(json, "\"no_load_speed\": 5.0")) << json;
  EXPECT_TRUE(contains(json, "\"position_gain\": 21.0")) << json;
}

TEST(ModelReport, ShowsFindingsLimbsAndLegs) {
  const ModelReport report = kid21_report();
  ASSERT_EQ(report.legs.size(), 2u);
  EXPECT_TRUE(report.legs[0].closed_form);
  double limbs = 0;
  for (const LimbReport& limb : report.limbs) limbs += limb.mass_kg;
  EXPECT_LT(limbs, report.total_mass_kg);
  const ModelReport odd = make_report(arm(), {make_finding(Severity::warning, "a.xml:1: odd; mend it")});
  EXPECT_TRUE(contains(to_text(odd), "warning: a.xml:1: odd; mend it\n"));
}

TEST(ModelReport, IsWrittenAsJson) {
  const std::string json = to_json(make_report(arm(), {make_finding(Severity::error, "say \"hello\"")}));
  EXPECT_TRUE(contains(json, "\"name\": \"arm\""));
  EXPECT_TRUE(contains(json, "\"joints\": 2"));
  EXPECT_TRUE(contains(json, "\"total_mass_kg\": 3.0"));
  EXPECT_TRUE(contains(json, "\"kind\": \"prismatic\""));
  EXPECT_TRUE(contains(json, "\"severity\": \"error\""));
  EXPECT_TRUE(contains(json, "say \\\"hello\\\""));
}

TEST(RobotFindings, LinesOfReadersAreTakenApart) {
  const Finding whole = make_finding(Severity::warning, "dir/a b.xml:12: this: is odd; mend it");
  EXPECT_EQ(whole.where, "dir/a b.xml:12");
  EXPECT_EQ(whole.what, "this: is odd");
  EXPECT_EQ(whole.advice, "mend it");
  EXPECT_EQ(to_line(whole), "warning: dir/a b.xml:12: this: is odd; mend it");
  const Finding bare = make_finding(Severity::note, "model 'a': odd");
  EXPECT_EQ(bare.where, "");
  EXPECT_EQ(bare.what, "model 'a': odd");
}

}  // namespace
}  // namespace murosimf::robot
