// Messages to a Booster robot: low-level commands, and requests with their JSON.
#include <cmath>
#include <cstdlib>

#include "murosimf/dds/booster/messages.h"
#include "murosimf/dds/booster/rpc.h"
#include "tests/fuzz/fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace murosimf::dds::booster;
  if (const auto command = read_low_command({data, size})) {
    if (command->motors.size() > most_motors) std::abort();
    for (const murosimf::dds::MotorCommand& motor : command->motors) {
      if (!std::isfinite(motor.q) || !std::isfinite(motor.weight)) std::abort();
    }
  }
  const RpcHandlers handlers{{2000, [](const RpcParameters& given) -> RpcAnswer {
                                return {given.find("mode") ? Status::success : Status::bad_request};
                              }}};
  if (const auto request = read_rpc({data, size})) (void)answer_to(*request, handlers);
  return 0;
}
