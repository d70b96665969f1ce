/// robot_formats.h - formats of robot files: names, how a file shows which it has, and who reads it.
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
  std::string root;     ///< first element, which tells the format of XML files; empty: no XML, the ending tells it
  /// Throws SetupError: file, line, what is wrong, what to do.
  std::function<robot_formats::RobotDescription(const std::filesystem::path&, const robot_formats::ReaderOptions&)>
      read;
  /// Of a format of XML: its elements and attributes, and what becomes of each (`murosimf list mjcf`); null: no list.
  const files::XmlVocabulary& (*words)() = nullptr;
};

[[nodiscard]] Registry<RobotFormat>& robot_format_registry();
/// The same to read.
[[nodiscard]] const Registry<RobotFormat>& robot_formats();

/// The format of a file. Throws SetupError with all known ones if it is none of them, or the file cannot be read.
[[nodiscard]] const RobotFormat& format_of(const std::filesystem::path& file);

/// What the reader of the file's format makes of it. Throws SetupError as that does, and for options that mean nothing to the format: body,
/// xacro.
[[nodiscard]] robot_formats::RobotDescription read_description(const std::filesystem::path& file,
                                                               const robot_formats::ReaderOptions& options);

}  // namespace murosimf::robot
