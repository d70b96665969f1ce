/// folder.h - tests in which the program writes files: each has a folder of its own for them, and nothing else is in it.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/temp_folder.h"

namespace murosimf::test {

class InFolder : public testing::Test {
 protected:
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_.path(); }
  [[nodiscard]] std::string file(const std::string& name) const { return (folder() / name).string(); }
  /// Names of all that is there, sorted.
  [[nodiscard]] std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder())) names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
  }

 private:
  fixtures::TempFolder folder_;
};

}  // namespace murosimf::test
