// Where calibrations are, with or without a reader for them.
#include "murosimf/components/camera_info.h"
#include "murosimf/files/data_path.h"

namespace murosimf::components {

std::filesystem::path find_lens_file(std::string_view name, const std::filesystem::path& beside) {
  return files::find_data_file(name, "lenses", ".yaml", beside);
}

std::vector<std::string> lens_names() { return files::data_file_names("lenses", ".yaml"); }

}  // namespace murosimf::components
