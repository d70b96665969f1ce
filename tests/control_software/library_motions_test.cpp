// The motion engine for libraries: what it does, and kicks in a direction.
#include <gtest/gtest.h>

#include "murosimf/control_software/controller_task.h"
#include "murosimf/scene/scene.h"
#include "tests/fixtures.h"
#include "tests/written_scene.h"

namespace murosimf::control_software {
namespace {

using namespace std::chrono_literals;

TEST(LibraryMotions, ReadsTheEngineAndHasItKick) {
  const std::string text =
      "[[robots]]\nname = 'one'\nmodel = 'kid21'\nlevel = 'kinematic_walking'\ncontroller = 'library'\nlibrary = '" +
      std::string(MUROSIMF_CONTROLLERS) + "/controller_motions.so'\n";
  scene::Scene scene(fixtures::write_scene(text), {.libraries = true});
  scene.simulation().run(9s);
  const auto& said = software_report(scene.simulation().world().entity("one"))->said;
  ASSERT_GE(said.size(), 4U);
  EXPECT_EQ(said.front().text, "mode 0, plays nothing, heading 0.0, fallen 0");
  EXPECT_TRUE(said[1].text.starts_with("mode 1, plays nothing")) << "turns";
  EXPECT_EQ(said[said.size() - 2].text, "mode 2, plays kick_right, heading 0.3, fallen 0");
  EXPECT_EQ(said.back().text, "mode 0, plays nothing, heading 0.3, fallen 0");
}

}  // namespace
}  // namespace murosimf::control_software
