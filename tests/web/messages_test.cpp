#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "murosimf/math/quaternion.h"
#include "murosimf/web/drawings_message.h"
#include "murosimf/web/gzip.h"
#include "murosimf/web/html_recording.h"
#include "murosimf/web/outbox.h"
#include "murosimf/web/pose_message.h"

namespace murosimf::web {
namespace {

template <class Number>
Number number_at(const std::string& bytes, std::size_t at) {
  Number number{};
  std::memcpy(&number, bytes.data() + at, sizeof number);  // tests run on machines of this order
  return number;
}

PoseFrame frame_of(const std::vector<Vec3d>& positions) {
  PoseFrame frame;
  frame.time = std::chrono::milliseconds(1250);
  frame.first = {0, positions.size()};
  frame.position = positions;
  frame.orientation.assign(positions.size(), to_matrix(normalized(Quaterniond{-0.5, 0.5, 0.1, 0.7})));
  frame.joint_position.assign(positions.size(), 0);
  frame.frozen = {false};
  frame.present = {true};
  return frame;
}

const SceneDocument document{.bytes = {}, .moving = {{.index = 0, .objects = {0, 1}}}, .entities = 1};

// An L whose concave corner is the third: no triangle may have the corners around it alone.
TEST(DrawingsMessage, HasTrianglesOfPolygons) {
  const DrawnShape polygon{.kind = DrawnShape::polygon,
                           .points = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}};
  const DrawnShape dots{.kind = DrawnShape::dots, .points = {{0, 0, 0}}};
  const drawing::Drawn drawn{.entity = -1, .by = "somebody", .groups = {{.name = "area", .shapes = {polygon, dots}}}};
  const auto shapes = nlohmann::json::parse(drawings_message({drawn}))["drawings"][0]["groups"][0]["shapes"];
  double area = 0;
  for (const auto& triangle : shapes[0]["triangles"]) {
    const Vec3d &a = polygon.points[triangle[0]], &b = polygon.points[triangle[1]], &c = polygon.points[triangle[2]];
    area += 0.5 * norm(cross(b - a, c - a));
  }
  EXPECT_EQ(shapes[0]["triangles"].size(), 4U);
  EXPECT_NEAR(area, 3, 1e-12);
  EXPECT_FALSE(shapes[1].contains("triangles"));
}

TEST(PoseMessage, SaysWhereEverythingIs) {
  const Vec3d base{1.5, -2.25, 0.3}, link{1.6, -2.5, 0.1};
  const std::string bytes = pose_message(document, frame_of({base, link}), 3, false);
  ASSERT_EQ(bytes.size(), 16U + 20U + 2U * 14U);
  EXPECT_EQ(number_at<std::uint8_t>(bytes, 0), 1);
  EXPECT_EQ(number_at<std::uint32_t>(bytes, 4), 3U);
  EXPECT_EQ(number_at<double>(bytes, 8), 1.25);
  EXPECT_EQ(number_at<std::uint16_t>(bytes, 16), 1);
  EXPECT_FLOAT_EQ(number_at<float>(bytes, 24), -2.25F);
  const double step = number_at<float>(bytes, 32);
  EXPECT_NEAR(base.x + step * number_at<std::int16_t>(bytes, 50), link.x, step);
  EXPECT_NEAR(base.y + step * number_at<std::int16_t>(bytes, 52), link.y, step);
  EXPECT_NEAR(base.z + step * number_at<std::int16_t>(bytes, 54), link.z, step);
  EXPECT_NEAR(number_at<std::int16_t>(bytes, 62) / 32767.0, 0.5, 1e-4) << "w of a quaternion is never negative";
  EXPECT_NEAR(number_at<std::int16_t>(bytes, 56) / 32767.0, -0.5, 1e-4);
}

TEST(PoseMessage, StepsGrowWithWhatTheyMustReach) {
  const std::string near = pose_message(document, frame_of({{}, {3.9, 0, 0}}), 0, false);
  const std::string far = pose_message(document, frame_of({{}, {0, 0, -70}}), 0, false);
  EXPECT_EQ(number_at<float>(near, 32), 0x1p-13F);
  EXPECT_NEAR(number_at<float>(far, 32) * number_at<std::int16_t>(far, 54), -70.0, 0.003);
}

TEST(PoseMessage, NumbersThatWentBadHarmNobody) {
  const double bad = std::nan("");
  const std::string bytes = pose_message(document, frame_of({{0, 0, 0}, {bad, 1, INFINITY}}), 0, false);
  EXPECT_EQ(number_at<std::int16_t>(bytes, 50), 0);
  EXPECT_EQ(number_at<std::int16_t>(bytes, 54), 0);
}

TEST(PoseMessage, ContactsAreAddedForWhoWantsThem) {
  PoseFrame frame = frame_of({{}, {}});
  frame.contacts = {{.point = {1, 2, 0}, .force = {0, 0, 30}}};
  const std::string bytes = pose_message(document, frame, 0, true);
  ASSERT_EQ(bytes.size(), 16U + 20U + 2U * 14U + 4U + 24U);
  EXPECT_EQ(number_at<std::uint32_t>(bytes, 64), 1U);
  EXPECT_EQ(number_at<float>(bytes, 88), 30.0F);
}

TEST(HtmlRecording, PlanesHoldTheFrames) {
  const std::vector<std::string> frames{{"\x01\x02\xff\xff", 4}, {"\x05\x01\x00\x00", 4}, {"\x04\x01\x10\x20", 4}};
  const std::string planes = as_planes(frames);
  ASSERT_EQ(planes.size(), 12U);
  for (std::size_t word = 0; word < 2; ++word) {
    unsigned value = 0;
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(planes[at]); };
      value = (value + byte(6 * word + i) + 256U * byte(6 * word + 3 + i)) & 0xffff;
      EXPECT_EQ(value, number_at<std::uint16_t>(frames[i], 2 * word)) << word << ' ' << i;
    }
  }
}

