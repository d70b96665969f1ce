// Joint angles over time.
#include "murosimf/control_software/trajectory_file.h"
#include "murosimf/model/properties.h"
#include "tests/fuzz/fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace murosimf;
  static const Model model("arm", Chain{}
                                      .base("base")
                                      .with(properties::mass, 1.0)
                                      .with(properties::inertia, {1, 1, 1, 0, 0, 0})
                                      .revolute("knee", {0, 1, 0})
                                      .prismatic("slide", {1, 0, 0}));
  fuzz::feed(data, size, ".csv", [](const auto& file) {
    const control_software::JointTrajectory read = control_software::read_trajectory(file, model);
    if (read.joints.empty() || read.first > read.last) std::abort();
    for (const control_software::JointTrajectory::Joint& joint : read.joints) {
      if (joint.times.empty() || joint.times.size() != joint.values.size()) std::abort();
      (void)control_software::value_at(joint, 0.5 * (read.first + read.last), control_software::Between::line);
    }
  });
  return 0;
}
