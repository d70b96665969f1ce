// Pictures and videos as a user meets them.
#include <cstdint>
#include <set>

#include <nlohmann/json.hpp>

#include "tests/apps/folder.h"
#include "tests/apps/program.h"
#include "tests/environment_variable.h"

namespace murosimf::test {
namespace {

constexpr const char* scene_text =
    "[ball]\nposition = [0.6, 0.1]\n[views.corner]\neye = [2, 1.5, 1]\nlook_at = [0, 0, 0]\n"
    "[[robots]]\nname = 'one'\nmodel = 'kid21'\ncommand = [0.2, 0, 0]\n"
    "[robots.sensors.camera]\nwidth = 64\nheight = 48\ndepth = true\n";

bool has_ffmpeg() { return std::system("ffmpeg -version >/dev/null 2>&1") == 0; }

std::uint32_t big_endian(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<std::uint8_t>(bytes.at(at + i));
  return value;
}

std::string size_of_png(const std::string& bytes) {
  if (bytes.size() < 24 || bytes.substr(1, 3) != "PNG") return "no PNG";
  return std::to_string(big_endian(bytes, 16)) + "x" + std::to_string(big_endian(bytes, 20));
}

/// The number of pictures is in the box that says how long each of them is.
std::uint32_t pictures_in_mp4(const std::string& bytes) {
  const auto box = bytes.find("stsz");
  return box == std::string::npos ? 0 : big_endian(bytes, box + 12);
}

/// Each picture of a GIF has a graphic control extension.
int pictures_in_gif(const std::string& bytes) {
  const std::string mark("\x21\xf9\x04", 3);
  int count = 0;
  for (auto at = bytes.find(mark); at != std::string::npos; at = bytes.find(mark, at + 1)) ++count;
  return count;
}

class Drawing : public InFolder {
 protected:
  void SetUp() override { scene_ = write("scene.toml", scene_text); }

  [[nodiscard]] std::string command(const std::string& options) const {
    return "render " + scene_.string() + " " + options;
  }
  [[nodiscard]] std::string out(const std::string& name = "a.png") const { return " --out " + file(name); }
  [[nodiscard]] std::string video(const std::string& name) const { return " --video " + file(name); }
  /// Bytes of a picture or video that is drawn without a word, and is alone in its folder, or with the table of its labels (its layer is
  /// the last option).
  [[nodiscard]] std::string draw(const std::string& options, const std::string& name = "a.png") const {
    const Result result = murosimf(command(options) + (name.ends_with(".png") ? out(name) : video(name)));
    EXPECT_EQ(result.exit_code, 0) << options;
    EXPECT_EQ(result.output + result.errors, "") << options;
    std::vector<std::string> written{name};
    const std::string table = fs::path(name).stem().string() + ".labels.json";
    if (options.ends_with("--layer labels")) written.insert(written.begin(), table);
    EXPECT_EQ(files(), written);
    const std::string bytes = read_file(file(name));
    if (written.size() > 1) table_ = read_file(file(table));
    for (const std::string& one : written) fs::remove(file(one));
    return bytes;
  }
  void expect_refused(const std::string& options, const std::vector<std::string>& parts) const {
    expect_mistake(command(options), parts);
    EXPECT_EQ(files(), std::vector<std::string>()) << options;
  }

