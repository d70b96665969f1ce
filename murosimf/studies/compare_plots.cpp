#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "murosimf/files/output_file.h"
#include "murosimf/logging/plot.h"
#include "murosimf/math/assert.h"
#include "murosimf/studies/compare_report.h"

namespace murosimf::studies {
namespace {

using dynamics::MotionRecord;
using dynamics::MotionSample;

constexpr double degrees = 180 / pi;

/// `value` of every sample against `across` of it, one curve per run.
template <class Across, class Value>
logging::Panel panel(const Comparison& c, std::string y_label, const Across& across, const Value& value) {
  logging::Panel result{.y_label = std::move(y_label), .curves = {}};
  for (const CompareEntry& entry : c.entries) {
    if (!entry.ran()) continue;
    logging::Curve curve{label(c, entry), {}, {}};
    for (const MotionSample& sample : entry.record.samples) {
      curve.x.push_back(across(sample));
      curve.y.push_back(value(sample));
    }
    result.curves.push_back(std::move(curve));
  }
  return result;
}

template <class Value>
logging::Panel over_time(const Comparison& c, std::string y_label, const Value& value) {
  return panel(
      c, std::move(y_label), [](const MotionSample& s) { return s.time; }, value);
}

/// The joint whose torque is the largest of all runs.
std::string busiest_joint(const Comparison& c) {
  const auto less = [](const CompareEntry& a, const CompareEntry& b) {
    return a.measures.peak_torque < b.measures.peak_torque;
  };
  MUROSIMF_ASSERT(c.reference < c.entries.size());
  const CompareEntry& reference = c.entries[c.reference];
  // The plot follows the reference; a level without torques has no joint to name.
  if (!reference.measures.peak_joint.empty()) return reference.measures.peak_joint;
  return std::max_element(c.entries.begin(), c.entries.end(), less)->measures.peak_joint;
}

logging::Curve torque_curve(const MotionRecord& record, const std::string& name, const std::string& joint) {
  logging::Curve curve{name, {}, {}};
  const auto found = std::find(record.joints.begin(), record.joints.end(), joint);
  if (found == record.joints.end()) return curve;
  const auto column = static_cast<std::size_t>(found - record.joints.begin());
  for (std::size_t i = 1; i < record.samples.size(); ++i) {
    curve.x.push_back(record.samples[i].time);
    curve.y.push_back(record.torques[i * record.joints.size() + column]);
  }
  return curve;
}

/// The largest torque of any joint.
logging::Curve peak_curve(const MotionRecord& record, const std::string& name) {
  logging::Curve curve{name, {}, {}};
  const std::size_t joints = record.joints.size();
  for (std::size_t i = 1; joints > 0 && i < record.samples.size(); ++i) {
    double peak = 0;
    for (std::size_t j = 0; j < joints; ++j) peak = std::max(peak, std::abs(record.torques[i * joints + j]));
    curve.x.push_back(record.samples[i].time);
    curve.y.push_back(peak);
  }
  return curve;
}

void write_torques(const Comparison& c, const std::filesystem::path& folder, const std::string& title) {
  const std::string joint = busiest_joint(c);
  if (joint.empty()) return;
  logging::Panel of_joint{.y_label = joint + " [N m]", .curves = {}};
  logging::Panel largest{.y_label = "largest of all joints [N m]", .curves = {}};
  for (const CompareEntry& entry : c.entries) {
    if (!entry.ran()) continue;
    of_joint.curves.push_back(torque_curve(entry.record, label(c, entry), joint));
    largest.curves.push_back(peak_curve(entry.record, label(c, entry)));
  }
  logging::write_plot(folder / "torque.png", {.title = title + ": required torque",
                                              .x_label = "time [s]",
                                              .panels = {std::move(largest), std::move(of_joint)}});
}

}  // namespace

void check_plots(const std::filesystem::path& folder) {
  logging::check_gnuplot();
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  files::check_writable(folder / "center_of_mass.png");
}

/// One curve for each level, panels with a common axis of time.
void write_plots(const Comparison& c, const std::filesystem::path& folder) {
  const std::string title = fmt::format("{}, {}", c.scene, c.entity);
  const auto plot = [&](const char* file, const std::string& what, std::vector<logging::Panel> panels) {
    logging::write_plot(folder / file,
                        {.title = title + ": " + what, .x_label = "time [s]", .panels = std::move(panels)});
  };
  plot("center_of_mass.png", "center of mass",
       {over_time(c, "forward x [m]", [](const MotionSample& s) { return s.center.x; }),
        over_time(c, "left y [m]", [](const MotionSample& s) { return s.center.y; }),
        over_time(c, "height z [m]", [](const MotionSample& s) { return s.center.z; })});
  logging::Panel pitch = over_time(c, "pitch [deg]", [](const MotionSample& s) { return degrees * s.pitch; });
  logging::Panel roll = over_time(c, "roll [deg]", [](const MotionSample& s) { return degrees * s.roll; });
  pitch.y_at_least = roll.y_at_least = 1;
  plot("torso.png", "torso",
       {std::move(pitch), std::move(roll),
        over_time(c, "angular rate [rad/s]", [](const MotionSample& s) { return norm(s.rate); })});
  if (c.entries[c.reference].record.soles == 2) {
    plot("foot_clearance.png", "foot clearance",
         {over_time(c, "first sole [m]", [](const MotionSample& s) { return s.clearance[0]; }),
          over_time(c, "second sole [m]", [](const MotionSample& s) { return s.clearance[1]; })});
  }
  write_torques(c, folder, title);
}

}  // namespace murosimf::studies
