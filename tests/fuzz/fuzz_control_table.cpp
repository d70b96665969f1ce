// Control tables of users: whatever is taken has a servo that starts, answers and goes on.
#include <memory>

#include "murosimf/serial/dynamixel/bus.h"
#include "murosimf/serial/dynamixel/control_table_file.h"
#include "murosimf/serial/dynamixel/servo_device.h"
#include "tests/fuzz/fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace murosimf;
  using namespace murosimf::serial::dynamixel;
  fuzz::feed(data, size, ".toml", [](const auto& file) {
    const ControlTable table = read_control_table(file);
    Bus bus;
    auto made = std::make_unique<ServoDevice>(table, std::uint8_t{1}, ServoOptions{.torque = true});
    ServoDevice& servo = *made;
    bus.add(std::move(made));
    servo.sense({.angle = 1}, 0);
    servo.advance(0.001);
    (void)bus.execute({table.protocol, 1, 0x01, {}});
    for (std::size_t address = 0; address < table.size(); ++address) {
      (void)servo.read(address, 4);
      (void)servo.write(address, Bytes{1, 0});
    }
    servo.advance(0.001);
  });
  return 0;
}