  fs::path scene_;
  mutable std::string table_;  // of labels, of the last such picture
};

class Render : public Drawing {
 protected:
  void SetUp() override {
    Drawing::SetUp();
    static const std::string trouble = murosimf(command("--size 8x8 --out " + scratch("probe.png").string())).errors;
    if (!trouble.empty()) GTEST_SKIP() << trouble;
  }
};

TEST_F(Render, EveryViewIsAPictureOfItsOwn) {
  std::set<std::string> pictures;
  for (const char* view : {"overview", "top", "side", "left", "right", "corner", "one", "ball"}) {
    const std::string picture = draw(std::string("--size 120x70 --view ") + view);
    EXPECT_EQ(size_of_png(picture), "120x70") << view;
    EXPECT_TRUE(pictures.insert(picture).second) << view << " is the same as another";
  }
  EXPECT_TRUE(pictures.contains(draw("--size 120x70"))) << "the overview is the usual one";
  EXPECT_EQ(size_of_png(draw("")), "1280x720");
}

TEST_F(Render, ThroughACameraIsOfTheCamerasSize) {
  const std::string picture = draw("--camera one.camera");
  EXPECT_EQ(size_of_png(picture), "64x48");
  EXPECT_EQ(size_of_png(draw("--camera one.camera --set one.sensors.camera.width=33")), "33x48");
  EXPECT_NE(draw("--camera one.camera --time 2"), picture) << "it walks";
  EXPECT_NE(draw("--camera one.camera --set one.sensors.camera.blur=2"), picture);
  EXPECT_EQ(size_of_png(draw("--camera one.camera --set one.sensors.camera.mosaic=rggb")), "64x48");
}

TEST_F(Render, LayersLightsAndShadowsAreOtherPictures) {
  std::set<std::string> pictures;
  for (const char* options :
       {"--layer color", "--layer depth", "--layer labels", "--layer depth_shown", "--layer labels_shown",
        "--light day", "--light night", "--no-shadows", "--time 1", "--camera one.camera",
        "--camera one.camera --light night", "--camera one.camera --layer depth"}) {
    const bool camera = std::string(options).find("camera") != std::string::npos;
    EXPECT_TRUE(pictures.insert(draw((camera ? "" : "--size 120x70 ") + std::string(options))).second) << options;
  }
  EXPECT_TRUE(pictures.contains(draw("--light hall --size 120x70"))) << "the scene's light";
}

// It draws a polygon in front of the robot when it has seen a picture.
TEST_F(Render, DrawingsOfSoftwareAreOverThePicture) {
  const fs::path scene =
      write("drawing.toml", "[[robots]]\nname = 'one'\nmodel = 'kid21'\ncontroller = 'library'\nlibrary = '" +
                                std::string(MUROSIMF_CONTROLLERS) +
                                "/controller_pictures.so'\noptions = {picture = 'camera.color'}\n" +
                                "[robots.sensors.camera]\nwidth = 40\nheight = 30\n");
  const auto picture = [&](const std::string& options) {
    const fs::path file = scratch("drawing.png");
    const Result result =
        murosimf("render " + scene.string() + " --libraries --time 0.2 --view side --size 160x90 --out " +
                 file.string() + " " + options);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return read_file(file);
  };
  const std::string without = picture("");
  EXPECT_NE(picture("--drawings"), without);
  EXPECT_EQ(picture("--drawings one/picture"), picture("--drawings all"));
  EXPECT_EQ(picture("--drawings one/other"), without);
  EXPECT_EQ(picture("--drawings one/other,one/picture"), picture("--drawings"));
  expect_mistake("render " + scene.string() + " --libraries --layer depth --drawings --out x.png",
                 {"--drawings", "colors"});
}

TEST_F(Render, WordsAndMarksAreOverThePicture) {
  std::set<std::string> pictures{draw("--size 120x70 --time 0.2 --view side")};
  for (const char* words : {"time", "names,levels", "forces", "support", "all"}) {
    const std::string set = " --set one.level=simplified_dynamics";
    EXPECT_TRUE(pictures.insert(draw("--size 120x70 --time 0.2 --view side --overlay " + (words + set))).second)
        << words;
  }
  EXPECT_TRUE(
      pictures.contains(draw("--size 120x70 --time 0.2 --view side --set one.level=simplified_dynamics --overlay")))
      << "alone it is all";
  expect_refused("--overlay names,tim" + out(), {"--overlay", "tim", "time,score,names,levels,forces,support"});
  expect_refused("--overlay score" + out(), {"--overlay score", "two teams"});
  expect_refused("--overlay time --layer depth" + out(), {"--overlay", "colors"});
  expect_refused("--overlay time --camera one.camera" + out(), {"--overlay", "--camera"});
}

TEST_F(Render, WhatARobotSeesIsInACorner) {
  const std::string options = "--size 120x70 --time 0.3 --view side", without = draw(options);
  const std::string inset = draw(options + " --inset one.camera");
  EXPECT_NE(inset, without);
  EXPECT_EQ(size_of_png(inset), "120x70");
  expect_refused("--inset one.camra" + out(), {"--inset 'one.camra'", "did you mean 'camera'?"});
  expect_refused("--inset one" + out(), {"--inset 'one'", "write ROBOT.CAMERA, like one.camera"});
  expect_refused("--inset one.camera --layer depth" + out(), {"--inset", "colors"});
  expect_refused("--inset one.camera --camera one.camera" + out(), {"--inset", "--camera"});
  expect_refused("--inset one.camera --set one.sensors.camera.color=false" + out(),
                 {"--inset one.camera", "does not draw color", "--set 'one.sensors.camera.color=true'"});
  EXPECT_EQ(murosimf("run " + scene_.string() + " --no-cameras --duration 0.4 --record " + file("run.mcap")).exit_code,
            0);
  const Result result = murosimf("render " + file("run.mcap") + " " + options + " --inset one.camera" + out("b.png"));
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_TRUE(read_file(file("b.png")) == inset) << "the same of a recording, also if cameras were off then";
}

TEST_F(Render, TheSameCallGivesTheSamePicture) {
  for (const char* options : {"--size 120x70 --time 0.5 --view one", "--camera one.camera --time 0.5"}) {
    const std::string first = draw(options);
    EXPECT_EQ(draw(options), first);
    EXPECT_EQ(draw(options + std::string(" --threads 2")), first);
  }
}

TEST_F(Render, AVideoHasAllItsPictures) {
  if (!has_ffmpeg()) GTEST_SKIP() << "no ffmpeg here";
  const std::string film = draw("--size 65x41 --duration 0.4 --fps 20", "a.mp4");
  EXPECT_EQ(film.substr(4, 4), "ftyp");
  EXPECT_EQ(pictures_in_mp4(film), 8u);
  const std::string gif = draw("--size 65x41 --view one --duration 0.5 --fps 10", "a.gif");
  EXPECT_EQ(gif.substr(0, 4), "GIF8");
  EXPECT_EQ(static_cast<int>(gif.at(6)), 65);
  EXPECT_EQ(static_cast<int>(gif.at(8)), 41);
  EXPECT_EQ(pictures_in_gif(gif), 5);
  EXPECT_EQ(draw("--size 65x41 --view one --duration 0.5 --fps 10 --threads 2", "a.gif"), gif);
}

TEST_F(Render, AVideoThroughACameraShowsEachOfItsFramesOnce) {
  if (!has_ffmpeg()) GTEST_SKIP() << "no ffmpeg here";
  const std::string prompt = draw("--camera one.camera --duration 0.3", "a.gif");
  EXPECT_EQ(pictures_in_gif(prompt), 6) << "20 Hz";
  EXPECT_EQ(draw("--camera one.camera --duration 0.3 --set one.sensors.camera.delay=0.12", "a.gif"), prompt)
      << "frames that come late are the same frames";
}

TEST_F(Render, AVideoIsMadeOfARecordingAlone) {
  if (!has_ffmpeg()) GTEST_SKIP() << "no ffmpeg here";
  const std::string options = " --size 65x41 --view corner --time 0.1 --duration 0.4 --fps 10";
  const std::string live = draw(options, "a.gif");
  EXPECT_EQ(murosimf("run " + scene_.string() + " --duration 0.6 --record " + file("run.mcap")).exit_code, 0);
  fs::remove(scene_);
  const Result result = murosimf("render " + file("run.mcap") + options + video("b.gif"));
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(pictures_in_gif(live), 4);
  EXPECT_TRUE(read_file(file("b.gif")) == live) << "the pictures are the live ones";
}

/// [s] for which the first picture of a GIF is shown.
double seconds_of_first_picture(const std::string& gif) {
  const auto at = gif.find(std::string("\x21\xf9\x04", 3));
  if (at == std::string::npos) return 0;
  return 0.01 * (static_cast<std::uint8_t>(gif.at(at + 4)) + 256 * static_cast<std::uint8_t>(gif.at(at + 5)));
}

TEST_F(Render, SlowMotionHasMorePicturesOfTheSameTime) {
  if (!has_ffmpeg()) GTEST_SKIP() << "no ffmpeg here";
  const std::string slow = draw("--size 16x16 --duration 0.1 --fps 20 --slow 4", "a.gif");
  EXPECT_EQ(pictures_in_gif(slow), 8) << "one every 12.5 ms";
  EXPECT_EQ(seconds_of_first_picture(slow), 0.05);
  EXPECT_EQ(pictures_in_mp4(draw("--size 16x16 --duration 0.1 --fps 30 --slow 7", "a.mp4")), 21U);
  const std::string eye = draw("--camera one.camera --duration 0.3 --slow 4", "a.gif");
  EXPECT_EQ(pictures_in_gif(eye), 6) << "a camera has its own rate";
  EXPECT_EQ(seconds_of_first_picture(eye), 0.2);
}

TEST_F(Render, SlowMotionIsOfVideosAndOfAPossibleSpeed) {
  expect_refused("--slow 4" + out(), {"--slow requires --video"});
  for (const char* slow : {"0", "-1", "nan", "1e9"}) {
    expect_refused("--slow " + std::string(slow) + video("a.mp4"), {"--slow", "0.01 to 1000"});
  }
}

TEST_F(Render, ASheetIsPicturesInRows) {
  EXPECT_EQ(size_of_png(draw("--sheet 3x2 --size 60x40 --duration 0.5")), "180x80");
  EXPECT_NE(draw("--sheet 3x2 --size 60x40 --duration 0.5"), draw("--sheet 3x2 --size 60x40 --duration 1"));
  EXPECT_EQ(size_of_png(draw("--sheet 1x1 --duration 1")), "480x270");
}

TEST_F(Render, FollowsRobotsAndBall) {  // tests/scene/action_view_test.cpp
  std::set<std::string> pictures;
  for (const char* view : {"--follow one", "--follow ball", "--view one", "--view overview"}) {
    EXPECT_TRUE(pictures.insert(draw(std::string("--size 120x70 ") + view)).second) << view;
  }
  EXPECT_TRUE(pictures.contains(draw("--size 120x70 --follow one,ball"))) << "a ball that is near is there in any case";
}

TEST_F(Render, NamesWithColonsAndSpacesAreFiles) {
  if (!has_ffmpeg()) GTEST_SKIP() << "no ffmpeg here";
  const std::string name = "goal: one.gif";
  const Result result = murosimf(command("--size 16x16 --duration 0.1 --video '") + file(name) + "'");
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(files(), std::vector{name});
}

TEST_F(Render, AFileThatIsThereIsReplaced) {
  std::ofstream(file("a.png")) << "old";
  EXPECT_EQ(size_of_png(draw("--size 16x16")), "16x16");
}

TEST_F(Render, OfAFullDiskIsOneLine) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  expect_refused("--size 16x16 --out /dev/full", {"cannot write '/dev/full'"});
}

// The pixels are looked at by tests/oracle/recorded_pictures.py.
TEST_F(Render, DepthsAndLabelsAreNumbersForPrograms) {
  constexpr std::size_t bits = 24, color_type = 25;  // of the header (PNG specification, 11.2.2)
  for (const char* layer : {"depth", "labels"}) {
    const std::string png = draw("--size 120x70 --layer " + std::string(layer));
    EXPECT_EQ(png[bits], 16) << layer;
    EXPECT_EQ(png[color_type], 0) << layer << ": one channel";
  }
  const auto table = nlohmann::json::parse(table_);
  EXPECT_EQ(table["schema"], "murosimf/labels/1");
  EXPECT_EQ(table["labels"][2], (nlohmann::json{{"id", 2}, {"name", "line"}, {"kind", "scenery"}}));
  EXPECT_EQ(table["labels"][4], (nlohmann::json{{"id", 4}, {"name", "ball"}, {"kind", "ball"}}));
  EXPECT_EQ(table["labels"][5], (nlohmann::json{{"id", 5}, {"name", "one"}, {"kind", "robot"}}));
  expect_refused("--size 16x16 --layer depth --duration 0.1" + video("a.mp4"), {"a.mp4", "numbers", ".mkv"});
}

TEST_F(Render, SaysWhichLayersACameraDoesNotDraw) {
  expect_refused("--camera one.camera --layer labels" + out(),
                 {"--layer labels", "--set 'one.sensors.camera.labels=true'"});
  expect_refused("--camera one.camera --set one.sensors.camera.color=false" + out(),
                 {"--layer color", "--set 'one.sensors.camera.color=true'"});
}

TEST_F(Render, AnFfmpegThatDiesIsOneLineAndNoFile) {
  const std::string options = "--size 320x200 --duration 0.2" + video("a.mp4");
  const fs::path tools = scratch("tools");
  struct Death {
    const char *script, *words;
  };
  for (const Death& death :
       {Death{"head -c 1000 >/dev/null; echo no room left >&2; exit 1", "gave up: no room left"},
        Death{"head -c 1000 >/dev/null; exit 1", "gave up without a word"},
        Death{"cat >/dev/null; exit 1", "gave up without a word"},
        Death{"cat >/dev/null; kill -9 $$", "gave up without a word"}, Death{"cat >/dev/null", "cannot write"}}) {
    const EnvironmentVariable path("PATH", path_with_ffmpeg(tools, death.script));
    expect_refused(options, {death.words});
  }
}

TEST_F(Drawing, RefusesVideosWithoutFfmpegBeforeTheRun) {
  const EnvironmentVariable path("PATH", "/nowhere");
  expect_refused("--time 1e9" + video("a.mp4"), {"'ffmpeg'", "not installed", "--out FILE.png"});
}

TEST_F(Drawing, RefusesPlacesThatAreNotThere) {
  expect_refused("--view onw" + out(), {"unknown view 'onw'", "did you mean 'one'?"});
  expect_refused("--view nowhere" + out(), {"unknown view 'nowhere'", "overview", "corner"});
  expect_refused("--camera one.camra" + out(), {"--camera 'one.camra'", "did you mean 'camera'?"});
  expect_refused("--camera two.camera" + out(), {"--camera 'two.camera'", "unknown entity 'two'", "one"});
  expect_refused("--camera one" + out(), {"--camera 'one'", "write ROBOT.CAMERA, like one.camera"});
  expect_refused("--camera ball.camera" + out(), {"--camera 'ball.camera'", "no camera"});
  expect_refused("--camera one.camera --set one.sensors.camera=false" + out(), {"'one'", "no camera"});
  expect_refused("--view top --camera one.camera" + out(), {"either --view or --camera"});
}

TEST_F(Drawing, RefusesImpossibleSizesTimesAndNames) {
  for (const char* size :
       {"0x0", "100000x100000", "abc", "640", "640x", "x480", "-4x4", "640x480x3", "1e3x10", "8193x8"})
    expect_refused(std::string("--size ") + size + out(), {"--size '" + std::string(size) + "'", "WIDTHxHEIGHT"});
  expect_refused("--camera one.camera --size 64x48" + out(), {"--size", "--set 'one.sensors.camera.width=640'"});
  for (const char* time : {"-1", "nan", "inf", "1e300"})
    expect_refused(std::string("--time ") + time + out(), {"--time", "must be a number"});
  expect_refused("--time soon" + out(), {"--time", "soon"});
  expect_refused("--layer foo" + out(), {"--layer: unknown layer 'foo'", "labels"});
  expect_refused("--camera one.camera --layer foo" + out(), {"--layer: unknown layer 'foo'"});
  expect_refused("--light moon" + out(), {"--light: unknown light 'moon'", "night"});
  expect_refused("--light nigt" + out(), {"--light", "did you mean 'night'?"});
  expect_refused("--camera one.camera --no-shadows" + out(), {"--no-shadows", "--camera"});
  expect_refused("--set one.sensors.camera.width=0 --camera one.camera" + out(), {"'width' is 0", "1 to 8192 px"});
  expect_refused("--set one.sensors.camera.width=100000 --camera one.camera" + out(), {"'width' is 100000"});
}

TEST_F(Drawing, RefusesOutputsThatCannotBe) {
  expect_refused("", {"either --out FILE.png or --video FILE.mp4"});
  expect_refused(out() + video("a.mp4"), {"either --out FILE.png or --video FILE.mp4"});
  expect_refused("--time 1e9 --out /no/such/folder/a.png",
                 {"cannot write '/no/such/folder/a.png'", "there is no folder"});
  expect_refused("--time 1e9 --out /proc/a.png", {"cannot write '/proc/a.png'"});
  expect_refused("--time 1e9 --out " + folder().string(), {"write a name that ends with .png"});
  expect_refused("--time 1e9 --video /no/such/folder/a.mp4", {"/no/such/folder/a.mp4", "there is no folder"});
  expect_refused("--time 1e9" + video("film"), {"film", "its extension must say which kind", ".mp4"});
  expect_refused("--time 1e9" + video("film.txt"), {"film.txt", "its extension must say which kind", ".mp4"});
}

TEST_F(Drawing, RefusesOptionsOfVideosForPictures) {
  expect_refused("--fps 10" + out(), {"--fps", "--video"});
  expect_refused("--duration 1" + out(), {"--duration", "--time"});
  expect_refused("--sheet 3x2 --time 1e9" + video("a.mp4"), {"--sheet", "--out"});
  for (const char* sheet : {"3", "0x2", "axb", "3x2x1"})
    expect_refused(std::string("--time 1e9 --sheet ") + sheet + out(), {"--sheet", sheet, "COLUMNSxROWS"});
  expect_refused("--time 1e9 --sheet 200x2 --size 640x480" + out(), {"--sheet 200x2", "16384"});
  expect_refused("--time 1e9 --sheet 100x2" + out(), {"--sheet 100x2", "16384"});
  expect_refused("--time 1e9 --sheet 3x2 --layer depth" + out(), {"--sheet", "depth"});
  expect_refused("--time 1e9 --view top --follow one" + out(), {"--view", "--follow"});
  expect_refused("--follow ona" + out(), {"--follow", "ona", "did you mean 'one'?"});
  expect_refused("--fps 10 --camera one.camera" + video("a.mp4"), {"--fps", "--camera"});
  for (const char* rate : {"0", "-1", "241", "nan"})
    expect_refused(std::string("--fps ") + rate + video("a.mp4"), {"--fps", "must be from 1 to 240"});
  for (const char* duration : {"-1", "nan", "1e300"})
    expect_refused(std::string("--time 1e9 --duration ") + duration + video("a.mp4"), {"--duration", "must be"});
  expect_refused("--time 1e9 --duration 0" + video("a.mp4"), {"--duration 0", "needs some time"});
}

constexpr const char* no_device = "__EGL_VENDOR_LIBRARY_FILENAMES";

TEST_F(Drawing, ByOpenGlWithoutADeviceIsOneLineThatNamesPackages) {
  const EnvironmentVariable none(no_device, "/nonexistent"), opengl("MUROSIMF_RENDERER", "opengl");
  const std::vector<std::string> parts{"no pictures by OpenGL", "Debian and Ubuntu", "libegl"};
  expect_refused(out(), parts);
  if (has_ffmpeg()) expect_refused("--duration 0.1" + video("a.mp4"), parts);
}

TEST_F(Drawing, RefusesARendererThatIsUnknown) {
  const EnvironmentVariable other("MUROSIMF_RENDERER", "vulkan");
  expect_refused(out(), {"MUROSIMF_RENDERER=vulkan", "'opengl' or 'software'"});
}

TEST_F(Drawing, NeedsNoDevice) {
  const EnvironmentVariable own("MUROSIMF_RENDERER", "software");
  const std::string from_outside = draw("--size 160x90", "with.png");
  const std::string seen = draw("--camera one.camera", "camera_with.png");
  const EnvironmentVariable none(no_device, "/nonexistent"), any("MUROSIMF_RENDERER", "");
  EXPECT_EQ(draw("--size 160x90", "without.png"), from_outside);
  EXPECT_EQ(draw("--camera one.camera", "camera_without.png"), seen);
}

TEST_F(InFolder, WithoutOpenGlThatIsWantedTheRestOfRunAndCheckIsThere) {
  const EnvironmentVariable none(no_device, "/nonexistent"), opengl("MUROSIMF_RENDERER", "opengl");
  const std::vector<std::string> parts{"no pictures by OpenGL", "Debian and Ubuntu", "libegl"};
  expect_mistake("run walk --duration 1e9 --pictures " + file("pictures"), parts);
  const Result above = murosimf("run walk --duration 0.1 --picture " + file("above.png"));
  if (above.errors.find("cairo was missing") == std::string::npos) {
    EXPECT_EQ(above.exit_code, 0) << above.errors;
    EXPECT_EQ(read_file(folder() / "above.png").substr(1, 3), "PNG");
  }
  const Result plain = murosimf("check kid21");
  const Result result = murosimf("check kid21 --picture " + file("kid21.png"));
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.output, plain.output);
  EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
  for (const std::string& part : parts) EXPECT_NE(result.errors.find(part), std::string::npos) << result.errors;
  EXPECT_FALSE(fs::exists(folder() / "kid21.png"));
}

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