TEST(Base64, AsTheStandardHasIt) {  // RFC 4648, 10
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe"), "//4=");
}

TEST(Gzip, GivesBackWhatItGot) {
  std::string text;
  for (int i = 0; i < 100'000; ++i) text += static_cast<char>(std::int64_t{i} * i % 251);
  for (const std::string& one : {std::string{}, std::string{"a"}, text}) EXPECT_EQ(gunzip(gzip(one)), one);
  EXPECT_LT(gzip(text).size(), text.size() / 2);
}

TEST(Gzip, RefusesDamagedBytes) {
  const std::string good = gzip("what will be damaged");
  EXPECT_THROW((void)gunzip(good.substr(0, good.size() / 2)), SetupError);
  EXPECT_THROW((void)gunzip("no gzip at all"), SetupError);
  EXPECT_THROW((void)gunzip(""), SetupError);
}

TEST(Outbox, AnswersAreKeptAndOldViewsAreNot) {
  Outbox outbox;
  outbox.show(1, text_message("old"));
  outbox.send(text_message("first"));
  outbox.show(1, text_message("new"));
  outbox.send(text_message("second"));
  outbox.show(2, text_message("other"));
  EXPECT_EQ(outbox.replaced(), 1U);
  EXPECT_EQ(outbox.waiting_bytes(), 11U);
  std::string all;
  while (const auto message = outbox.take()) all += *message->bytes + " ";
  EXPECT_EQ(all, "first second new other ");
  EXPECT_TRUE(outbox.empty());
  EXPECT_EQ(outbox.waiting_bytes(), 0U);
}

TEST(Outbox, ViewsTakeTurns) {
  Outbox outbox;
  std::string all;
  for (int i = 0; i < 4; ++i) {  // one that comes all the time leaves room for others
    outbox.show(1, text_message("a"));
    if (i == 0) outbox.show(2, text_message("b"));
    all += *outbox.take()->bytes;
  }
  EXPECT_EQ(all, "abaa");
}

TEST(SceneDocument, HasWhatIsSeen) {
  const scene::Scene scene("three_on_three");
  const_cast<scene::Scene&>(scene).simulation().initialize();
  const SceneDocument made = scene_document(scene);
  const auto length = number_at<std::uint32_t>(made.bytes, 0);
  ASSERT_EQ(length % 4, 0U);
  const auto text = nlohmann::json::parse(made.bytes.substr(4, length));
  EXPECT_EQ(text["name"], "Three on three");
  EXPECT_EQ(text["entities"].size(), made.entities);
  std::size_t robots = 0;
  for (const auto& entity : text["entities"]) robots += entity["kind"] == "robot" ? 1 : 0;
  EXPECT_EQ(robots, 6U);
  EXPECT_EQ(made.moving.size(), 7U) << "and the ball";
  EXPECT_FALSE(text["ground"]["lines"].empty());
  std::size_t end = 4 + length;
  for (const auto& mesh : text["meshes"]) {
    end = 4 + length + mesh["at"].get<std::size_t>() +
          12 * (mesh["corners"].get<std::size_t>() + mesh["triangles"].get<std::size_t>());
  }
  const auto& look = text["look"];
  for (const char* name : {"walls", "ceiling", "nets"}) {
    EXPECT_EQ(4 + length + look[name]["at"].get<std::size_t>(), end) << name;
    end += 20 * look[name]["corners"].get<std::size_t>() + 12 * look[name]["triangles"].get<std::size_t>();
  }
  EXPECT_EQ(4 + length + look["pile"]["at"].get<std::size_t>(), end);
  end += look["pile"]["side"].get<std::size_t>() * look["pile"]["side"].get<std::size_t>();
  EXPECT_EQ(end, made.bytes.size());
  for (const auto& part : text["parts"]) {
    const auto& entity = text["entities"][part["entity"].get<std::size_t>()];
    const std::size_t bodies = entity.contains("bodies") ? entity["bodies"].size() : 1;
    EXPECT_LT(part.value("body", std::size_t{0}), bodies);
  }
}

}  // namespace
}  // namespace murosimf::web
