// Messages to a Unitree robot: low-level commands with their checksum, and requests.
#include <cstdlib>

#include "murosimf/dds/unitree/low_messages.h"
#include "murosimf/dds/unitree/motion_switcher.h"
#include "tests/fuzz/fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace murosimf::dds::unitree;
  if (const auto command = read_low_command({data, size})) {
    murosimf::dds::CdrWriter again;
    write_low_command(again, *command);
    const auto read = read_low_command(again.bytes());
    if (!read || checksum_of(*read) != checksum_of(*command)) std::abort();
  }
  bool stands = true;
  if (const auto request = read_request({data, size})) (void)switch_motion(*request, stands);
  return 0;
}
