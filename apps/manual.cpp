// `murosimf man`: the manual page, made of the definition of the command line.
#include <fmt/format.h>

#include "apps/command_line.h"
#include "apps/version.h"

namespace murosimf::app {
namespace {

/// Nothing in it means anything to roff.
std::string roff(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\') {
      result += "\\\\";
    } else if (c == '-') {
      result += "\\-";
    } else if ((c == '.' || c == '\'') && (result.empty() || result.back() == '\n')) {
      result += std::string("\\&") + c;
    } else {
      result += c;
    }
  }
  return result;
}

std::string option_entry(const CLI::Option& option) {
  if (option.get_lnames().empty() && !option.get_positional()) return {};
  const std::string name = option.get_positional() ? option.get_name(true) : "--" + option.get_lnames().front();
  const bool flag = !option.get_positional() && option.get_items_expected_max() == 0;
  const std::string value = option.get_positional() || flag ? "" : " \\fIvalue\\fR";
  return fmt::format(".TP\n\\fB{}\\fR{}\n{}\n", roff(name), value, roff(option.get_description()));
}

std::string command_section(const CLI::App& command) {
  std::string text = fmt::format(".SS murosimf {}\n{}\n", roff(command.get_name()), roff(command.get_description()));
  for (const CLI::Option* option : command.get_options()) text += option_entry(*option);
  return text;
}

constexpr std::string_view what_else = R"(.SH ENVIRONMENT
.TP
\fBMUROSIMF_DATA\fR
A folder with scenes, models, parts, lenses and servos that goes before those of the program.
.TP
\fBMUROSIMF_PACKAGE_PATH\fR
Folders in which package:// names of URDF files are looked for, separated by colons.
.SH EXIT STATUS
0: all went well. 1: a robot has errors (check). 2: a mistake in the command line or a file, said in one line. 3: a mistake
of the program.
.SH EXAMPLES
.nf
murosimf run three_on_three \-\-picture field.png
murosimf run walk \-\-set walker.level=articulated_dynamics \-\-push 'walker.torso=[60,0,0]@2..2.1'
murosimf check robot.urdf
murosimf compare arm_swing \-\-entity robot
.fi
)";

}  // namespace

std::string manual_page(const CLI::App& app) {
  std::string text = fmt::format(
      ".TH MUROSIMF 1 \"\" \"murosimf {}\" \"User Commands\"\n.SH NAME\nmurosimf \\- {}\n.SH SYNOPSIS\n"
      ".B murosimf\n\\fIcommand\\fR [\\fIoptions\\fR]\n.SH COMMANDS\n",
      version_number(), "teams of humanoid robots at exchangeable levels of physical detail");
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    text += command_section(*command);
  }
  return text + std::string(what_else);
}

}  // namespace murosimf::app
