/// robot_formats.h - formats of robot files: names, how a file is recognized, and its reader.
///
/// A new format is one more line in robot_formats.cpp; programs and plug-ins add to the registry.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "murosimf/files/xml_schema.h"
#include "murosimf/model/registry.h"
#include "murosimf/robot_formats/reader_options.h"
#include "murosimf/robot_formats/robot_description.h"

namespace murosimf::robot {

struct RobotFormat {
  std::string name, meaning;
  std::string endings;  ///< of files, small letters: ".xml .urdf"
  std::string root;  ///< first element, by which XML files are recognized; empty: no XML, recognized by the extension
  /// Throws SetupError: file, line, error, correction.
  std::function<robot_formats::RobotDescription(const std::filesystem::path&, const robot_formats::ReaderOptions&)>
      read;
  /// For a format of XML: its elements and attributes, and their use (`murosimf list mjcf`); null: no list.
  const files::XmlVocabulary& (*words)() = nullptr;
};

[[nodiscard]] Registry<RobotFormat>& robot_format_registry();
/// The same, read-only.
[[nodiscard]] const Registry<RobotFormat>& robot_formats();

/// The format of a file. Throws SetupError with all known ones if it has none of them, or cannot be read.
[[nodiscard]] const RobotFormat& format_of(const std::filesystem::path& file);

/// The description that the reader of the file's format returns. Throws SetupError as the reader, and for options without meaning for the
/// format: body, xacro.
[[nodiscard]] robot_formats::RobotDescription read_description(const std::filesystem::path& file,
                                                               const robot_formats::ReaderOptions& options);

}  // namespace murosimf::robot
