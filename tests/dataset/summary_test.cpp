#include "murosimf/dataset/summary.h"

#include <fstream>

#include <gtest/gtest.h>

#include "murosimf/model/error.h"
#include "tests/temp_folder.h"

namespace murosimf::dataset {
namespace {

const std::vector<Category> categories{{class_ball, "ball", {"center"}}, {class_ground, "ground", {}}};

class Summary : public testing::Test {
 protected:
  /// Of a data set of one picture, whose file is this; empty: there is none.
  std::string error_of(const std::string& frame) const {
    const Folder folder(folder_.path(), "png", 0, 1);
    folder.make(false);
    std::ofstream(file("frames/000000.json")) << frame;
    try {
      write_summary(folder, categories, 1);
    } catch (const SetupError& error) {
      return error.what();
    }
    return "";
  }
  [[nodiscard]] std::filesystem::path file(const std::string& name) const { return folder_.path() / name; }

  fixtures::TempFolder folder_;
};

TEST_F(Summary, IsOfAllPictures) {
  EXPECT_EQ(error_of(R"({"image":{"id":1,"part":"val"},"annotations":[{"category_id":1}]})"), "");
  for (const char* name : {"annotations.json", "annotations_train.json", "annotations_val.json", "data.yaml"}) {
    EXPECT_TRUE(std::filesystem::exists(file(name))) << name;
  }
  EXPECT_GT(std::filesystem::file_size(file("annotations_val.json")),
            std::filesystem::file_size(file("annotations_train.json")));
}

TEST_F(Summary, AFrameOfAnotherFormIsRefused) {
  for (const char* frame :
       {"", "[]", "{}", R"({"image":1,"annotations":[]})", R"({"image":{},"annotations":[]})",
        R"({"image":{"id":1,"part":2},"annotations":[]})", R"({"image":{"id":1,"part":"val"},"annotations":{}})",
        R"({"image":{"id":1,"part":"val"},"annotations":[1]})"}) {
    EXPECT_NE(error_of(frame).find("000000.json: this is no picture's file of a data set"), std::string::npos) << frame;
  }
}

}  // namespace
}  // namespace murosimf::dataset
