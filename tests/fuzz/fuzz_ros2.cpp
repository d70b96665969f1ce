// Messages of ROS 2 nodes: commands of a robot, goals, requests of services in both forms.
#include <cmath>
#include <cstdlib>

#include "murosimf/dds/ros2/command_messages.h"
#include "murosimf/dds/ros2/service.h"
#include "murosimf/ros2/simulation_messages.h"
#include "tests/fuzz/fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace murosimf::dds::ros2;
  const Encoded message(data, size);
  if (const auto goal = read_goal(message)) {
    for (const TrajectoryPoint& point : goal->trajectory.points) {
      if (point.positions.size() != goal->trajectory.joints.size() || !(point.time >= 0)) std::abort();
    }
  }
  if (const auto joints = read_joint_state(message)) {
    for (const double position : joints->positions) {
      if (!std::isfinite(position)) std::abort();
    }
  }
  (void)read_trajectory(message);
  (void)read_numbers(message);
  (void)read_stamped_twist(message);
  ServiceCall call;
  if (!open_call({message.begin(), message.end()}, {{1, 16}, 1}, call)) return 0;
  murosimf::dds::CdrReader filters(call.request), state(call.request);
  (void)murosimf::ros2::read_filters(filters);
  (void)murosimf::ros2::read_state(state);
  return 0;
}
