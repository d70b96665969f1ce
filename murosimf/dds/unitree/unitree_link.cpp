#include "murosimf/dds/unitree/unitree_link.h"

namespace murosimf::dds::unitree {
namespace {

const std::string of_humanoid = "unitree_hg::msg::dds_::", of_service = "unitree_api::msg::dds_::";
const std::string service = "rt/api/motion_switcher/";

}  // namespace

/// Qualities of service are those that programs of the vendor have without saying any: writers are reliable, readers take whatever comes.
UnitreeLink::UnitreeLink(int domain, const std::string& suffix)
    : participant_(domain),
      low_state_(participant_.writer(
          {.name = "rt/lowstate" + suffix, .type = of_humanoid + "LowState_", .reliable = true, .depth = 1})),
      torso_imu_(participant_.writer(
          {.name = "rt/secondary_imu" + suffix, .type = of_humanoid + "IMUState_", .reliable = true, .depth = 1})),
      answers_(participant_.writer(
          {.name = service + "response" + suffix, .type = of_service + "Response_", .reliable = true})) {
  participant_.read({.name = "rt/lowcmd" + suffix, .type = of_humanoid + "LowCmd_"}, inbox_, low_command_mark);
  participant_.read({.name = service + "request" + suffix, .type = of_service + "Request_", .reliable = true}, inbox_,
                    request_mark);
}

void UnitreeLink::answer(const Answer& answer) {
  answer_.clear();
  write_answer(answer_, answer);
  answers_.write(answer_.bytes());
}

}  // namespace murosimf::dds::unitree
