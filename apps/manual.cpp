// `murosimf man`: the manual page, made of the definition of the command line.
#include <fmt/format.h>

#include "apps/command_line.h"
#include "apps/standard_output.h"
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

std::string option_entry(const OptionText& option) {
  const std::string value = option.positional || !option.takes_value ? "" : " \\fIvalue\\fR";
  return fmt::format(".TP\n\\fB{}\\fR{}\n{}\n", roff(option.name), value, roff(option.meaning));
}

std::string command_section(const CommandText& command) {
  std::string text = fmt::format(".SS murosimf {}\n{}\n", roff(command.name), roff(command.meaning));
  for (const OptionText& option : command.options) text += option_entry(option);
  return text;
}

constexpr std::string_view what_else = R"(.SH ENVIRONMENT
.TP
\fBMUROSIMF_DATA\fR
A folder with scenes, models, parts, lenses and servos that goes before those of the program.
.TP
\fBMUROSIMF_PACKAGE_PATH\fR
Folders in which package:// names of URDF files are looked for, separated by colons.
.TP
\fBMUROSIMF_RENDERER\fR
software or opengl: what draws pictures for people. Without it a graphics card does if there is one, else the processor, with the same bits on every machine.
.TP
\fBMUROSIMF_SHARE_WAVES\fR
always: threads share all work from the first step on, also where that takes longer, as on a machine that is busy. Results stay the same.
.SH EXIT STATUS
0: all went well. 1: a robot has errors (check), a scene ends otherwise (doctor). 2: an error in the command line or a file, said in one line. 3: an error
of the program.
.SH EXAMPLES
.nf
murosimf run three_on_three \-\-picture field.png
murosimf run walk \-\-set walker.level=articulated_dynamics \-\-push 'walker.torso=[60,0,0]@2..2.1'
murosimf check robot.urdf
murosimf compare arm_swing \-\-entity robot
.fi
)";

std::string manual_page(const std::vector<CommandText>& commands) {
  std::string text = fmt::format(
      ".TH MUROSIMF 1 \"\" \"murosimf {}\" \"User Commands\"\n.SH NAME\nmurosimf \\- {}\n.SH SYNOPSIS\n"
      ".B murosimf\n\\fIcommand\\fR [\\fIoptions\\fR]\n.SH COMMANDS\n",
      version_number(), "teams of humanoid robots at exchangeable levels of physical detail");
  for (const CommandText& command : commands) text += command_section(command);
  return text + std::string(what_else);
}

}  // namespace

void add_manual(CommandLine& line) {
  line.add("man", "Write the manual page (roff): murosimf man | man -l -", [&line] {
    write_standard_output(manual_page(line.commands()));
    return 0;
  });
}

}  // namespace murosimf::app
