// Highlights of a recording as a user meets them: a table, a video, and what is wrong in one line.
#include <nlohmann/json.hpp>

#include "tests/apps/folder.h"
#include "tests/apps/program.h"

namespace murosimf::test {
namespace {

/// A robot that lies at the start and gets up.
std::string recording() {
  static const std::string file = [] {
    const std::string name = (fixtures::temp_folder() / "get_up.mcap").string();
    EXPECT_EQ(murosimf("run get_up --record " + name).exit_code, 0);
    return name;
  }();
  return file;
}

TEST(Highlights, AreATableAndJson) {
  const Result table = murosimf("highlights " + recording());
  EXPECT_EQ(table.exit_code, 0) << table.errors;
  EXPECT_NE(table.output.find("robot gets up"), std::string::npos) << table.output;
  const Result result = murosimf("highlights " + recording() + " --json -");
  const auto json = nlohmann::json::parse(result.output);
  ASSERT_EQ(json["moments"].size(), 1U);
  EXPECT_EQ(json["moments"][0]["kind"], "get_up");
  EXPECT_EQ(json["moments"][0]["robot"], "robot");
  ASSERT_EQ(json["clips"].size(), 1U);
  EXPECT_LE(json["clips"][0]["begin"].get<double>(), json["moments"][0]["time"].get<double>());
  EXPECT_NE(murosimf("highlights " + recording() + " --what goal").output.find("no moments"), std::string::npos);
}

TEST(Highlights, AreAVideo) {
  if (std::system("ffmpeg -version >/dev/null 2>&1") != 0) GTEST_SKIP() << "no ffmpeg here";
  const fs::path video = scratch("up.gif");
  const Result result = murosimf("highlights " + recording() + " --size 64x36 --fps 5 --video " + video.string());
  if (result.errors.find("no pictures by OpenGL") != std::string::npos) GTEST_SKIP() << result.errors;
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(read_file(video).substr(0, 4), "GIF8");
  const fs::path none = scratch("none.gif");
  const Result nothing = murosimf("highlights " + recording() + " --what goal,kick --video " + none.string());
  EXPECT_EQ(nothing.exit_code, 2);
  EXPECT_NE(nothing.errors.find("goal, kick; no video"), std::string::npos) << nothing.errors;
  EXPECT_NE(nothing.output.find("no moments"), std::string::npos) << nothing.output;
  EXPECT_FALSE(fs::exists(none));
}

TEST(Highlights, HaveWordsOverThem) {
  if (std::system("ffmpeg -version >/dev/null 2>&1") != 0) GTEST_SKIP() << "no ffmpeg here";
  const auto video = [](const std::string& options) {
    const fs::path file = scratch("over.gif");
    const Result result =
        murosimf("highlights " + recording() + " --size 64x36 --fps 2 --video " + file.string() + options);
    EXPECT_TRUE(result.exit_code == 0 || result.errors.find("no pictures by OpenGL") != std::string::npos)
        << result.errors;
    return result.exit_code == 0 ? read_file(file) : std::string();
  };
  const std::string without = video("");
  if (without.empty()) GTEST_SKIP() << "no pictures here";
  EXPECT_NE(video(" --overlay support"), without) << "contacts of a recording say who touches the ground";
}

TEST(Highlights, AreAPageOfTheClipsAlone) {
  const fs::path page = scratch("up.html"), all = scratch("all.html");
  const Result result = murosimf("highlights " + recording() + " --html " + page.string());
  if (result.errors.find("without its page") != std::string::npos) GTEST_SKIP() << result.errors;
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(murosimf("replay " + recording() + " --html " + all.string()).exit_code, 0);
  EXPECT_LT(read_file(page).size(), read_file(all).size());
  const Result nothing = murosimf("highlights " + recording() + " --what goal --html " + page.string());
  EXPECT_EQ(nothing.exit_code, 2);
  EXPECT_NE(nothing.errors.find("goal; no page"), std::string::npos) << nothing.errors;
  expect_mistake("highlights " + recording() + " --html " + recording(), {"--html"});
}

TEST(Highlights, SayWhatIsWrong) {
  expect_mistake("highlights " + recording() + " --overlay name", {"--overlay", "name", "names", "support"});
  expect_mistake("highlights " + recording() + " --overlay score", {"--overlay score", "two teams", "0"});
  expect_mistake("highlights missing.mcap", {"missing.mcap"});
  expect_mistake("highlights " + recording() + " --what goals", {"--what", "goals"});
  expect_mistake("highlights " + recording() + " --video film.txt", {"film.txt", ".mp4"});
  expect_mistake("highlights " + recording() + " --video " + recording(), {"its extension must say which kind"});
  expect_mistake("highlights " + recording() + " --size 3 --video a.gif", {"--size '3'"});
  expect_mistake("highlights " + recording() + " --light noon --video a.gif", {"--light", "noon"});
  expect_mistake("highlights " + recording() + " --fps 0 --video a.gif", {"--fps"});
}

}  // namespace
}  // namespace murosimf::test
