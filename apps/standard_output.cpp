#include "apps/standard_output.h"

#include <cerrno>
#include <cstdio>
#include <exception>
#include <system_error>

#include <fmt/format.h>

#include "apps/interruption.h"
#include "murosimf/files/file_roles.h"
#include "murosimf/files/output_file.h"
#include "murosimf/model/error.h"

namespace murosimf::app {

void write_standard_output(const std::string& text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if ((!written || std::fflush(stdout) != 0) && signal_name() != "SIGHUP") {
    throw SetupError(fmt::format("cannot write to standard output: {}", std::generic_category().message(errno)));
  }
}

void add_json(const Command& command, std::string& json_file) {
  command.add("--json", json_file, "Write JSON to this file, or to standard output with '-'");
}

void check_json_file(const std::string& json_file) {
  if (!json_file.empty() && json_file != "-") files::claim_output("--json", json_file);
}

void write_result(const std::string& json_file, const std::string& text, const std::string& json) {
  if (json_file == "-") return write_standard_output(json);
  std::exception_ptr trouble;  // the text is not lost with the file
  try {
    if (!json_file.empty()) files::write_file(json_file, json);
  } catch (const SetupError&) {
    trouble = std::current_exception();
  }
  write_standard_output(text);
  if (trouble) std::rethrow_exception(trouble);
}

}  // namespace murosimf::app
