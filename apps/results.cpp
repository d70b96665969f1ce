#include "apps/results.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "murosimf/files/file_roles.h"
#include "murosimf/files/lower_case.h"
#include "murosimf/files/output_place.h"

namespace murosimf::app {

void claim_picture(const std::string& option, const std::string& file) {
  const std::string ending = files::lower_case(std::filesystem::path(file).extension().string());
  if (!ending.empty() && ending != ".png" && files::OutputPlace(file).is_replaced()) {
    throw SetupError(fmt::format("{} '{}': pictures are PNG files; write a name that ends with .png", option, file));
  }
  files::claim_output(option, file);
}

}  // namespace murosimf::app
