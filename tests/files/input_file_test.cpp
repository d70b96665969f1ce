// Files that are opened for reading, and the errors of others.
#include "murosimf/files/input_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <functional>

#include "murosimf/component_files/camera_info.h"
#include "murosimf/files/csv_file.h"
#include "murosimf/files/xml_element.h"
#include "murosimf/identification/servo_log_reader.h"
#include "murosimf/model/error.h"
#include "murosimf/robot/robot_config.h"
#include "murosimf/robot_formats/mesh/mesh_file.h"
#include "tests/fixtures.h"
#include "tests/temp_folder.h"

namespace murosimf::files {
namespace {

namespace fs = std::filesystem;
using fixtures::error_of;
using fixtures::says;

class InputFile : public testing::Test {
 protected:
  InputFile() { fs::create_directories(folder_); }
  ~InputFile() override { fs::remove_all(folder_); }
  fs::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }
  /// A pipe without a writer.
  fs::path pipe(const std::string& name) const {
    const fs::path path = folder_ / name;
    EXPECT_EQ(::mkfifo(path.c_str(), 0600), 0);
    return path;
  }

  const fs::path folder_ = fixtures::temp_folder() / ("input_file_" + std::to_string(::getpid()));
};

TEST_F(InputFile, IsReadByteForByte) {
  const std::string bytes("a\0b\r\n\xff", 6);
  EXPECT_EQ(read_input_file(write("bytes", bytes), 6), bytes);
  EXPECT_EQ(read_input_file(write("empty", ""), 6), "");
  EXPECT_EQ(check_input_file(folder_ / "bytes", 6), 6U);
}

TEST_F(InputFile, IsRefusedForWhatItIs) {
  const auto complaint = [](const fs::path& file) { return error_of([&] { (void)read_input_file(file, 10); }); };
  EXPECT_TRUE(says(complaint(folder_ / "none"), {(folder_ / "none").string(), "there is no such file"}));
  EXPECT_TRUE(says(complaint(folder_), {"this is a folder"}));
  EXPECT_TRUE(says(complaint("/dev/zero"), {"/dev/zero: ", "no ordinary file"}));
  EXPECT_TRUE(says(complaint(pipe("fifo")), {"fifo: ", "no ordinary file"}));
  EXPECT_TRUE(says(complaint(write("large", "12345678901")), {"large: ", "too large"}));
  EXPECT_TRUE(says(complaint(std::string(5000, 'a')), {"cannot be read"}));
  EXPECT_TRUE(says(complaint("/proc/self/maps"), {"too large"})) << "it says that it has no bytes";
}

TEST_F(InputFile, IsTheOnlyKindThatAnyReaderOpens) {
  const std::vector<std::pair<std::string, std::function<void(const fs::path&)>>> readers{
      {".toml", [](const fs::path& file) { (void)robot::read_robot_config(file); }},
      {".xml", [](const fs::path& file) { (void)XmlFile(file); }},
      {".json", [](const fs::path& file) { (void)identification::read_servo_logs({file.string()}); }},
      {".csv", [](const fs::path& file) { (void)read_csv(file); }},
      {".stl", [](const fs::path& file) { (void)robot_formats::mesh::read_mesh_file(file); }},
      {".obj", [](const fs::path& file) { (void)robot_formats::mesh::read_mesh_file(file); }},
      {".dae", [](const fs::path& file) { (void)robot_formats::mesh::read_mesh_file(file); }},
      {".yaml", [](const fs::path& file) { (void)component_files::read_camera_info(file); }}};
  for (const auto& [extension, read] : readers) {
    const fs::path fifo = pipe("pipe" + extension);
    const std::string message = error_of([&] { read(fifo); });
    if (message.find("yaml-cpp") != std::string::npos) continue;  // a build without
    EXPECT_TRUE(says(message, {fifo.string(), "no ordinary file"})) << extension;
  }
}

}  // namespace
}  // namespace murosimf::files
