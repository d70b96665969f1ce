/// data_path.h - finding scenes and models from any working directory.
#pragma once

#include <filesystem>
#include <string_view>

namespace murosimf::io {

/// The file that `name` means. Tried in this order: the name as it is; the name in `beside`; the name, alone and in
/// the folder `kind` ("models", "scenes"), in the folder that MUROSIMF_DATA names, in share/murosimf of the
/// installation, and in the source tree. Every place is tried with `extension` appended too. Throws SetupError.
[[nodiscard]] std::filesystem::path find_data_file(std::string_view name, std::string_view kind,
                                                   std::string_view extension,
                                                   const std::filesystem::path& beside = {});

}  // namespace murosimf::io
