// `murosimf lens`: shows the calibration of a camera, and says it in the words of another lens model.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/command_line.h"
#include "apps/results.h"
#include "apps/standard_output.h"
#include "murosimf/component_files/camera_info.h"
#include "murosimf/files/file_roles.h"
#include "murosimf/files/output_file.h"
#include "murosimf/imaging/lens_fit.h"
#include "murosimf/math/scalar.h"
#include "murosimf/model/error.h"

namespace murosimf::app {
namespace {

struct LensOptions {
  std::string file;   ///< calibration (YAML), or the name of one that comes with the program
  std::string model;  ///< to convert it to; empty: no
  std::string out;    ///< calibration to write
};

void define(const Command& command, LensOptions& options) {
  command
      .add("file", options.file,
           "Calibration (YAML as ROS writes it, or Calib_Results.m), or the name of one that comes with the program")
      .required()
      .offers_list("lenses");
  command.add("--as", options.model,
              "Say it in the words of another lens model: perspective, plumb_bob, rational_polynomial, "
              "equidistant or ray_polynomial");
  command.add("--out", options.out, "Calibration to write (YAML)");
}

double degrees(double angle) { return angle * 180 / pi; }

std::string line(std::string_view what, const std::string& text) { return fmt::format("{:<14} {}\n", what, text); }

std::string text_of(const imaging::Lens& lens) {
  const imaging::LensSpec& spec = lens.spec();
  const auto [horizontal, vertical, diagonal] = lens.fov();
  std::string text = line("model", spec.model);
  text +=
      line("coefficients", spec.coefficients.empty() ? "none" : fmt::format("{}", fmt::join(spec.coefficients, " ")));
  text += line("picture", fmt::format("{} x {} px", spec.width, spec.height));
  text += line("focal length", fmt::format("{:.2f} x {:.2f} px", spec.fx, spec.fy));
  text += line("center", fmt::format("{:.2f}, {:.2f} px", spec.cx, spec.cy));
  if (spec.skew != 0) text += line("skew", fmt::format("{:.4g} px", spec.skew));
  text += line("field of view", fmt::format("horizontal {:.1f}, vertical {:.1f}, diagonal {:.1f} deg",
                                            degrees(horizontal), degrees(vertical), degrees(diagonal)));
  text += line("sees up to", fmt::format("{:.1f} deg from the axis, in the picture {:.1f} deg",
                                         degrees(lens.widest_angle()), degrees(lens.corner_angle())));
  if (const std::string diagnostic = lens.fold_warning(); !diagnostic.empty()) text += line("warning", diagnostic);
  return text;
}

std::string text_of(const imaging::LensFit& fit) {
  if (fit.largest_error == 0) return line("fit error", "none");
  return line("fit error", fmt::format("{:.2g} px, at most {:.2g} px at {:.0f}, {:.0f}", fit.usual_error,
                                       fit.largest_error, fit.where.u, fit.where.v));
}

int lens(const LensOptions& options) {
  if (!options.out.empty()) files::claim_output("--out", options.out);
  const auto file = component_files::find_lens_file(options.file);
  component_files::CameraCalibration info = component_files::read_calibration(file);
  const imaging::Lens read(info.lens);
  std::string text = line("calibration", info.name.empty() ? file.string() : info.name) + text_of(read);
  if (!options.model.empty()) {
    const imaging::LensFit fit = with_context(file.string(), [&] { return imaging::fit_lens(read, options.model); });
    text += fmt::format("\nas {}\n", options.model) + text_of(imaging::Lens(fit.spec)) + text_of(fit);
    info.lens = fit.spec;
  }
  Results results;
  if (!options.out.empty())
    results.write([&] { files::write_file(options.out, component_files::camera_info_yaml(info)); });
  write_standard_output(text);
  return results.exit_code(0);
}

}  // namespace

void add_lens(CommandLine& line) {
  line.add<LensOptions>("lens", "Show the calibration of a camera, or convert it", define, lens);
}

}  // namespace murosimf::app
