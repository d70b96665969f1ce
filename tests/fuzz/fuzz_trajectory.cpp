// Joint angles over time.
#include "murosimf/connect/trajectory_file.h"
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
    const connect::JointTrajectory read = connect::read_trajectory(file, model);
    if (read.joints.empty() || read.first > read.last) std::abort();
    for (const connect::JointTrajectory::Joint& joint : read.joints) {
      if (joint.times.empty() || joint.times.size() != joint.values.size()) std::abort();
      (void)connect::value_at(joint, 0.5 * (read.first + read.last), connect::Between::line);
    }
  });
  return 0;
}
