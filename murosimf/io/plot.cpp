#include "murosimf/io/plot.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "murosimf/io/child_process.h"
#include "murosimf/io/output_file.h"
#include "murosimf/model/error.h"

namespace murosimf::io {
namespace {

const std::vector<std::string> gnuplot{"gnuplot", "-d", "-"};  // -d: no start-up files of the user

/// A text of gnuplot's in single quotes, where everything but the quote is taken as it is.
std::string as_text(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const bool control = static_cast<unsigned char>(c) < ' ';
    if (c == '\'') {
      result += "\u2019";  // the typographic apostrophe
    } else {
      result += control ? ' ' : c;
    }
  }
  return "'" + result + "'";
}

bool is_point(const Curve& curve, std::size_t i) { return std::isfinite(curve.x[i]) && std::isfinite(curve.y[i]); }

bool can_be_drawn(const Curve& curve) {
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    if (is_point(curve, i)) return true;
  }
  return false;
}

bool can_be_drawn(const Panel& panel) {
  return std::any_of(panel.curves.begin(), panel.curves.end(), [](const Curve& c) { return can_be_drawn(c); });
}

void check(const Plot& plot) {
  for (const Panel& panel : plot.panels) {
    for (const Curve& curve : panel.curves) {
      if (curve.x.size() == curve.y.size()) continue;
      throw SetupError(fmt::format("plot '{}', curve '{}': {} x and {} y; there must be equally many", plot.title,
                                   curve.name, curve.x.size(), curve.y.size()));
    }
  }
  if (std::none_of(plot.panels.begin(), plot.panels.end(), [](const Panel& p) { return can_be_drawn(p); })) {
    throw SetupError(fmt::format("plot '{}': there is nothing to draw", plot.title));
  }
}

std::string block_name(std::size_t panel, std::size_t curve) { return fmt::format("$data_{}_{}", panel, curve); }

void write_data(std::string& script, const std::string& block, const Curve& curve) {
  script += block + " << END\n";
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    // an empty line breaks the curve
    script += is_point(curve, i) ? fmt::format("{:.9g} {:.9g}\n", curve.x[i], curve.y[i]) : "\n";
  }
  script += "END\n";
}

/// Curves cover each other: the first ones are drawn wider.
std::string plot_command(const Panel& panel, std::size_t index) {
  std::vector<std::string> curves;
  for (std::size_t i = 0; i < panel.curves.size(); ++i) {
    const Curve& curve = panel.curves[i];
    if (!can_be_drawn(curve)) continue;
    const std::string title = curve.name.empty() ? "notitle" : "title " + as_text(curve.name);
    curves.push_back(fmt::format("{} using 1:2 with lines linewidth {} linecolor {} {}", block_name(index, i),
                                 i == 0 ? 3 : 2, i + 1, title));
  }
  return fmt::format("plot {}\n", fmt::join(curves, ", "));
}

/// The legend above holds for both.
bool same_names(const Panel& a, const Panel& b) {
  return std::equal(a.curves.begin(), a.curves.end(), b.curves.begin(), b.curves.end(),
                    [](const Curve& x, const Curve& y) { return x.name == y.name; });
}

void write_panel(std::string& script, const Panel& panel, std::size_t index) {
  const double least = panel.y_at_least;
  script += "set ylabel " + as_text(panel.y_label) + "\n";
  script += least > 0 ? fmt::format("set yrange [*<{:g}:{:g}<*]\n", -least, least) : "set yrange [*:*]\n";
  script += plot_command(panel, index);
}

}  // namespace

std::string gnuplot_script(const Plot& all) {
  Plot plot = all;
  std::erase_if(plot.panels, [](const Panel& panel) { return !can_be_drawn(panel); });
  std::string script = fmt::format("set terminal pngcairo noenhanced size {},{} font 'sans,11'\n", plot.width,
                                   plot.panel_height * static_cast<int>(plot.panels.size()) + 40);
  for (std::size_t p = 0; p < plot.panels.size(); ++p) {
    for (std::size_t i = 0; i < plot.panels[p].curves.size(); ++i) {
      write_data(script, block_name(p, i), plot.panels[p].curves[i]);
    }
  }
  script += "set grid linecolor rgb '#d0d0d0'\nset lmargin 12\nset key outside top center horizontal\n";
  script += fmt::format("set multiplot layout {},1\nset title {}\n", plot.panels.size(), as_text(plot.title));
  for (std::size_t p = 0; p < plot.panels.size(); ++p) {
    if (p > 0 && same_names(plot.panels[p], plot.panels[0])) script += "unset key\n";
    if (p > 0 && !same_names(plot.panels[p], plot.panels[0])) script += "set key outside top center horizontal\n";
    if (p + 1 == plot.panels.size()) script += "set xlabel " + as_text(plot.x_label) + "\n";
    write_panel(script, plot.panels[p], p);
    script += "unset title\n";
  }
  return script + "unset multiplot\n";
}

void check_gnuplot() {
  const auto result = run_process({gnuplot[0], "--version"}, {});
  if (result && result->exit_code == 0) return;
  throw SetupError("plots need the program gnuplot, which does not start here (Debian and Ubuntu: gnuplot-nox)");
}

void write_plot(const std::filesystem::path& file, const Plot& plot) {
  check(plot);
  check_writable(file);
  const auto result = run_process(gnuplot, gnuplot_script(plot));
  if (!result) check_gnuplot();
  const bool is_png = result && result->output.starts_with("\x89PNG");
  if (!is_png || result->exit_code != 0) {
    std::string reason = result ? result->errors : std::string{};
    for (char& c : reason) c = c == '\n' ? ' ' : c;
    throw SetupError(fmt::format("cannot draw '{}': gnuplot says: {}", file.string(), reason));
  }
  write_file(file, result->output);
}

}  // namespace murosimf::io
