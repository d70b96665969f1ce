// The program `murosimf`: reads the command line and calls one of the commands.
#include <cstdio>

#include "apps/command_line.h"
#include "apps/error_output.h"
#include "apps/interruption.h"
#include "apps/plugin_commands.h"
#include "apps/processor.h"
#include "apps/scene_arguments.h"
#include "murosimf/catalog/algorithm_catalog.h"
#include "murosimf/control_software/python/python_interpreter.h"
#include "murosimf/files/file_roles.h"

// All commands, in the order of --help: apps/NAME.cpp defines add_NAME.
#define MUROSIMF_COMMANDS(COMMAND) \
  COMMAND(run)                     \
  COMMAND(view)                    \
  COMMAND(render)                  \
  COMMAND(highlights)              \
  COMMAND(plot)                    \
  COMMAND(replay)                  \
  COMMAND(rerun)                   \
  COMMAND(export)                  \
  COMMAND(repair)                  \
  COMMAND(branch)                  \
  COMMAND(sweep)                   \
  COMMAND(tune)                    \
  COMMAND(doctor)                  \
  COMMAND(compare)                 \
  COMMAND(check)                   \
  COMMAND(convert)                 \
  COMMAND(list)                    \
  COMMAND(bench)                   \
  COMMAND(fit_servo)               \
  COMMAND(replay_servo)            \
  COMMAND(fit_contact)             \
  COMMAND(fit_steps)               \
  COMMAND(lens)                    \
  COMMAND(completion)              \
  COMMAND(manual)

namespace murosimf::app {

#define MUROSIMF_DECLARE(name) void add_##name(CommandLine& line);
MUROSIMF_COMMANDS(MUROSIMF_DECLARE)
#undef MUROSIMF_DECLARE

namespace {

void add_commands(CommandLine& line) {
#define MUROSIMF_ADD(name) add_##name(line);
  MUROSIMF_COMMANDS(MUROSIMF_ADD)
#undef MUROSIMF_ADD
}

}  // namespace
}  // namespace murosimf::app

int main(int argc, char** argv) {
  using namespace murosimf::app;
  if (const char* missing = missing_instructions(instruction_sets())) {
    std::fprintf(
        stderr,
        "murosimf: this processor has no %s, for which the program was built; build it with -DMUROSIMF_NATIVE=OFF\n",
        missing);
    return user_error;
  }
  report_uncaught_exceptions();
  catch_signals();
  murosimf::control_software::end_python_calls_if(interrupted);
  const murosimf::files::FileRoles roles;
  try {
    CommandLine line;
    add_commands(line);
    load_plugins(CommandLine::leading_plugins(argc, argv));
    add_plugin_commands(line, murosimf::catalog::registries().commands);
    return end_of_program(line.run(argc, argv));
  } catch (...) {
    return end_of_program(exit_code_of_exception());
  }
}
