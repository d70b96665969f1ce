// TOML files beside a robot; servos in them come from servo tables.
#include "murosimf/io/robot_table.h"
#include "tests/fuzz/fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace murosimf;
  fuzz::feed(data, size, ".toml", [](const auto& file) { (void)io::read_robot_table(file); });
  return 0;
}
