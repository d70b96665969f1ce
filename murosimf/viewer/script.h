/// script.h - a session as a file: simulated keys, clicks and drags, waits, pictures. For tests and for documents.
///
///     wait 0.5                    # seconds of wall time
///     until 2                     # until simulated time has reached 2 s
///     settle                      # until all requests are completed
///     key Ctrl+P                  # a key, with modifiers
///     click 400 300               # a pixel of the window
///     click blue1                 # an entity, or an object of it (blue1.head), at its place in the picture
///     double blue1                # clicks twice, which selects
///     press Reset                 # a button, field or row of a panel, by its label
///     drag ball 1 0.5             # with Shift: moves it to x, y [m] on the field
///     push blue1.torso 0 0.3 0    # with Ctrl and the right button: pulls by x, y, z [m] in the world
///     twist blue1.torso 0 0.3 0   # with Ctrl and the left button: the same turns it
///     type 0.25                   # text into the field that has the focus, then Enter
///     scrub 1.5                   # drags on the timeline to 1.5 s
///     look 30 0.3 4               # free view: azimuth [deg], elevation [rad], distance [m] from the selected entity
///     screenshot field.png
///     say text                    # prints a line
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace murosimf::viewer {

struct ScriptStep {
  enum class Kind {
    wait,
    until,
    settle,
    key,
    click,
    double_click,
    press,
    drag,
    push,
    twist,
    type,
    scrub,
    look,
    screenshot,
    say
  };
  Kind kind = Kind::wait;
  std::string text;             ///< key, name, file, or text to type
  std::vector<double> numbers;  ///< as above
  std::string where;            ///< "session.txt:3"
};

/// Throws SetupError with file and line.
[[nodiscard]] std::vector<ScriptStep> read_script(const std::filesystem::path& file);
/// The same for a text; `name` is used in errors.
[[nodiscard]] std::vector<ScriptStep> parse_script(std::string_view text, const std::string& name);

}  // namespace murosimf::viewer
