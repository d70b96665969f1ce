// Names of files as other systems write them.
#include "murosimf/files/file_spelling.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/temp_folder.h"

namespace murosimf::files {
namespace {

TEST(FileSpelling, DecodesPercentEscapes) {
  EXPECT_EQ(percent_decoded("my%20mesh%2Dlast%2d"), "my mesh-last-");
  EXPECT_EQ(percent_decoded("100%"), "100%");
  EXPECT_EQ(percent_decoded("50%2"), "50%2");
  EXPECT_EQ(percent_decoded("a%zzb%00c"), "a%zzb%00c");
}

TEST(FileSpelling, KnowsAddressesOfFiles) {
  EXPECT_EQ(path_of_address("file:///a/b.stl"), "/a/b.stl");
  EXPECT_EQ(path_of_address("file:/a/b.stl"), "/a/b.stl");
  EXPECT_EQ(path_of_address("FILE://localhost/a/b.stl"), "/a/b.stl");
  EXPECT_EQ(path_of_address("file://meshes/b.stl"), "meshes/b.stl");
  EXPECT_EQ(path_of_address("files/b.stl"), std::nullopt);
  EXPECT_EQ(after_scheme("package://p/b.stl", "package"), "p/b.stl");
  EXPECT_EQ(after_scheme("package.stl", "package"), std::nullopt);
}

TEST(FileSpelling, FindsWhatIsSpelledAsOnOtherSystems) {
  const auto folder = fixtures::temp_folder() / "file_spelling";
  std::filesystem::create_directories(folder / "My Meshes");
  const auto file = folder / "My Meshes" / "Leg%20.STL";
  std::ofstream(file) << "x";
  for (const char* name :
       {"My Meshes/Leg%20.STL", "My%20Meshes/Leg%2520.STL", "My Meshes\\Leg%20.STL", "my meshes/leg%20.stl"}) {
    EXPECT_EQ(find_spelled(folder, name), file) << name;
  }
  std::ofstream(folder / "My Meshes" / "leg%20.STL") << "y";
  EXPECT_EQ(find_spelled(folder, "My Meshes/LEG%20.stl"), std::nullopt) << "two files are called so";
  EXPECT_EQ(find_spelled(folder, "My Meshes/Leg%20.STL"), file);
  EXPECT_EQ(find_spelled(folder, "My Meshes"), std::nullopt) << "a folder is no file";
  EXPECT_EQ(find_spelled(folder, ""), std::nullopt);
}

}  // namespace
}  // namespace murosimf::files
