/// finding_groups_test - findings of one kind are one line, the worst first.
#include "murosimf/robot/finding_groups.h"

#include <gtest/gtest.h>

namespace murosimf::robot {
namespace {

Finding finding(Severity severity, const std::string& what) { return {severity, "r.xml:1", what, "mend it"}; }

TEST(FindingGroups, AreOfOneKindWhateverTheirNamesAndNumbers) {
  const auto groups =
      grouped({finding(Severity::warning, "'a' weighs 0.1 kg"), finding(Severity::warning, "'b' is odd"),
               finding(Severity::warning, "'c' weighs -2e-06 kg"), finding(Severity::note, "'d' weighs 3 kg")});
  ASSERT_EQ(groups.size(), 3u);
  EXPECT_EQ(to_line(groups[1]), "warning: r.xml:1: 'b' is odd; mend it");
}

TEST(FindingGroups, TellApostrophesFromQuotes) {
  const auto groups = grouped({finding(Severity::warning, "the robot's base 'a' is odd, its hips' axis 'it's' too"),
                               finding(Severity::warning, "the robot's arm 'b' is fine, its hips' axis 'c' too"),
                               finding(Severity::warning, "the robot's base 'd' is odd, its hips' axis 'e' too")});
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_EQ(groups[0].others, std::vector<std::string>{"'d' and 'e'"});
  EXPECT_EQ(grouped({finding(Severity::note, "'tis a"), finding(Severity::note, "'tis b")}).size(), 2u);
}

TEST(FindingGroups, NameTheOthersInALine) {
  std::vector<Finding> findings;
  for (const char* name : {"a", "b", "c", "b", "d", "e"}) {
    findings.push_back(finding(Severity::warning, std::string("'") + name + "' weighs 1 kg"));
  }
  ASSERT_EQ(grouped(findings).size(), 1u);
  EXPECT_EQ(to_line(grouped(findings)[0]),
            "warning: r.xml:1: 'a' weighs 1 kg (and 5 more: 'b', 'c', 'd', ...); mend it");
}

TEST(FindingGroups, JoinWhatIsNotUsed) {
  const auto groups = grouped({{Severity::note, "r.xml:1", "attribute 'a' of geom is not used", ""},
                               {Severity::note, "r.xml:2", "element 'b' is not used", ""}});
  ASSERT_EQ(groups.size(), 1u);
  EXPECT_EQ(to_line(groups[0]), "note: r.xml:1: attribute 'a' of geom is not used (and 1 more: element 'b')");
}

TEST(FindingGroups, JoinGuessedNames) {
  const auto groups = grouped({{Severity::note, "", "guessed: imu is 'a'", ""},
                               {Severity::note, "", "guessed: the soles are under l, r", ""},
                               {Severity::note, "", "guessed: left_hand is 'b'", ""}});
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_EQ(to_line(groups[0]), "note: guessed: imu is 'a' (and 1 more: left_hand is 'b')");
}

TEST(FindingGroups, BeginWithTheWorst) {
  const auto groups = grouped({finding(Severity::note, "n"), finding(Severity::warning, "w"),
                               finding(Severity::error, "e"), finding(Severity::warning, "v")});
  ASSERT_EQ(groups.size(), 4u);
  EXPECT_EQ(groups[0].first.what, "e");
  EXPECT_EQ(groups[1].first.what, "w");
  EXPECT_EQ(groups[2].first.what, "v");
  EXPECT_EQ(groups[3].first.what, "n");
}

TEST(FindingGroups, AreAtMostSoManyLines) {
  std::vector<Finding> findings;
  for (const char* what : {"one", "two", "three", "four"}) findings.push_back({Severity::note, "", what, ""});
  EXPECT_EQ(grouped_text(findings, 4), "note: one\nnote: two\nnote: three\nnote: four\n");
  EXPECT_EQ(grouped_text(findings, 3), "note: one\nnote: two\nand 2 more kinds of notes; --all shows them\n");
}

TEST(FindingPaths, AreSaidFromTheFolder) {
  std::vector<Finding> findings{{Severity::note, "/a/b/c/r.xml:1", "no '/a/b/d.stl', nor /x/a/b/e.stl", ""}};
  shorten_paths(findings, "/a/b");
  EXPECT_EQ(findings[0].where, "c/r.xml:1");
  EXPECT_EQ(findings[0].what, "no 'd.stl', nor /x/a/b/e.stl");
  shorten_paths(findings, "/");
  EXPECT_EQ(findings[0].what, "no 'd.stl', nor /x/a/b/e.stl");
}

}  // namespace
}  // namespace murosimf::robot
