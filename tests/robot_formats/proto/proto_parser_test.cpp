/// proto_parser_test - syntax: fields, defaults, IS, DEF and USE, PROTOs inside, and errors with their lines.
#include "tests/robot_formats/proto/proto_files.h"

namespace murosimf::robot_formats::proto {
namespace {

using namespace proto_files;

TEST(ProtoSyntax, TakesCommasAndCommentsAsSpaces) {
  const auto description = read(block("Box { size 1,2 3 } # one # two", "mass 2 centerOfMass [ 0.1, -.2 +3e-1 ]"));
  expect_near(description.bodies.at(0).solid.center, {0.1, -0.2, 0.3});
  EXPECT_EQ(description.bodies[0].solid.mass, 2);
  EXPECT_EQ(description.name, "B");
}

TEST(ProtoSyntax, BindsFieldsToTheirDefaults) {
  const auto description = read(
      "PROTO P [ field SFFloat m 3 # kilograms\n vrmlField SFVec3f{1 2 3, 4 5 6} c 4 5 6\n unconnectedField MFNode "
      "slot [] "
      "field SFNode box Box { size 1 1 1 } ]\n"
      "{ Solid { boundingObject IS box children IS slot physics Physics { mass IS m centerOfMass IS c } } }");
  EXPECT_EQ(description.bodies.at(0).solid.mass, 3);
  expect_near(description.bodies[0].solid.center, {4, 5, 6});
  EXPECT_EQ(description.bodies[0].shapes.size(), 1u);
}

TEST(ProtoSyntax, UsesWhatIsDefined) {
  const auto description =
      read(robot("Solid { name \"a\" boundingObject DEF BOX Box { size 2 4 6 } }\n"
                 "Solid { name \"b\" boundingObject USE BOX }"));
  const auto& shapes = description.bodies.at(2).shapes;
  ASSERT_EQ(shapes.size(), 1u);
  expect_near(std::get<Box>(shapes[0].placed.shape).half_size, {1, 2, 3});
}

TEST(ProtoSyntax, WritesOutPrototypesOfOtherFiles) {
  write("parts/Arm.proto",
        "PROTO Arm [ field SFFloat mass 1 field SFString name \"arm\" field SFVec3f at 1 2 3 ]\n"
        "{ Solid { translation IS at name IS name physics Physics { mass IS mass inertiaMatrix [ 1 1 1, 0 0 0 ] } } }");
  const auto description = read("EXTERNPROTO \"parts/Arm.proto\"\n" + robot("Arm { mass 7 name \"left\" }\nArm { }"));
  ASSERT_EQ(description.bodies.size(), 3u);
  EXPECT_EQ(description.bodies[1].name, "left");
  EXPECT_EQ(description.bodies[1].solid.mass, 7);
  EXPECT_EQ(description.bodies[2].name, "arm");
  EXPECT_EQ(description.bodies[2].solid.mass, 1);
  expect_near(description.bodies[2].place.position, {1, 2, 3});
  EXPECT_TRUE(contains(message("EXTERNPROTO \"parts/Arm.proto\"\n" + robot("Arm { mas 7 }")),
                       "robot.proto:6: unknown field of Arm 'mas'; did you mean 'mass'?"));
}

TEST(ProtoSyntax, FindsPrototypesInFoldersBeside) {
  write("meshes/Cap.proto", "PROTO Cap [ ] { Solid { name \"cap\" children [ Knob { } ] } }");
  write("Knob.proto", "PROTO Knob [ ] { Solid { name \"knob\" } }");
  EXPECT_EQ(read(robot("Cap { } Cap { }")).bodies.size(), 5u);
}

TEST(ProtoSyntax, LeavesOutUnreadablePrototypesIfLenient) {
  write("Jersey.proto", "PROTO Jersey [ ] { %< let x = 1; >% Solid { } }");
  EXPECT_TRUE(contains(message(robot("Jersey { }")), "Jersey.proto:1: this PROTO is a template"));
  const auto description = read(robot("Jersey { }"), {.lenient = true});
  EXPECT_EQ(description.bodies.size(), 1u);
  EXPECT_TRUE(any_contains(description.notes, "robot.proto:5: Jersey is left out: "));
}

TEST(ProtoSyntax, RefusesPrototypesInsideThemselves) {
  write("Loop.proto", "PROTO Loop [ ] { Group { children [ Loop { } ] } }");
  EXPECT_TRUE(contains(message(robot("Loop { }")), "PROTO Loop is inside itself"));
}

TEST(ProtoSyntax, RefusesTemplates) {
  const std::string in_body = "PROTO P [ ] {\n %< let x = 1; >%\n Robot { } }";
  EXPECT_TRUE(contains(message(in_body), "robot.proto:2: this PROTO is a template with scripts"));
  EXPECT_TRUE(contains(message("PROTO P [ ] {\nRobot { children [ %{ if x }% ] } }"),
                       "robot.proto:2: this PROTO is a template"));
  EXPECT_TRUE(
      contains(message("PROTO P [ ] {\nRobot { name \"%<= x >%\" } }"), "robot.proto:2: this PROTO is a template"));
  EXPECT_EQ(read("# %< a comment\nPROTO P [ ] { Robot { } }").bodies.size(), 1u);
}

TEST(ProtoSyntax, SaysInWhichLineItIsWrong) {
  struct Case {
    std::string text, message;
  };
  const std::vector<Case> cases{
      {"PROTO P [ ]\n{ Solid { mass 1.2.3 } }", "robot.proto:2: '1.2.3' is no number"},
      {"PROTO P [ ]\n{ Solid { name \"a } }", "robot.proto:2: a string without end"},
      {"PROTO P [ ]\n{ Solid {\n", "robot.proto:3: '}' is missing"},
      {"PROTO P [ ]\n{ Solid { name name } }", "robot.proto:2: '{' is missing before '}'"},
      {"PROTO P [\nfld SFFloat x 1 ] { Solid { } }", "robot.proto:2: 'fld' is no declaration"},
      {"PROTO P [ field SFFloat mass 1 ]\n{ Solid { translation IS mas } }",
       "robot.proto:2: unknown field after IS 'mas'; did you mean 'mass'?"},
      {"PROTO P [ ]\n{ Solid { children [ USE leg ] } }", "robot.proto:2: unknown name after USE 'leg'"},
      {"PROTO P [ ]\n{ Solid { name \"a\"\nname \"b\" } }", "robot.proto:3: name is written twice in Solid"},
      {"# nothing\n", "robot.proto:2: there is no PROTO and no node in the file"},
      {"PROTO P [ ] { Box { } }", "robot.proto:1: the PROTO is a Box, not a Robot or Solid"},
      {"PROTO P [ ] { Foo { } }", "robot.proto:1: the PROTO is a Foo, and there is no file Foo.proto beside"},
      {"Robot { }\nRobot { }", "robot.proto:2: a second Robot in this world"},
  };
  for (const auto& [text, expected] : cases) {
    const std::string said = message(text);
    EXPECT_TRUE(contains(said, expected)) << said;
  }
  EXPECT_TRUE(contains(message(robot("Solid {\ntranslation 1 2 }")),
                       "robot.proto:6: translation of Solid has 2 numbers; write 3"));
}

TEST(ProtoSyntax, TakesNamesThatBeginWithDigits) {
  EXPECT_EQ(read(robot("DEF 3d_part Solid { } USE 3d_part")).bodies.size(), 3u);
  EXPECT_TRUE(contains(message(robot("Solid { translation 1 2.2.2 3 }")), "robot.proto:5: '2.2.2' is no number"));
}

TEST(ProtoSyntax, RefusesDepthsAndMultitudes) {
  std::string deep;
  for (int i = 0; i < 1000; ++i) deep += "Group { children [ ";
  EXPECT_TRUE(contains(message(robot(deep)), "nodes inside each other"));
  std::string wide = "DEF A0 Group { children [ Shape { } Shape { } ] }\n";
  for (int i = 1; i < 40; ++i) {
    const std::string last = "USE A" + std::to_string(i - 1) + " ";
    wide += "DEF A" + std::to_string(i) + " Group { children [ " + last + last + "] }\n";
  }
  EXPECT_TRUE(contains(message(robot(wide)), "more than 100000 nodes"));
  std::string bounding = "Group { children [ DEF A0 Group { children [ Box { } Box { } ] }\n";
  for (int i = 1; i < 40; ++i) {
    const std::string last = "USE A" + std::to_string(i - 1) + " ";
    bounding += "DEF A" + std::to_string(i) + " Group { children [ " + last + last + "] }\n";
  }
  EXPECT_TRUE(contains(message(block(bounding + "] }", "mass 1")), "more than 100000 nodes"));
}

TEST(ProtoWorld, HasOneRobot) {
  const auto description =
      read_proto(write("w.wbt", "#VRML_SIM R2023b utf8\nWorldInfo { }\nRobot { name \"r\" children [ ] }"));
  EXPECT_EQ(description.bodies.at(0).name, "r");
  EXPECT_TRUE(description.fixed_base);
}

}  // namespace
}  // namespace murosimf::robot_formats::proto
