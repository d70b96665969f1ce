#include "murosimf/dds/booster/booster_link.h"

namespace murosimf::dds::booster {
namespace {

const std::string of_robot = "booster_interface::msg::dds_::", of_service = "booster_msgs::msg::dds_::";

}  // namespace

/// States are sent best effort, as they are read: a program that is slow misses some. Requests and answers are reliable.
BoosterLink::BoosterLink(int domain, const std::string& suffix)
    : suffix_(suffix),
      participant_(domain),
      states_{state_writer("rt/low_state", "LowState_"), state_writer("rt/odometer_state", "Odometer_"),
              state_writer("rt/fall_down", "FallDownState_"), state_writer("rt/robot_states", "RobotStatesMsg_"),
              state_writer("rt/battery_state", "BatteryState_")},
      answers_(participant_.writer({std::string(loco_service) + "Resp" + suffix, of_service + "RpcRespMsg_", true})) {
  participant_.read({"rt/joint_ctrl" + suffix, of_robot + "LowCmd_", true}, inbox_, low_command_mark);
  participant_.read({std::string(loco_service) + "Req" + suffix, of_service + "RpcReqMsg_", true}, inbox_,
                    request_mark);
  participant_.read({"rt/kick_ball" + suffix, "brain::msg::dds_::Kick_", true}, inbox_, kick_mark);
}

TopicWriter& BoosterLink::state_writer(const std::string& topic, const std::string& type) {
  return participant_.writer({topic + suffix_, of_robot + type, false});
}

void BoosterLink::answer(const RpcMessage& message) {
  answer_.clear();
  write_rpc(answer_, message);
  answers_.write(answer_.bytes());
}

}  // namespace murosimf::dds::booster
