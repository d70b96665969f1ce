// What programs draw for RoboViz, from anywhere in a network: two packets one after the other.
#include "murosimf/drawing/roboviz_drawings.h"
#include "tests/fuzz/fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace murosimf;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  drawing::RobovizDrawings drawings;
  (void)drawings.take(bytes.substr(0, size / 2));
  (void)drawings.take(bytes.substr(size / 2));
  (void)drawings.take(bytes);
  std::size_t points = 0;
  for (const DrawnGroup& group : drawings.shown().groups) {
    for (const DrawnShape& shape : group.shapes) points += shape.points.size();
  }
  if (points > drawing::RobovizDrawings::most_in_all) std::abort();
  return 0;
}
