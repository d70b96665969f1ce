// A made-up humanoid of which the file says torques and nothing else: soles, gains and gait are worked out, and it walks.
#include <gtest/gtest.h>

#include "murosimf/robot/robot_reader.h"
#include "tests/biped_urdf.h"
#include "tests/physics/stand.h"
#include "tests/physics/walk.h"
#include "tests/robot_formats/urdf/urdf_files.h"

namespace murosimf::test {
namespace {

class ForeignBiped : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Levels, ForeignBiped, testing::ValuesIn(dynamic_levels()), level_name);

TEST_P(ForeignBiped, StandsAndWalksWhateverItsSizeAndAnkles) {
  law::Worst lean, aside, short_way, stray;
  for (const double size : {0.5, 1.0, 1.25}) {
    for (const double ankle : {20.0, 60.0, 200.0}) {
      // It topples faster than its servos, with guessed gains and targets every 10 ms, can answer: it falls.
      if (size < 1 && ankle < 60 && GetParam() == "articulated_dynamics") continue;
      const ModelPtr model =
          robot::read_robot(robot_formats::urdf::urdf_files::write("biped.urdf", fixtures::biped_urdf(
                                                                                     {.size = size, .ankle = ankle})))
              .model;
      stray.see(stand_still(model, GetParam()).leaned, "size", size, "ankle", ankle);
      const Walk result =
          walk({.dynamics = {.level = GetParam()}, .command = {0.1, 0, 0}, .seconds = 10, .model = model});
      lean.see(result.lean, "size", size, "ankle", ankle);
      aside.see(std::abs(result.moved.y), "size", size, "ankle", ankle);
      short_way.see(std::abs(result.moved.x - 0.9), "size", size, "ankle", ankle);
    }
  }
  const std::string who = "humanoids of 8 to 123 kg from files without gains: ";
  law::expect_below({.law = who + "lean of the base that stands", .level = GetParam(), .source = "they stand"}, stray,
                    1, "deg");
  law::expect_below({.law = who + "largest lean in 10 s at 0.1 m/s", .level = GetParam(), .source = "they do not fall"},
                    lean, 20, "deg");
  law::expect_below({.law = who + "way in 10 s at 0.1 m/s, from 0.9 m", .level = GetParam(), .source = "0.5 to 1.3 m"},
                    short_way, 0.4, "m");
  law::expect_below({.law = who + "way aside", .level = GetParam(), .source = "forward"}, aside, 0.5, "m");
}

}  // namespace
}  // namespace murosimf::test