std::string state_hash(const Result& run) { return run.output.substr(run.output.find("state hash"), 28); }

TEST(RunWithCameras, IsTheSameWithoutADevice) {
  const Result expected = murosimf("run six_cameras --duration 0.1");
  const EnvironmentVariable none(no_device, "/nonexistent");
  for (const char* cameras : {"", " --no-cameras"}) {
    const Result run = murosimf(std::string("run six_cameras --duration 0.1") + cameras);
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    EXPECT_EQ(count(run.output, "warning:"), 0) << run.output;
    EXPECT_EQ(state_hash(run), state_hash(expected)) << cameras;
  }
}

std::string calibration(const std::string& fx, const std::string& k1) {
  return "image_width: 64\nimage_height: 48\ncamera_matrix:\n  rows: 3\n  cols: 3\n  data: [" + fx +
         ", 0, 32, 0, 40, 24, 0, 0, 1]\ndistortion_model: plumb_bob\n"
         "distortion_coefficients:\n  rows: 1\n  cols: 4\n  data: [" +
         k1 + ", 0, 0, 0]\n";
}

class Calibration : public Drawing {
 protected:
  void SetUp() override {
    Drawing::SetUp();
    if (murosimf("lens wolfgang_rory").errors.find("yaml-cpp was missing") != std::string::npos) {
      GTEST_SKIP() << "no yaml-cpp in this build";
    }
  }
  [[nodiscard]] std::string with(const fs::path& file) const {
    return scene_.string() + " --set 'one.sensors.camera.calibration=" + file.string() + "' ";
  }
};

