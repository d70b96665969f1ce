/// standard_output.h - writing results to standard output.
#pragma once

#include <string>

namespace murosimf::app {

/// Throws SetupError if standard output is closed or full.
void write_standard_output(const std::string& text);

}  // namespace murosimf::app
