/// mjcf_vocabulary.h - which elements and attributes of MJCF the reader knows, and what it does with the others.
///
/// Source: the XML reference of the MuJoCo documentation. Every element and attribute of a file is one of
///   used      the reader acts on it,
///   unused    it means nothing to this program (solver settings, textures): a note, once per kind,
///   refused   it would change the robot's motion and is not supported, or nobody knows it.
#pragma once

#include <string>
#include <vector>

#include "murosimf/io/xml_element.h"

namespace murosimf::io {

/// What the vocabulary has to say about a file; each entry is one line with file and line number.
struct VocabularyFindings {
  std::vector<std::string> notes;
  std::vector<std::string> refused;
};

[[nodiscard]] VocabularyFindings check_vocabulary(const XmlElement& root);

/// Tags of the actuators that the reader understands.
[[nodiscard]] bool is_actuator(std::string_view tag);

}  // namespace murosimf::io
