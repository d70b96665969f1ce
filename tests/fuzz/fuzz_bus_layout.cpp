// Which servo moves which joint.
#include "murosimf/model/properties.h"
#include "murosimf/serial/bus_layout.h"
#include "tests/fuzz/fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace murosimf;
  static const Model model("arm", Chain{}
                                      .base("base")
                                      .with(properties::mass, 1.0)
                                      .with(properties::inertia, {1, 1, 1, 0, 0, 0})
                                      .revolute("shoulder", {0, 1, 0})
                                      .revolute("elbow", {0, 1, 0}));
  fuzz::feed(data, size, ".csv", [](const auto& file) {
    const auto places = serial::read_layout(file, model, serial::dynamixel::Protocol::v2);
    if (places.empty() || places.size() > 2) std::abort();
    for (const serial::ServoPlace& place : places) {
      if (place.joint > 1 || place.id >= serial::first_no_id || !place.table) std::abort();
    }
  });
  return 0;
}
