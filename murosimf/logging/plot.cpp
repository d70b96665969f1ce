#include "murosimf/logging/plot.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "murosimf/files/child_process.h"
#include "murosimf/files/output_file.h"
#include "murosimf/math/assert.h"
#include "murosimf/model/error.h"

namespace murosimf::logging {
namespace {

const std::vector<std::string> gnuplot{"gnuplot", "-d", "-"};  // -d: no start-up files of the user

/// A single-quoted text of gnuplot, in which everything but the quote is literal.
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
  MUROSIMF_ASSERT(curve.x.size() == curve.y.size());
  script += block + " << END\n";
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    // an empty line breaks the curve
    script += is_point(curve, i) ? fmt::format("{:.9g} {:.9g}\n", curve.x[i], curve.y[i]) : "\n";
  }
  script += "END\n";
}

// Seven colors that most people tell apart (Wong, Points of view: color blindness, Nature Methods 8, 2011; black last), by
// five kinds of dashes.
constexpr std::array plot_colors{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000"};
constexpr std::array plot_dashes{"1", "(12,5)", "(3,3)", "(14,4,3,4)", "(24,6)"};

// Sizes in pixels of text in the font below.
constexpr int letter = 7, legend_row = 17, legend_sample = 60, title_height = 40;
constexpr std::size_t longest_name = 60;  // letters

/// Keeps the beginning and the end of a long name.
std::string shortened(const std::string& name) {
  if (name.size() <= longest_name) return name;
  return name.substr(0, longest_name / 2) + "..." + name.substr(name.size() - longest_name / 2 + 3);
}

std::string style_of(const Panel& panel, std::size_t i) {
  // curves cover each other: of a few, the first one is drawn wider
  const double width = i == 0 && panel.curves.size() <= 4 ? 3 : 2;
  return fmt::format("linewidth {} linecolor rgb '{}' dashtype {}", width, plot_colors[i % plot_colors.size()],
                     plot_dashes[i / plot_colors.size() % plot_dashes.size()]);
}

std::string plot_command(const Panel& panel, std::size_t index) {
  std::vector<std::string> curves;
  for (std::size_t i = 0; i < panel.curves.size(); ++i) {
    const Curve& curve = panel.curves[i];
    if (!can_be_drawn(curve)) continue;
    const std::string title = curve.name.empty() ? "notitle" : "title " + as_text(shortened(curve.name));
    curves.push_back(fmt::format("{} using 1:2 with lines {} {}", block_name(index, i), style_of(panel, i), title));
  }
  return fmt::format("plot {}\n", fmt::join(curves, ", "));
}

int rows_in_legend(const Panel& panel) {
  return static_cast<int>(
      std::ranges::count_if(panel.curves, [](const Curve& c) { return !c.name.empty() && can_be_drawn(c); }));
}

/// Height of a panel, including its legend.
int height_of(const Plot& plot, const Panel& panel) {
  return std::max(plot.panel_height, legend_row * rows_in_legend(panel) + 100);
}

/// Width at the right for the widest legend, the same in all panels.
int legend_width(const Plot& plot) {
  std::size_t longest = 0;
  for (const Panel& panel : plot.panels) {
    for (const Curve& curve : panel.curves) longest = std::max(longest, shortened(curve.name).size());
  }
  return longest == 0 ? 0 : legend_sample + letter * static_cast<int>(longest);
}

/// Breaks a text into lines of at most `most` letters, after a dot or at a space; a longer word is a line of its own.
std::vector<std::string> broken(const std::string& text, std::size_t most) {
  std::vector<std::string> words{""}, lines{""};
  for (const char c : text) {
    words.back() += c;
    if (c == ' ' || c == '.') words.emplace_back();
  }
  for (const std::string& word : words) {
    if (!lines.back().empty() && lines.back().size() + word.size() > most) lines.emplace_back();
    lines.back() += word;
  }
  return lines;
}

/// A text of several lines.
std::string as_lines(const std::vector<std::string>& lines) {
  std::string result;
  for (const std::string& line : lines) result += (result.empty() ? "" : ".\"\\n\".") + as_text(line);
  return result;
}

void write_panel(std::string& script, const Panel& panel, std::size_t index, int height) {
  const double least = panel.y_at_least;
  const auto letters = static_cast<std::size_t>((height - 60) / letter);
  script += "set ylabel " + as_lines(broken(panel.y_label, letters)) + "\n";
  script += least > 0 ? fmt::format("set yrange [*<{:g}:{:g}<*]\n", -least, least) : "set yrange [*:*]\n";
  script += plot_command(panel, index);
}

/// Places the panels one above the other, each as high as required.
void write_panels(std::string& script, const Plot& plot, int height) {
  int top = height - title_height;
  for (std::size_t p = 0; p < plot.panels.size(); ++p) {
    const int own = height_of(plot, plot.panels[p]);
    top -= own;
    script += fmt::format("set origin 0,{:.6g}\nset size 1,{:.6g}\n", static_cast<double>(top) / height,
                          static_cast<double>(own) / height);
    if (p + 1 == plot.panels.size()) script += "set xlabel " + as_text(plot.x_label) + "\n";
    write_panel(script, plot.panels[p], p, own);
  }
}

}  // namespace

/// Panels without a curve are left out: gnuplot refuses an empty plot.
std::string gnuplot_script(const Plot& all) {
  Plot plot = all;
  std::erase_if(plot.panels, [](const Panel& panel) { return !can_be_drawn(panel); });
  const int legend = legend_width(plot);
  int height = title_height;
  for (const Panel& panel : plot.panels) height += height_of(plot, panel);
  std::string script = fmt::format("set terminal pngcairo noenhanced size {},{} font 'sans,11' background '#ffffff'\n",
                                   plot.width + legend, height);
  for (std::size_t p = 0; p < plot.panels.size(); ++p) {
    for (std::size_t i = 0; i < plot.panels[p].curves.size(); ++i) {
      write_data(script, block_name(p, i), plot.panels[p].curves[i]);
    }
  }
  script += "set grid linetype 1 linewidth 1 linecolor rgb '#c8c8c8'\n";
  script += fmt::format("set lmargin 14\nset rmargin {}\n", legend > 0 ? legend / letter + 3 : 3);
  script += "set key at graph 1.02, graph 1 left top vertical Left reverse samplen 4 noautotitle maxrows 64\n";
  script += fmt::format("set multiplot title {}\n", as_text(plot.title));
  write_panels(script, plot, height);
  return script + "unset multiplot\n";
}

void check_gnuplot() {
  const auto result = files::run_process({gnuplot[0], "--version"}, {});
  if (result && result->exit_code == 0) return;
  throw SetupError("plots need the program gnuplot, which does not start here (Debian and Ubuntu: gnuplot-nox)");
}

/// The picture comes through gnuplot's output: a failed run leaves no part of a file.
void write_plot(const std::filesystem::path& file, const Plot& plot) {
  check(plot);
  files::check_writable(file);
  const auto result = files::run_process(gnuplot, gnuplot_script(plot));
  if (!result) check_gnuplot();
  const bool is_png = result && result->output.starts_with("\x89PNG");
  if (!is_png || result->exit_code != 0) {
    std::string reason = result ? result->errors : std::string{};
    for (char& c : reason) c = c == '\n' ? ' ' : c;
    throw SetupError(fmt::format("cannot draw '{}': gnuplot says: {}", file.string(), reason));
  }
  files::write_file(file, result->output);
}

}  // namespace murosimf::logging
