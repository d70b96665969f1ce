#include "murosimf/dataset/folder.h"

#include <fstream>

#include <gtest/gtest.h>

#include "murosimf/dataset/manifest.h"
#include "murosimf/model/error.h"
#include "tests/temp_folder.h"

namespace murosimf::dataset {
namespace {

class DatasetFiles : public testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path path(const std::string& name) const { return temp_.path() / name; }
  void write(const std::string& name) const { std::ofstream(path(name)) << "\n"; }
  [[nodiscard]] bool has(const std::string& name) const { return std::filesystem::exists(path(name)); }

  fixtures::TempFolder temp_;
  Folder folder_{temp_.path(), "png", 0.5, 1};
};

TEST_F(DatasetFiles, OnlyHalvesOfItsOwnAreRemoved) {
  folder_.make(false);
  std::filesystem::create_directory(path("own"));
  for (const char* name : {"manifest.json.7.part", "frames/000001.json.123.part", "images/val/000001.png.5.part"})
    write(name);
  for (const char* name :
       {"own/000001.json.123.part", "frames/notes.part", "frames/notes.7a.part", "frames/000002.json"}) {
    write(name);
  }
  folder_.remove_parts();
  for (const char* name : {"manifest.json.7.part", "frames/000001.json.123.part", "images/val/000001.png.5.part"}) {
    EXPECT_FALSE(has(name)) << name;
  }
  for (const char* name :
       {"own/000001.json.123.part", "frames/notes.part", "frames/notes.7a.part", "frames/000002.json"}) {
    EXPECT_TRUE(has(name)) << name;
  }
}

TEST_F(DatasetFiles, MissingPicturesAreThoseWithoutFrames) {
  EXPECT_EQ(folder_.missing(2), (std::vector<std::uint64_t>{0, 1}));
  folder_.make(false);
  folder_.write(Folder::frame(1), "{}");
  EXPECT_EQ(folder_.missing(3), (std::vector<std::uint64_t>{0, 2}));
}

TEST_F(DatasetFiles, HalfAManifestAloneIsNoOtherContent) {
  write("manifest.json.99.part");
  EXPECT_NO_THROW(check_folder(temp_.path()));
  write("thesis.tex");
  EXPECT_THROW(check_folder(temp_.path()), SetupError);
  write("manifest.json");
  EXPECT_NO_THROW(check_folder(temp_.path()));
}

TEST_F(DatasetFiles, WhatCannotBeReplacedIsSaidWithTheReason) {
  std::filesystem::create_directory(path("manifest.json"));
  try {
    folder_.replace("manifest.json", "{}");
    FAIL() << "it is a folder";
  } catch (const SetupError& error) {
    EXPECT_NE(std::string(error.what()).find("manifest.json': it is a folder"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace murosimf::dataset
