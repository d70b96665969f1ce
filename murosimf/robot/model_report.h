/// model_report.h - the parts of a model, for readers (`murosimf check`) and for programs (JSON).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "murosimf/model/model.h"
#include "murosimf/robot/robot_findings.h"
#include "murosimf/sensors/sensor_spec.h"

namespace murosimf::robot {

/// One line of the tree: the base, a joint, or a fixed object with mass or shape.
struct ReportRow {
  int depth = 0;     ///< number of rows between it and the base
  std::string body;  ///< empty for a joint without mass and shapes
  double mass_kg = 0;
  std::string joint, kind;     ///< empty where there is none
  Vec3d axis;                  ///< unit vector, frame of the object before the joint
  std::optional<Vec3d> range;  ///< [rad | m] lowest, highest, 0
  std::string servo;           ///< type; empty: none
  std::string servo_law;       ///< name
  double stall_torque = 0;     ///< [N m | N] 0: unlimited
  double torque_limit = 0;     ///< [N m | N] from the current limit; 0: none
  double no_load_speed = 0;    ///< [rad/s | m/s] 0: not known
  double position_gain = 0;    ///< [N m/rad | N/m]
};

/// All parts behind one joint at the base.
struct LimbReport {
  std::string joint;
  double mass_kg = 0;
  int joints = 0;
};

/// A leg as the walk engine uses it (locomotion/leg.h).
struct LegReport {
  std::string sole;
  double thigh_m = 0, shin_m = 0;
  double reach_m = 0;        ///< from the hip to the sole, stretched
  bool closed_form = false;  ///< inverse kinematics; else by damped least squares
};

struct ModelReport {
  std::string name;
  double total_mass_kg = 0;
  int joints = 0, bodies = 0, objects = 0;
  std::vector<std::string> soles;
  std::vector<LimbReport> limbs;
  std::vector<LegReport> legs;
  std::vector<sensors::SensorSpec> sensors;
  std::vector<Finding> findings;
  std::vector<ReportRow> tree;
};

[[nodiscard]] ModelReport make_report(const Model& model, std::vector<Finding> findings = {},
                                      std::vector<sensors::SensorSpec> sensors = {});

/// A summary line, a table with one line per row of the tree, limbs, legs, sensors and findings; angles in degrees. At most ten
/// lines of findings, those of one kind in one, unless `all`.
[[nodiscard]] std::string to_text(const ModelReport& report, bool all = false);
/// The same in SI units, angles in rad, with all findings.
[[nodiscard]] std::string to_json(const ModelReport& report);

}  // namespace murosimf::robot
