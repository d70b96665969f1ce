#include "murosimf/recording/scratch_folder.h"

#include <cstdlib>
#include <string>
#include <system_error>

#include <fmt/format.h>

#include "murosimf/model/error.h"

namespace murosimf::recording {

ScratchFolder::ScratchFolder() {
  std::error_code error;
  const std::filesystem::path where = std::filesystem::temp_directory_path(error);
  std::string name = (where / "murosimf.XXXXXX").string();
  if (error || mkdtemp(name.data()) == nullptr) {
    throw SetupError(fmt::format("cannot make a folder for temporary files in '{}'", where.string()));
  }
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace murosimf::recording
