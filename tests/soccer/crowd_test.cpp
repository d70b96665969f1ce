// Six robots fight for a ball: none is pressed into another, the ball or the ground (collision/kinematic_separation.h).
#include <gtest/gtest.h>

#include "murosimf/scene/interpenetration_warnings.h"
#include "murosimf/scene/scene.h"

namespace murosimf::soccer {
namespace {

TEST(Crowd, NobodyIsPressedFlat) {
  for (const std::uint64_t seed : {2U, 4U, 7U}) {
    scene::Scene scene("three_on_three", {.seed = seed, .cameras = false});
    scene.simulation().run(from_seconds(scene.spec().duration));
    for (const std::string& line : scene::interpenetration_warnings(scene.simulation().world())) {
      ADD_FAILURE() << "seed " << seed << ": " << line;
    }
  }
}

}  // namespace
}  // namespace murosimf::soccer
