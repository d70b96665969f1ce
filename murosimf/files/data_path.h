/// data_path.h - finds scenes, models and servos from any working directory.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace murosimf::files {

/// The folders of files that come with the program, in the order of the search: the one that MUROSIMF_DATA names,
/// share/murosimf beside the program, beside the shared library that is loaded, and of the installation, the source tree.
[[nodiscard]] std::vector<std::filesystem::path> data_folders();

/// The file of a name. Tried in this order: the name as it is; the name in `beside`; the name, alone and in the
/// folder `kind` ("lenses", "models", "parts", "scenes", "servos"), in the folder that MUROSIMF_DATA names, in
/// share/murosimf of the installation, and in the source tree. Every place is tried with `extension` appended too.
/// What may not be read (file_access.h) is not found. Throws SetupError.
[[nodiscard]] std::filesystem::path find_data_file(std::string_view name, std::string_view kind,
                                                   std::string_view extension,
                                                   const std::filesystem::path& beside = {});

/// The same; nothing if there is no such file.
[[nodiscard]] std::optional<std::filesystem::path> look_for_data_file(std::string_view name, std::string_view kind,
                                                                      std::string_view extension,
                                                                      const std::filesystem::path& beside = {});

/// The folders with files that come with the program, also those that do not exist.
[[nodiscard]] std::vector<std::filesystem::path> program_folders();

/// Names that can be used without a path: the files of a kind in the folders above, without extension, in alphabetical
/// order.
[[nodiscard]] std::vector<std::string> data_file_names(std::string_view kind, std::string_view extension);

}  // namespace murosimf::files
