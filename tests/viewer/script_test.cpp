#include "murosimf/viewer/script.h"

#include <gtest/gtest.h>

#include "murosimf/model/error.h"

namespace murosimf::viewer {
namespace {

std::string mistake_in(const std::string& text) {
  try {
    (void)parse_script(text, "session");
  } catch (const SetupError& error) {
    return error.what();
  }
  return {};
}

TEST(Script, ReadsEveryWord) {
  const auto steps = parse_script(
      "# a session\n\nwait 0.5\nuntil 2  # simulated\nsettle\nkey Ctrl+P\nclick blue1\nclick 10 20.5\ndouble "
      "blue1.head\n"
      "press blue1 level\ndrag ball 1 -0.5\npush blue1.torso 0 0.3 0\ntype 0.25\nscrub 1.5\nlook 30 17 4\nscreenshot "
      "a.png\nsay so\n",
      "session");
  ASSERT_EQ(steps.size(), 15U);
  EXPECT_EQ(steps[1].numbers, std::vector<double>{2});
  EXPECT_EQ(steps[1].where, "session:4");
  EXPECT_EQ(steps[4].text, "blue1");
  EXPECT_EQ(steps[5].numbers, (std::vector<double>{10, 20.5}));
  EXPECT_EQ(steps[7].text, "blue1 level");
  EXPECT_EQ(steps[8].numbers, (std::vector<double>{1, -0.5}));
  EXPECT_EQ(steps[13].text, "a.png");
}

TEST(Script, SaysWhereAMistakeIs) {
  EXPECT_EQ(mistake_in("wait 1\nwiat 2\n").find("session:2: unknown word 'wiat'; did you mean 'wait'"), 0U);
  EXPECT_NE(mistake_in("wait\n").find("wait SECONDS"), std::string::npos);
  EXPECT_NE(mistake_in("wait -1\n").find("from 0"), std::string::npos);
  EXPECT_NE(mistake_in("wait nan\n"), "");
  EXPECT_NE(mistake_in("drag ball 1\n").find("drag NAME X Y"), std::string::npos);
  EXPECT_NE(mistake_in("click 10\n"), "");
  EXPECT_NE(mistake_in("key Hyper+P\n").find("Hyper"), std::string::npos);
  EXPECT_NE(mistake_in("screenshot\n").find("screenshot FILE.png"), std::string::npos);
  EXPECT_NE(mistake_in("look 1 2 three\n").find("'three' is no number"), std::string::npos);
}

}  // namespace
}  // namespace murosimf::viewer
