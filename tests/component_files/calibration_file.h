/// calibration_file.h - a good calibration file, and the same with errors in it.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "murosimf/model/error.h"
#include "tests/temp_folder.h"

namespace murosimf::component_files {

struct CalibrationFile {
  std::string name;  ///< of the file that tests write
  std::string good;  ///< its text

  [[nodiscard]] std::filesystem::path write(const std::string& text) const {
    const std::filesystem::path file = fixtures::temp_folder() / name;
    std::ofstream(file) << text;
    return file;
  }
  /// The good text with one part in place of another.
  [[nodiscard]] std::string with(const std::string& old, const std::string& replacement) const {
    std::string text = good;
    const auto place = text.find(old);
    EXPECT_NE(place, std::string::npos) << old;
    return text.replace(place, old.size(), replacement);
  }
  /// The error of read(file) for a text, without the name of the folder.
  template <class Read>
  [[nodiscard]] std::string message(const std::string& text, const Read& read) const {
    try {
      static_cast<void>(read(write(text)));
    } catch (const SetupError& error) {
      const std::string said = error.what();
      const auto at = said.find(name);
      return at == std::string::npos ? said : said.substr(at);
    }
    return "nothing was thrown";
  }
};

}  // namespace murosimf::component_files
