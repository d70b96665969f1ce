// Motions as BVH: angles, gaps, and what cannot become one. Places of links: tests/oracle/bvh_against_recording.py.
#include "murosimf/recording/bvh_export.h"

#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "murosimf/model/error.h"
#include "murosimf/recording/foxglove_messages.h"
#include "murosimf/recording/mcap/mcap_writer.h"
#include "murosimf/recording/mcap/protobuf.h"
#include "tests/temp_folder.h"

namespace murosimf {
namespace {

using namespace recording;
using namespace std::chrono_literals;

struct Link {
  std::string parent, child;
  Vec3d place{};
  Mat3d turn{};
};

/// Poses at times; joints that slide, by their names.
McapReader recorded(const std::vector<std::pair<Duration, std::vector<Link>>>& frames, const std::string& slides = "") {
  const std::filesystem::path file = fixtures::temp_folder() / "motion.mcap";
  McapWriter out(file, {.library = "test"});
  out.add({.name = "murosimf", .values = {{"record_rate_hz", "100"}}});
  const auto poses = out.add_channel("/tf", "protobuf", 0);
  if (!slides.empty()) (void)out.add_channel("/joints", "protobuf", 0, {{slides, "m"}});
  for (const auto& [time, links] : frames) {
    std::string bytes;
    ProtobufWriter message(bytes);
    for (const Link& link : links) {
      message.message(1, [&](ProtobufWriter& in) {
        in.text(2, link.parent);
        in.text(3, link.child);
        put_vector(in, 4, link.place);
        put_rotation(in, 5, link.turn, 0x1p-40);
      });
    }
    out.write(poses, time, bytes);
  }
  out.close();
  return McapReader(file);
}

std::vector<Link> arm(double x, double angle, double reach = 0.2) {
  return {{"world", "arm/base", {x, 0.02, 0.5}, {}},
          {"arm/base", "arm/elbow", {reach, 0, 0.01}, rotation_y(angle)},
          {"world", "ball/ball", {1, 0, 0}, {}}};
}

std::string refusal(const McapReader& file, const std::string& robot) {
  try {
    (void)bvh_of(file, robot);
  } catch (const SetupError& error) {
    return error.what();
  }
  return "none";
}

TEST(BvhExport, TurnsBackWhatItTellsApart) {
  const double quarter = std::numbers::pi / 2;
  for (const double a : {-2.9, -0.4, 0.0, 1.1, 3.1}) {
    for (const double b : {-quarter, -1.5707, -0.3, 0.0, 0.8, 1.5707963, quarter}) {
      for (const double c : {-3.0, -0.2, 0.0, 0.5, 2.7}) {
        const Mat3d R = rotation_z(a) * rotation_x(b) * rotation_y(c);
        const Vec3d angles = bvh_angles(R);
        const Mat3d again = rotation_z(angles.x) * rotation_x(angles.y) * rotation_y(angles.z);
        EXPECT_LT(norm(again.x - R.x) + norm(again.y - R.y) + norm(again.z - R.z), 1e-8) << a << ' ' << b << ' ' << c;
      }
    }
  }
  EXPECT_EQ(bvh_angles(rotation_z(0.5) * rotation_x(quarter)).x, 0) << "only the sum is known";
}

TEST(BvhExport, IsTheFileThatReadersExpect) {
  const McapReader file = recorded({{1000ms, arm(0, 0)}, {1010ms, arm(0.1, 0.5)}, {1050ms, arm(0.2, -0.5)}});
  EXPECT_EQ(bvh_of(file, ""), R"(HIERARCHY
ROOT base
{
  OFFSET 0.000000 0.000000 0.000000
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT elbow
  {
    OFFSET 0.000000 1.000000 20.000000
    CHANNELS 3 Zrotation Xrotation Yrotation
    End Site
    {
      OFFSET 0.000000 0.500000 10.000000
    }
  }
}
MOTION
Frames: 6
Frame Time: 0.010000000
2.00000 50.00000 0.00000 0.000000 0.000000 0.000000 0.000000 0.000000 0.000000
2.00000 50.00000 10.00000 0.000000 0.000000 0.000000 0.000000 28.647890 0.000000
2.00000 50.00000 10.00000 0.000000 0.000000 0.000000 0.000000 28.647890 0.000000
2.00000 50.00000 10.00000 0.000000 0.000000 0.000000 0.000000 28.647890 0.000000
2.00000 50.00000 10.00000 0.000000 0.000000 0.000000 0.000000 28.647890 0.000000
2.00000 50.00000 20.00000 0.000000 0.000000 0.000000 0.000000 -28.647890 0.000000
)") << "the gap holds the last pose";
  EXPECT_NE(bvh_of(file, "ball").find("ROOT ball"), std::string::npos);
}

TEST(BvhExport, SaysWhatCannotBecomeOne) {
  const McapReader file = recorded({{0ms, arm(0, 0)}, {10ms, arm(0, 0, 0.201)}});
  EXPECT_NE(bvh_of(file, "arm").find("OFFSET 0.000000 1.000000 20.050000"), std::string::npos) << "half a millimetre";
  EXPECT_NE(refusal(file, "arn").find("did you mean 'arm'"), std::string::npos);
  EXPECT_NE(refusal(recorded({{0ms, arm(0, 0)}}, "arm/elbow"), "").find("joint 'elbow' of 'arm' slides"),
            std::string::npos);
  EXPECT_NE(refusal(recorded({{0ms, arm(0, 0)}, {10ms, arm(0, 0, 0.203)}}), "").find("'elbow' of 'arm' slides"),
            std::string::npos);
  EXPECT_NE(refusal(recorded({{0ms, {}}}), "").find("no poses"), std::string::npos);
  std::vector<Link> two = arm(0, 0);
  two.push_back({"world", "leg/base"});
  two.push_back({"leg/base", "leg/knee"});
  EXPECT_NE(refusal(recorded({{0ms, two}}), "").find("there are arm, leg"), std::string::npos);
  EXPECT_NE(refusal(recorded({{0ms, arm(0, 0)}, {90000s, arm(0, 0)}}), "").find("lasts longer"), std::string::npos);
  EXPECT_NE(refusal(recorded({{0ms, {{"world", "arm/base"}}}, {10ms, arm(0, 0)}}), "").find("from the start"),
            std::string::npos);
}

}  // namespace
}  // namespace murosimf
