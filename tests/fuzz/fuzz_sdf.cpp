// Robot files of Gazebo, up to where libsdformat resolves their frames in a process of its own; fuzz.mutations goes all the way.
#include "murosimf/robot_formats/sdf/sdf_parts.h"
#include "murosimf/robot_formats/sdf/sdf_schema.h"
#include "tests/fuzz/fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace murosimf;
  fuzz::feed(data, size, ".sdf", [](const auto& file) {
    robot_formats::RobotDescription description;
    robot_formats::ReaderOptions options;
    robot_formats::urdf::UrdfLog log(description, false);
    const robot_formats::sdf::SdfFile parts(file, options, log);
    for (const files::XmlElement& root : parts.roots()) {
      (void)files::validate(root, robot_formats::sdf::sdf_schema(), true, description.warnings,
                            files::UnknownWords::named);
    }
  });
  return 0;
}