TEST_F(Calibration, ThatIsWrongIsNamedWithItsLine) {
  struct Case {
    std::string name, text;
    std::vector<std::string> parts;
  };
  std::string no_height = calibration("40", "0"), no_model = calibration("40", "0");
  no_height.erase(no_height.find("image_height"), 17);
  no_model.erase(no_model.find("distortion_model"), 28);
  for (const Case& wrong : {Case{"height.yaml", no_height, {"height.yaml:1", "'image_height' is missing"}},
                            Case{"model.yaml", no_model, {"model.yaml:1", "'distortion_model' is missing"}},
                            Case{"zero.yaml", calibration("0", "0"), {"zero.yaml:4", "focal length fx is 0"}},
                            Case{"text.yaml", "no calibration at all", {"text.yaml"}}}) {
    const fs::path file = write(wrong.name, wrong.text);
    expect_mistake("run " + with(file), wrong.parts);
    expect_mistake("render " + with(file) + "--camera one.camera" + out(), wrong.parts);
    expect_mistake("lens " + file.string(), wrong.parts);
  }
  expect_mistake("run " + with("wolfgang_rary"), {"no file 'wolfgang_rary'", "lenses"});
  EXPECT_TRUE(files().empty());
}

TEST_F(Calibration, ThatFoldsOverIsNotedWithTheAngle) {
  const std::string diagnostic = "the distortion folds over at 39.2 deg, inside the picture";
  const fs::path fold = write("fold.yaml", calibration("40", "-0.5"));
  const Result run = murosimf("run " + with(fold) + "--duration 0.1");
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_EQ(count(run.output, diagnostic), 1) << run.output;
  EXPECT_NE(murosimf("lens " + fold.string()).output.find(diagnostic), std::string::npos);
  const Result good = murosimf("run " + with(write("good.yaml", calibration("40", "-0.1"))) + "--duration 0.1");
  EXPECT_EQ(count(good.output, "folds over"), 0) << good.output;
}

}  // namespace
}  // namespace murosimf::test
