// An HTML file has what control software draws, from the frame on at which it was drawn.
#include "murosimf/web/html_recording.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

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

/// The JSON text of the recording in a page.
json text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string page{std::istreambuf_iterator<char>(in), {}};
  const std::size_t begin = page.find('>', page.find("id=\"recording\"")) + 1;
  const std::string bytes =
      web::gunzip(from_base64(std::string_view(page).substr(begin, page.find('<', begin) - begin)));
  std::size_t size = 0;
  for (std::size_t i = 0; i < 4; ++i) size |= static_cast<std::size_t>(static_cast<unsigned char>(bytes[i])) << 8 * i;
  return json::parse(bytes.substr(4, size));
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
