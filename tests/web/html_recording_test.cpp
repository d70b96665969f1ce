// An HTML file has what control software draws, from the frame on at which it was drawn.
#include "murosimf/web/html_recording.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "murosimf/web/gzip.h"
#include "murosimf/web/page.h"
#include "murosimf/world/drawing.h"
#include "tests/temp_folder.h"

namespace murosimf {
namespace {

using nlohmann::json;
using namespace std::chrono_literals;

std::string from_base64(std::string_view text) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0, count = 0;
  for (const char letter : text.substr(0, text.find('='))) {
    bits = bits << 6 | static_cast<unsigned>(letters.find(letter));
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 0xff);
  }
  return bytes;
}

/// The recording in a page.
std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string page{std::istreambuf_iterator<char>(in), {}};
  const std::size_t begin = page.find('>', page.find("id=\"recording\"")) + 1;
  return web::gunzip(from_base64(std::string_view(page).substr(begin, page.find('<', begin) - begin)));
}

std::size_t size_of_text(const std::string& bytes) {
  std::size_t size = 0;
  for (std::size_t i = 0; i < 4; ++i) size |= static_cast<std::size_t>(static_cast<unsigned char>(bytes[i])) << 8 * i;
  return size;
}

/// Its JSON text.
json text_of(const std::filesystem::path& file) {
  const std::string bytes = bytes_of(file);
  return json::parse(bytes.substr(4, size_of_text(bytes)));
}

TEST(HtmlRecording, HasWhatControlSoftwareDraws) {
  if (web::compressed_page().empty()) GTEST_SKIP() << "this build has no page";
  scene::Scene scene("walk", {.cameras = false});
  World& world = scene.simulation().world();
  Drawings& all = world.entity("walker").column(properties::drawings).values[0];
  web::HtmlRecording recording(scene, {.file = fixtures::temp_folder() / "drawn.html"});
  const auto at = [&](Duration time, std::vector<DrawnGroup> groups) {
    scene.simulation().at(time, [&all, groups] {
      all.groups = groups;
      ++all.changes;
    });
  };
  const std::vector<DrawnShape> shapes{{.kind = DrawnShape::sphere, .points = {{1, 0.5, 0}}, .size = 0.25}};
  at(190ms, {{.name = "aim", .of_robot = true, .shapes = shapes}});
  at(390ms, {});
  scene.simulation().run(600ms);
  recording.finish();
  const json drawings = text_of(fixtures::temp_folder() / "drawn.html")["drawings"];
  ASSERT_EQ(drawings["tracks"].size(), 1U);
  const json& track = drawings["tracks"][0];
  EXPECT_EQ(track["by"], "walker");
  EXPECT_EQ(track["entity"], world.index_of(&world.entity("walker")));
  EXPECT_EQ(track["of_robot"], true);
  EXPECT_EQ(track["frames"], json::parse("[5, 5]")) << "40 ms each";
  EXPECT_EQ(track["points"], json::parse("[[1000, 500, 0], []]"));
  EXPECT_EQ(drawings["looks"][0][0], "sphere");
  EXPECT_EQ(drawings["looks"][0][1], 0.25);
}

// Law: all frames are of one size and have the rows of all who ever came; before it came, one is not present.
TEST(HtmlRecording, ShowsWhoComesFromThenOn) {
  if (web::compressed_page().empty()) GTEST_SKIP() << "this build has no page";
  const auto file = fixtures::temp_folder() / "newcomers.html";
  scene::Scene scene("walk", {.cameras = false});
  web::HtmlRecording recording(scene, {.file = file});
  scene.simulation().run(200ms);
  scene_file::BodySpec ball{.name = "marble", .where = "test", .shape = Sphere{0.1}};
  ball.mass = 0.1;
  ball.position = {1, 1, 0.5};
  (void)scene.add(ball);
  scene.simulation().run(200ms);
  (void)scene.add(scene_file::RobotSpec{
      .name = "guest", .model = "kid21", .where = "test", .level = "kinematic_walking", .position = {1, -1, 0}});
  scene.simulation().run(200ms);
  recording.finish();
  const std::string bytes = bytes_of(file);
  const json text = text_of(file);
  const std::size_t frames = text["frames"], words = text["words"], before = 4 + size_of_text(bytes);
  ASSERT_EQ(frames, 16U) << "40 ms each, and the last instant";
  ASSERT_EQ(bytes.size() - before - text["scene_bytes"].get<std::size_t>(), 2 * words * frames);
  const std::string planes = bytes.substr(before + text["scene_bytes"].get<std::size_t>());
  const auto word_of = [&](std::size_t frame, std::size_t word) {
    unsigned value = 0;
    for (std::size_t i = 0; i <= frame; ++i) {
      const auto byte = [&](std::size_t at) { return static_cast<unsigned>(static_cast<unsigned char>(planes[at])); };
      value = (value + byte(2 * word * frames + i) + 256U * byte(2 * word * frames + frames + i)) & 0xffffU;
    }
    return value;
  };
  const std::size_t entities = word_of(0, 1);
  for (std::size_t frame = 0; frame < frames; ++frame) {
    ASSERT_EQ(word_of(frame, 1), entities) << frame;
    std::vector<bool> present;
    for (std::size_t i = 0, word = 8; i < entities; ++i) {  // behind flags, numbers and the time
      present.push_back((word_of(frame, word) & 1U) != 0);
      word += 10 + 7 * word_of(frame, word + 1);
    }
    EXPECT_TRUE(present[0]);
    EXPECT_EQ(present[entities - 2], frame >= 5) << "200 ms: " << frame;
    EXPECT_EQ(present[entities - 1], frame >= 10) << "400 ms: " << frame;
  }
  EXPECT_EQ(text["entities"].size(), scene.simulation().world().entities().size());
}

TEST(HtmlRecording, SaysNothingOfDrawingsThatAreNotThere) {
  if (web::compressed_page().empty()) GTEST_SKIP() << "this build has no page";
  scene::Scene scene("walk", {.cameras = false});
  web::HtmlRecording recording(scene, {.file = fixtures::temp_folder() / "plain.html"});
  scene.simulation().run(100ms);
  recording.finish();
  EXPECT_FALSE(text_of(fixtures::temp_folder() / "plain.html").contains("drawings"));
}

}  // namespace
}  // namespace murosimf
