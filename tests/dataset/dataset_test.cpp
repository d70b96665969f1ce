#include "murosimf/dataset/dataset.h"

#include <fstream>
#include <map>

#include <gtest/gtest.h>

#include "murosimf/dataset/jpeg_bytes.h"
#include "murosimf/model/error.h"
#include "tests/temp_folder.h"

namespace murosimf::dataset {
namespace {

constexpr const char* scene = "[ball]\n[[robots]]\nname = 'one'\nmodel = 'kid21'\n";
constexpr const char* ranges =
    "[picture]\nsamples = 1\nvalidation = 0.5\n[light]\npresets = ['plain']\n[robots]\nrecorded = 0\n";

/// Why no data set can be written here; empty: it can.
std::string trouble() {
  try {
    check_jpeg_bytes();
  } catch (const SetupError& error) {
    return error.what();
  }
  return "";
}

class DatasetFolder : public testing::Test {
 protected:
  void SetUp() override {
    if (const std::string why = trouble(); !why.empty()) GTEST_SKIP() << why;
    std::ofstream(temp_.path() / "scene.toml") << scene;
    std::ofstream(temp_.path() / "ranges.toml") << ranges;
  }
  [[nodiscard]] std::filesystem::path path(const std::string& name) const { return temp_.path() / name; }
  [[nodiscard]] Request request(const std::string& folder, std::uint64_t pictures, int threads) const {
    Request request{.folder = path(folder), .scene = path("scene.toml"), .randomisation = path("ranges.toml")};
    request.pictures = pictures;
    request.width = 64;
    request.height = 48;
    request.options.threads = threads;
    return request;
  }
  [[nodiscard]] std::map<std::string, std::string> contents(const std::string& folder) const {
    std::map<std::string, std::string> all;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path(folder))) {
      if (!entry.is_regular_file()) continue;
      std::ifstream stream(entry.path(), std::ios::binary);
      all[entry.path().lexically_relative(path(folder)).string()] =
          std::string(std::istreambuf_iterator<char>(stream), {});
    }
    return all;
  }
  static std::string error_of(const Request& request) {
    try {
      (void)write_dataset(request);
    } catch (const SetupError& error) {
      return error.what();
    }
    return "";
  }

 private:
  fixtures::TempFolder temp_;
};

TEST_F(DatasetFolder, ThreadsAndPiecesDoNotMatter) {
  EXPECT_TRUE(write_dataset(request("whole", 4, 1)).complete);
  // two pictures, of which one is lost; then the rest by two threads
  EXPECT_EQ(write_dataset(request("pieces", 2, 1)).drawn, 2U);
  std::filesystem::remove(path("pieces") / "frames/000000.json");
  const Outcome rest = write_dataset(request("pieces", 4, 2));
  EXPECT_EQ(rest.drawn, 3U);
  EXPECT_EQ(rest.already, 1U);
  const auto whole = contents("whole"), pieces = contents("pieces");
  EXPECT_EQ(whole.size(), 4 * 6 + 5U);  // color, depth, instances, classes, YOLO, frame of each; five of all
  for (const auto& [name, bytes] : whole) EXPECT_TRUE(pieces.contains(name) && pieces.at(name) == bytes) << name;
}

TEST_F(DatasetFolder, StopsWhenItIsToldToAndGoesOn) {
  Request stopping = request("stopped", 3, 1);
  std::uint64_t there = 0;
  stopping.progress = [&](std::uint64_t count) { there = count; };
  stopping.options.stop = [&] { return there >= 1; };
  EXPECT_FALSE(write_dataset(stopping).complete);
  EXPECT_FALSE(std::filesystem::exists(path("stopped") / "annotations.json"));
  stopping.options.stop = [] { return true; };
  const Outcome at_once = write_dataset(stopping);
  EXPECT_EQ(at_once.already, 1U);
  EXPECT_EQ(at_once.drawn, 0U);
  EXPECT_FALSE(at_once.complete);
  EXPECT_EQ(write_dataset(request("stopped", 3, 1)).already, 1U);
}

TEST_F(DatasetFolder, StoppedBeforeItsFirstPictureItCanBeContinued) {
  Request stopping = request("begun", 1, 1);
  stopping.options.stop = [] { return true; };
  EXPECT_EQ(write_dataset(stopping).already, 0U);
  EXPECT_TRUE(write_dataset(request("begun", 1, 1)).complete);
}

TEST_F(DatasetFolder, OtherContentsAreRefused) {
  std::filesystem::create_directory(path("full"));
  std::ofstream(path("full") / "thesis.tex") << "\n";
  EXPECT_NE(error_of(request("full", 1, 1)).find("is not empty, and no data set"), std::string::npos);
  EXPECT_NE(error_of(request("scene.toml", 1, 1)).find("there is a file of this name"), std::string::npos);
  ASSERT_TRUE(write_dataset(request("known", 2, 1)).complete);
  Request other = request("known", 2, 1);
  other.options.seed = 7;
  EXPECT_NE(error_of(other).find("'seed' was 1, not 7"), std::string::npos);
  other = request("known", 2, 1);
  other.options.pushes = {"ball=[5,0,0]@1..2"};
  EXPECT_NE(error_of(other).find(R"('push' was [], not ["ball=[5,0,0]@1..2"])"), std::string::npos) << error_of(other);
  other = request("known", 2, 1);
  other.options.events = {"1:one.command=[0.1,0,0]"};
  EXPECT_NE(error_of(other).find("'at' was []"), std::string::npos) << error_of(other);
  other = request("known", 2, 1);
  other.plugins = {"own.so"};
  EXPECT_NE(error_of(other).find("'plugins' was []"), std::string::npos) << error_of(other);
  EXPECT_NE(error_of(request("known", 1, 1)).find("has 2 pictures"), std::string::npos);
}

TEST_F(DatasetFolder, AnotherSceneFileOfTheSameNameIsRefused) {
  ASSERT_TRUE(write_dataset(request("known", 1, 1)).complete);
  std::ofstream(path("scene.toml"), std::ios::app) << "position = [1, 0]\n";
  EXPECT_NE(error_of(request("known", 1, 1)).find("'scene_text' was another one"), std::string::npos);
}

}  // namespace
}  // namespace murosimf::dataset
