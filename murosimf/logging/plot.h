/// plot.h - curves as PNG pictures, drawn by a gnuplot process.
///
///     logging::write_plot("fall.png", {.title = "Fall", .x_label = "time [s]",
///                                 .panels = {{.y_label = "height [m]", .curves = {{"ball", t, z}}}}});
///
/// Nothing that users wrote reaches a shell: the process is started directly and reads commands and data from its
/// standard input.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace murosimf::logging {

struct Curve {
  std::string name;          ///< in the legend; empty: not listed there
  std::vector<double> x, y;  ///< equally many; where one is not finite, the curve has a gap
};

/// One diagram. Panels and curves without a single point are left out.
struct Panel {
  std::string y_label;  ///< with unit: "height [m]"
  std::vector<Curve> curves;
  double y_at_least =
      0;  ///< the vertical axis reaches at least from minus this to this: noise stays small. 0: as data are
};

struct Plot {
  std::string title;
  std::string x_label;        ///< with unit
  std::vector<Panel> panels;  ///< one above the other
  int width = 900;            ///< [pixels] without the legends, which stand at the right
  int panel_height = 320;     ///< [pixels]; a panel whose legend is longer is higher
};

/// Throws SetupError if there is no gnuplot that starts. To be called before a long run whose result is to be drawn.
void check_gnuplot();

/// Draws `plot` to a PNG file, which is whole or not there at all. Every panel has its own legend; curves of the same place in
/// their panels look the same, and up to 35 in a panel are told apart by color and dashes. Throws SetupError if gnuplot is missing or fails, a curve has other than equally many x and y, there is
/// nothing to draw, or the file cannot be written.
void write_plot(const std::filesystem::path& file, const Plot& plot);

/// The commands and data that gnuplot gets.
[[nodiscard]] std::string gnuplot_script(const Plot& plot);

}  // namespace murosimf::logging
