/// sdf_include.h - finds the model that the URI of an include refers to.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "murosimf/robot_formats/reader_options.h"

namespace murosimf::robot_formats::sdf {

/// Files and folders that `uri` may refer to in the file `from`, best first; they need not exist.
[[nodiscard]] std::vector<std::filesystem::path> include_places(const std::string& uri,
                                                                const std::filesystem::path& from,
                                                                const robot_formats::ReaderOptions& options);

/// The SDF file of a model at `place`: the file itself, or of a folder that of its `model.config`, of several versions the newest, else
/// `model.sdf`. Nothing if there is none.
[[nodiscard]] std::optional<std::filesystem::path> model_file(const std::filesystem::path& place);

}  // namespace murosimf::robot_formats::sdf
