/// standard_output.h - results on standard output and in a JSON file.
#pragma once

#include <string>

#include "apps/command.h"

namespace murosimf::app {

/// Throws SetupError if standard output is closed or full; not after SIGHUP, when its reader is gone.
void write_standard_output(const std::string& text);

/// The option --json.
void add_json(const Command& command, std::string& json_file);

/// `json_file` as users give it: empty for none, "-" for standard output. To be called before anything is computed, so that
/// no result is lost. Throws SetupError as files::claim_output.
void check_json_file(const std::string& json_file);

/// `json` alone to standard output if the user asked for that there; else `text`, and `json` to the file if there is one.
/// Throws SetupError if one cannot be written; the other is.
void write_result(const std::string& json_file, const std::string& text, const std::string& json);

}  // namespace murosimf::app
