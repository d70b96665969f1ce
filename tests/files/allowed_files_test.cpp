// Which files are read for those who ask over a network: none but those in the folders that a run was started with.
#include "murosimf/files/file_access.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "murosimf/files/data_path.h"
#include "murosimf/files/input_file.h"
#include "murosimf/model/error.h"
#include "tests/fixtures.h"
#include "tests/temp_folder.h"

namespace murosimf::files {
namespace {

namespace fs = std::filesystem;
using fixtures::error_of;
using fixtures::says;

/// inside/scene.toml, inside/deep/model.xml, inside/.hidden/key, outside/secret.toml, and ways from one to the other.
class Allowed : public testing::Test {
 protected:
  Allowed() {
    for (const char* folder : {"inside/deep", "inside/.hidden", "outside"}) fs::create_directories(root_ / folder);
    for (const char* file : {"inside/scene.toml", "inside/deep/model.xml", "inside/.hidden/key", "inside/.key",
                             "outside/secret.toml", "outside/named.toml", "inside_out"}) {
      std::ofstream(root_ / file) << file;
    }
    fs::create_symlink(root_ / "outside", root_ / "inside/way_out");
    fs::create_symlink(root_ / "outside/secret.toml", root_ / "inside/link.toml");
    fs::create_symlink(root_ / "inside/scene.toml", root_ / "inside/own_link.toml");
    fs::create_symlink(root_ / "inside", root_ / "other_name");
    fs::create_symlink("/dev/zero", root_ / "inside/device.toml");
  }
  ~Allowed() override { fs::remove_all(root_); }

  const fs::path root_ = fixtures::temp_folder() / "allowed";
};

TEST_F(Allowed, WhatLiesInTheFolders) {
  const AllowedFiles allowed({root_ / "inside", root_ / "none"}, {root_ / "outside/named.toml"});
  EXPECT_TRUE(allowed.allows(root_ / "inside/scene.toml"));
  EXPECT_TRUE(allowed.allows(root_ / "inside/deep/../deep/./model.xml"));
  EXPECT_TRUE(allowed.allows(root_ / "inside/not_there.toml"));
  EXPECT_TRUE(allowed.allows(root_ / "inside/own_link.toml"));
  EXPECT_TRUE(allowed.allows(root_ / "outside/named.toml"));
  for (const char* file : {"outside/secret.toml", "inside/../outside/secret.toml", "inside/way_out/secret.toml",
                           "inside/way_out/../outside/secret.toml", "inside/link.toml", "inside/.hidden/key",
                           "inside/.key", "inside_out", "inside", "none/x", "inside/device.toml"}) {
    EXPECT_FALSE(allowed.allows(root_ / file)) << file;
  }
  for (const char* file : {"", "/", "/dev/zero", "/proc/self/environ", "/etc/passwd", ".."}) {
    EXPECT_FALSE(allowed.allows(file)) << file;
  }
}

TEST_F(Allowed, NamesThatEndEarlierForTheSystemThanForUs) {
  const AllowedFiles allowed({root_ / "inside"});
  const std::string name = (root_ / "outside/secret.toml").string();
  EXPECT_FALSE(allowed.allows(name + std::string(1, '\0') + "/../../inside/scene.toml"));
  EXPECT_FALSE(allowed.allows((root_ / "inside/scene.toml").string() + "\n"));
  EXPECT_FALSE(allowed.allows(root_ / "inside" / std::string(5000, 'a')));
}

TEST_F(Allowed, FoldersByAnyOfTheirNames) {
  for (const char* name : {"inside/", "other_name", "inside/../inside", "inside/deep/.."}) {
    const AllowedFiles allowed({root_ / name});
    EXPECT_TRUE(allowed.allows(root_ / "inside/scene.toml")) << name;
    EXPECT_FALSE(allowed.allows(root_ / "outside/secret.toml")) << name;
  }
  EXPECT_TRUE(AllowedFiles({root_ / "other_name"}).allows(root_ / "other_name/scene.toml"));
}

// A file outside is neither found nor opened; its existence makes no difference.
TEST_F(Allowed, ConcernsWhoeverFindsAndOpensFiles) {
  const auto allowed = std::make_shared<const AllowedFiles>(std::vector{root_ / "inside"});
  const std::string secret = (root_ / "outside/secret.toml").string(), nothing = (root_ / "outside/nothing").string();
  EXPECT_EQ(find_data_file(secret, "scenes", ".toml"), secret);
  {
    const FileScope only({.only_from = allowed});
    EXPECT_EQ(find_data_file("scene", "scenes", ".toml", root_ / "inside"), root_ / "inside/scene.toml");
    EXPECT_EQ(look_for_data_file(secret, "scenes", ".toml"), std::nullopt);
    EXPECT_EQ(look_for_data_file("../outside/secret", "scenes", ".toml", root_ / "inside"), std::nullopt);
    EXPECT_FALSE(read_input_file(root_ / "inside/scene.toml", 100).empty());
    const auto complaint = [](const std::string& file) {
      const std::string text = error_of([&] { (void)read_input_file(file, 100); });
      return text.substr(text.find(": "));
    };
    EXPECT_EQ(complaint(secret), complaint(nothing));
    EXPECT_TRUE(says(complaint(secret), {"in none of the folders that may be read here"}));
    const FileScope no_more({});
    EXPECT_FALSE(may_be_read(secret)) << "what is inside widens nothing";
  }
  EXPECT_TRUE(may_be_read(secret));
}

}  // namespace
}  // namespace murosimf::files
