// Recordings of a servo, JSON.
#include "murosimf/identification/servo_log_reader.h"
#include "tests/fuzz/fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace murosimf;
  fuzz::feed(data, size, ".json", [](const auto& file) { (void)identification::read_servo_log(file); });
  return 0;
}
