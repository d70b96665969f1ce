/// plot.h - curves as PNG pictures, drawn by a gnuplot process.
///
///     logging::write_plot("fall.png", {.title = "Fall", .x_label = "time [s]",
///                                 .panels = {{.y_label = "height [m]", .curves = {{"ball", t, z}}}}});
///
/// User input never reaches a shell: the process is started directly and reads commands and data from its
/// standard input.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace murosimf::logging {

struct Curve {
  std::string name;          ///< for the legend; empty: not listed there
  std::vector<double> x, y;  ///< of equal length; the curve has a gap at values that are not finite
};

/// One diagram. Panels and curves without a single point are left out.
struct Panel {
  std::string y_label;  ///< with unit: "height [m]"
  std::vector<Curve> curves;
  double y_at_least =
      0;  ///< the vertical axis covers at least minus this to this, so that noise stays small. 0: range of the data
};

struct Plot {
  std::string title;
  std::string x_label;        ///< with unit
  std::vector<Panel> panels;  ///< one above the other
  int width = 900;            ///< [pixels] without the legends at the right
  int panel_height = 320;     ///< [pixels]; a panel with a longer legend is higher
};

/// Throws SetupError if gnuplot does not start. Call before a long run with a plotted result.
void check_gnuplot();

/// Draws `plot` to a PNG file, which is complete or absent. Every panel has its own legend; curves at the same position in
/// their panels look the same, and up to 35 in a panel are distinguished by color and dashes. Throws SetupError if gnuplot is missing or fails, x and y of a curve differ in length, there is
/// nothing to draw, or the file cannot be written.
void write_plot(const std::filesystem::path& file, const Plot& plot);

/// The commands and data for gnuplot.
[[nodiscard]] std::string gnuplot_script(const Plot& plot);

}  // namespace murosimf::logging
